#include "base/shared_until_written.hpp"

#include <doctest/doctest.h>

#include <thread>
#include <utility>
#include <vector>

using namespace undergrowth;

namespace {

using Numbers = SharedUntilWritten<std::vector<int>>;

} // namespace

TEST_CASE("a written copy has its own value from then on") {
	Numbers one;
	one.own().push_back(1);
	const std::vector<int> *first = &*one;
	one.own().push_back(2);
	CHECK(&*one == first); // It is not shared, so it is not copied.
	Numbers copy = one;
	CHECK(&*copy == first);
	one.own().push_back(3);
	CHECK(*copy == std::vector<int>{ 1, 2 });
	CHECK(*one == std::vector<int>{ 1, 2, 3 });
	copy.own().clear();
	CHECK(one->size() == 3);
}

TEST_CASE("a moved value stays shared with the same copies") {
	Numbers one;
	one.own() = { 1 };
	Numbers moved = std::move(one);
	const std::vector<int> *there = &*moved;
	moved.own().push_back(2);
	CHECK(&*moved == there);
	const Numbers copy = moved;
	Numbers again = std::move(moved);
	again.own().push_back(3);
	CHECK(copy->size() == 2);
	Numbers assigned;
	assigned = copy;
	assigned.own().push_back(4);
	CHECK(copy->size() == 2);
}

TEST_CASE("other threads can read and delete copies during a write") {
	static constexpr int ROUNDS = 200;
	Numbers one;
	one.own() = std::vector<int>(100, 0);
	std::vector<std::thread> readers;
	for (int round = 0; round < ROUNDS; round++) {
		readers.emplace_back([copy = one, round] {
			for (const int number : *copy) {
				if (number != round) {
					throw number; // Ends the program.
				}
			}
		});
		for (int &number : one.own()) {
			number = round + 1;
		}
	}
	for (std::thread &reader : readers) {
		reader.join();
	}
	CHECK(one->front() == ROUNDS);
}
