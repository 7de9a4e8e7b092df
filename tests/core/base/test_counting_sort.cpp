#include "base/counting_sort.hpp"

#include <doctest/doctest.h>

using namespace undergrowth;

TEST_CASE("a counting sort preserves the order of equal keys") {
	const std::vector<int> tens = { 31, 12, 39, 10, 35, 19 };
	CHECK(counting_sort(tens, 4, [](int entry) { return entry / 10; }) == std::vector<int>{ 12, 10, 19, 31, 39, 35 });
}

TEST_CASE("sorting by a lower and then by a higher digit sorts by both") {
	std::vector<int> numbers = { 4095, 0, 77, 4032, 64, 63, 1000, 63 };
	numbers = counting_sort(numbers, 64, [](int entry) { return entry % 64; });
	numbers = counting_sort(numbers, 64, [](int entry) { return entry / 64; });
	CHECK(numbers == std::vector<int>{ 0, 63, 63, 64, 77, 1000, 4032, 4095 });
}

TEST_CASE("an empty list is sorted to an empty list") {
	CHECK(counting_sort({}, 3, [](int entry) { return entry; }).empty());
}
