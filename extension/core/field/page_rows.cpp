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

	bool has_room_for(const PlantChunk &chunk) const {
		const glm::vec3 span = glm::max(high, chunk.high) - glm::min(low, chunk.low);
		return number >= 0 && count + chunk.size() <= MotionPage::PAGE_PLANTS &&
				std::max(span.x, span.z) <= WIDEST_PAGE;
	}
};

} // namespace

std::vector<PageRows> join_into_pages(const std::vector<PlantChunk> &chunks) {
	std::map<int, OpenPage> open; // By species.
	std::vector<PageRows> rows;
	int pages = 0;
	for (const PlantChunk &chunk : chunks) {
		OpenPage &page = open[chunk.species];
		if (!page.has_room_for(chunk)) {
			page = { pages++, 0, chunk.low, chunk.high };
		}
		rows.push_back({ page.number, page.count, chunk.size() });
		page = { page.number, page.count + chunk.size(), glm::min(page.low, chunk.low),
			glm::max(page.high, chunk.high) };
	}
	return rows;
}

} // namespace undergrowth
