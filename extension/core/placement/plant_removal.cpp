#include "placement/plant_removal.hpp"

#include <cstddef>

namespace undergrowth {

namespace {

template <class T> void remove_entries(const std::vector<int> &ascending, std::vector<T> &column) {
	std::size_t next = 0;
	std::size_t kept = 0;
	for (std::size_t i = 0; i < column.size(); i++) {
		if (next < ascending.size() && static_cast<std::size_t>(ascending[next]) == i) {
			next++;
		} else {
			column[kept++] = column[i];
		}
	}
	column.resize(kept);
}

} // namespace

void remove_plants(const std::vector<int> &ascending, FieldPlants &plants, std::vector<float> &heights,
		std::vector<glm::vec3> &normals) {
	if (ascending.empty()) {
		return;
	}
	plants.remove(ascending);
	remove_entries(ascending, heights);
	remove_entries(ascending, normals);
}

void crop_plants(
		const AreaBox &box, FieldPlants &plants, std::vector<float> &heights, std::vector<glm::vec3> &normals) {
	std::vector<int> outside;
	for (std::size_t i = 0; i < plants.x.size(); i++) {
		if (!is_in_box(box, { plants.x[i], plants.z[i] })) {
			outside.push_back(static_cast<int>(i));
		}
	}
	remove_plants(outside, plants, heights, normals);
}

} // namespace undergrowth
