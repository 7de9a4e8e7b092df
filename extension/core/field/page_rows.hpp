#pragma once

#include "placement/chunks.hpp"

#include <vector>

namespace undergrowth {

/// Rows of a chunk's plants in a simulation: plant `slot` is row first + slot of the page.
struct PageRows {
	int page = -1; ///< -1: none.
	int first = 0;
	int count = 0;
};

/// m: maximum extent of the chunks of a page, so that far pages can be stepped less often than near ones.
inline constexpr float WIDEST_PAGE = 64.0f;

/// Assigns rows to each chunk, in pages of one species with at most MotionPage::PAGE_PLANTS plants and WIDEST_PAGE
/// extent. Neighbours in the list share a page, since many small pages cost more than few large ones. Pages are
/// numbered from 0, in the order of their first chunks; chunks are contiguous within a page.
std::vector<PageRows> join_into_pages(const std::vector<PlantChunk> &chunks);

} // namespace undergrowth
