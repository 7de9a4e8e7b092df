#include "field/page_rows.hpp"

#include "motion/motion_page.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace undergrowth;

namespace {

PlantBlock block_of(int species, int plants) {
	PlantBlock block;
	block.species = species;
	block.plants.resize(static_cast<std::size_t>(plants));
	return block;
}

} // namespace

TEST_CASE("neighbouring blocks of a species share a page, one after the other, and other species another page") {
	const std::vector<PageRows> rows =
			join_into_pages({ block_of(3, 100), block_of(1, 7), block_of(3, 50), block_of(1, 9) });
	REQUIRE(rows.size() == 4);
	const PageRows wanted[4] = { { 0, 0, 100 }, { 1, 0, 7 }, { 0, 100, 50 }, { 1, 7, 9 } };
	for (std::size_t i = 0; i < 4; i++) {
		CHECK(rows[i].page == wanted[i].page);
		CHECK(rows[i].first == wanted[i].first);
		CHECK(rows[i].count == wanted[i].count);
	}
}

TEST_CASE("a page is filled to the last row, and a block is never divided between two") {
	constexpr int MOST = MotionPage::PAGE_PLANTS;
	const std::vector<PageRows> rows =
			join_into_pages({ block_of(0, MOST - 10), block_of(0, 10), block_of(0, MOST - 10), block_of(0, 11) });
	CHECK(rows[1].page == 0);
	CHECK(rows[1].first == MOST - 10);
	CHECK(rows[2].page == 1);
	CHECK(rows[2].first == 0);
	CHECK(rows[3].page == 2);
	CHECK(rows[3].first == 0);
}

TEST_CASE("distant blocks do not share a page, even with few plants") {
	std::vector<PlantBlock> blocks;
	for (const float x : { 0.0f, 40.0f, 65.0f, 100.0f }) {
		blocks.push_back(block_of(0, 1));
		blocks.back().low = blocks.back().high = { x, 0.0f, -x };
	}
	const std::vector<PageRows> rows = join_into_pages(blocks);
	CHECK(rows[1].page == 0);
	CHECK(rows[2].page == 1);
	CHECK(rows[3].page == 1);
	blocks[1].low.z = -70.0f;
	CHECK(join_into_pages(blocks)[1].page == 1);
}

TEST_CASE("zero blocks need zero pages") {
	CHECK(join_into_pages({}).empty());
}
