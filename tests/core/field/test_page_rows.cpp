#include "field/page_rows.hpp"

#include "motion/motion_page.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace undergrowth;

namespace {

PlantChunk chunk_of(int species, int plants) {
	PlantChunk chunk;
	chunk.species = species;
	chunk.plants.resize(static_cast<std::size_t>(plants));
	return chunk;
}

} // namespace

TEST_CASE("neighbouring blocks of a species share a page, one after the other, and other species another page") {
	const std::vector<PageRows> rows =
			join_into_pages({ chunk_of(3, 100), chunk_of(1, 7), chunk_of(3, 50), chunk_of(1, 9) });
	REQUIRE(rows.size() == 4);
	const PageRows wanted[4] = { { 0, 0, 100 }, { 1, 0, 7 }, { 0, 100, 50 }, { 1, 7, 9 } };
	for (std::size_t i = 0; i < 4; i++) {
		CHECK(rows[i].page == wanted[i].page);
		CHECK(rows[i].first == wanted[i].first);
		CHECK(rows[i].count == wanted[i].count);
	}
}

TEST_CASE("a page is filled to the last row, and a block is never divided between two") {
	constexpr int MAX_PLANTS = MotionPage::PAGE_PLANTS;
	const std::vector<PageRows> rows = join_into_pages(
			{ chunk_of(0, MAX_PLANTS - 10), chunk_of(0, 10), chunk_of(0, MAX_PLANTS - 10), chunk_of(0, 11) });
	CHECK(rows[1].page == 0);
	CHECK(rows[1].first == MAX_PLANTS - 10);
	CHECK(rows[2].page == 1);
	CHECK(rows[2].first == 0);
	CHECK(rows[3].page == 2);
	CHECK(rows[3].first == 0);
}

TEST_CASE("distant blocks do not share a page, even with few plants") {
	std::vector<PlantChunk> chunks;
	for (const float x : { 0.0f, 40.0f, 65.0f, 100.0f }) {
		chunks.push_back(chunk_of(0, 1));
		chunks.back().low = chunks.back().high = { x, 0.0f, -x };
	}
	const std::vector<PageRows> rows = join_into_pages(chunks);
	CHECK(rows[1].page == 0);
	CHECK(rows[2].page == 1);
	CHECK(rows[3].page == 1);
	chunks[1].low.z = -70.0f;
	CHECK(join_into_pages(chunks)[1].page == 1);
}

TEST_CASE("zero blocks need zero pages") {
	CHECK(join_into_pages({}).empty());
}
