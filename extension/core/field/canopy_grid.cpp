#include "field/canopy_grid.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr double UNIT = 1e9; // Per m².
constexpr double MAX_AREA = 1e3; // m², of one plant.
constexpr double FARTHEST = 1e8; // Cells from the origin.
constexpr int32_t MAX_CELLS = 64; // Of a side of a box. Over a larger one the mean of the field counts.
constexpr double AROUND = 0.5; // Weight of the cells around a box.

int32_t cell_at(float place) {
	const double cell = std::floor(static_cast<double>(place) / static_cast<double>(CanopyGrid::CELL));
	return static_cast<int32_t>(std::clamp(cell, -FARTHEST, FARTHEST));
}

uint64_t key_of(int32_t x, int32_t z) {
	return static_cast<uint64_t>(static_cast<uint32_t>(x)) << 32 | static_cast<uint32_t>(z);
}

} // namespace

void CanopyGrid::set_height(int species, float height) {
	const auto index = static_cast<std::size_t>(species);
	heights.resize(std::max(heights.size(), index + 1), 0.0f);
	changes += heights[index] != height ? 1 : 0;
	heights[index] = height;
}

float CanopyGrid::height(int species) const {
	const auto index = static_cast<std::size_t>(species);
	return index < heights.size() ? heights[index] : 0.0f;
}

void CanopyGrid::add(int species, float x, float z, float drag_area) {
	const auto index = static_cast<std::size_t>(species);
	const auto area = static_cast<double>(drag_area);
	if (!std::isfinite(area) || area == 0.0) {
		return;
	}
	heights.resize(std::max(heights.size(), index + 1), 0.0f);
	const int64_t whole = std::llround(UNIT * std::clamp(area, -MAX_AREA, MAX_AREA));
	const uint64_t key = key_of(cell_at(x), cell_at(z));
	Areas &left = cells[key];
	for (Areas *areas : { &left, &total }) {
		areas->resize(std::max(areas->size(), index + 1), 0);
		(*areas)[index] += whole;
	}
	if (whole < 0 && std::all_of(left.begin(), left.end(), [](int64_t one) { return one == 0; })) {
		cells.erase(key);
	}
	changes++;
}

void CanopyGrid::clear() {
	cells.clear();
	total.clear();
	changes++;
}

void CanopyGrid::add_higher(float height, const Areas &areas, double weight, Sum &sum) const {
	for (std::size_t i = 0; i < areas.size(); i++) {
		if (heights[i] > height) {
			const double area = weight * static_cast<double>(areas[i]);
			sum.area += area;
			sum.moment += area * static_cast<double>(heights[i]);
		}
	}
}

TallerPlants CanopyGrid::higher_than(float height, const glm::vec3 &low, const glm::vec3 &high) const {
	Sum sum;
	const int32_t first_x = cell_at(low.x), last_x = cell_at(high.x);
	const int32_t first_z = cell_at(low.z), last_z = cell_at(high.z);
	if (last_x - first_x > MAX_CELLS || last_z - first_z > MAX_CELLS) {
		return higher_than(height);
	}
	for (int32_t z = first_z - 1; z <= last_z + 1; z++) {
		for (int32_t x = first_x - 1; x <= last_x + 1; x++) {
			const bool is_around = x < first_x || x > last_x || z < first_z || z > last_z;
			const double weight = is_around ? AROUND : 1.0;
			sum.ground += weight;
			const auto found = cells.find(key_of(x, z));
			if (found != cells.end()) {
				add_higher(height, found->second, weight, sum);
			}
		}
	}
	return sum.canopy();
}

TallerPlants CanopyGrid::higher_than(float height) const {
	Sum sum;
	sum.ground = static_cast<double>(cells.size());
	add_higher(height, total, 1.0, sum);
	return sum.canopy();
}

TallerPlants CanopyGrid::Sum::canopy() const {
	if (area <= 0.0 || ground <= 0.0) {
		return {};
	}
	const double cell = static_cast<double>(CELL) * static_cast<double>(CELL);
	const double share = area / UNIT / (ground * cell) / static_cast<double>(CLOSED);
	return { static_cast<float>(moment / area), static_cast<float>(std::min(share, 1.0)) };
}

bool CanopyGrid::grows_at(int species, const glm::vec3 &place) const {
	const auto index = static_cast<std::size_t>(species);
	for (int32_t around = 0; around < 9; around++) {
		const auto found = cells.find(key_of(cell_at(place.x) + around % 3 - 1, cell_at(place.z) + around / 3 - 1));
		if (found != cells.end() && index < found->second.size() && found->second[index] > 0) {
			return true;
		}
	}
	return false;
}

PlantCanopy CanopyGrid::around(const glm::vec3 &place, float height_of_plant, int species) const {
	constexpr float AS_HIGH = 0.7f;
	constexpr float HALF = 0.5f;
	if (grows_at(species, place)) {
		return { height(species), higher_than(height(species), place, place) };
	}
	if (higher_than(AS_HIGH * height_of_plant, place, place).cover < HALF) {
		return {};
	}
	return { height_of_plant, higher_than(height_of_plant, place, place) };
}

std::size_t CanopyGrid::bytes() const {
	const std::size_t cell = sizeof(uint64_t) + sizeof(Areas) + heights.size() * sizeof(int64_t) + 2 * sizeof(void *);
	return cells.size() * cell + heights.capacity() * sizeof(float);
}

} // namespace undergrowth
