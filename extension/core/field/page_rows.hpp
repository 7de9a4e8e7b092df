#pragma once

#include "stand/blocks.hpp"

#include <vector>

namespace undergrowth {

/// Where the plants of a block are in a simulation: plant `slot` is row first + slot of the page.
struct PageRows {
	int page = -1; ///< -1: none.
	int first = 0;
	int count = 0;
};

/// m: how wide blocks may lie that share a page, so that far pages can be stepped less often than near ones.
inline constexpr float WIDEST_PAGE = 64.0f;

/// Rows for each block, in pages of one species, MotionPage::PAGE_PLANTS and WIDEST_PAGE at most: neighbours in the
/// list share a page, since many small pages cost more than few large ones. Pages are numbered from 0, in the order of
/// their first blocks; blocks follow each other within a page without gaps.
std::vector<PageRows> join_into_pages(const std::vector<PlantBlock> &blocks);

} // namespace undergrowth
