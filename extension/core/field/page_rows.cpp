#include "field/page_rows.hpp"

#include "motion/motion_page.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <map>

namespace undergrowth {

namespace {

/// The page of a species with free rows.
struct OpenPage {
	int number = -1;
	int count = 0;
	glm::vec3 low; ///< m, around all roots.
	glm::vec3 high;

	bool has_room_for(const PlantBlock &block) const {
		const glm::vec3 span = glm::max(high, block.high) - glm::min(low, block.low);
		return number >= 0 && count + block.size() <= MotionPage::PAGE_PLANTS &&
				std::max(span.x, span.z) <= WIDEST_PAGE;
	}
};

} // namespace

std::vector<PageRows> join_into_pages(const std::vector<PlantBlock> &blocks) {
	std::map<int, OpenPage> open; // By species.
	std::vector<PageRows> rows;
	int pages = 0;
	for (const PlantBlock &block : blocks) {
		OpenPage &page = open[block.species];
		if (!page.has_room_for(block)) {
			page = { pages++, 0, block.low, block.high };
		}
		rows.push_back({ page.number, page.count, block.size() });
		page = { page.number, page.count + block.size(), glm::min(page.low, block.low),
			glm::max(page.high, block.high) };
	}
	return rows;
}

} // namespace undergrowth
