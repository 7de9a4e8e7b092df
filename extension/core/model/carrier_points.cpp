#include "model/carrier_points.hpp"

#include "base/random.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_set>

namespace undergrowth {

namespace {

constexpr float CELL = 0.08f; // Of the height.
constexpr float SPACING = 0.012f; // Of the height: points nearer to each other are one.
constexpr int MAX_CELLS = 48; // Along one axis.
constexpr int MAX_STEPS = 256; // Of one edge.

} // namespace

CarrierPoints::CarrierPoints(const std::vector<ModelSurface> &surfaces, const std::vector<glm::vec3> &places,
		const ModelIslands &islands, const std::vector<bool> &carries, float height) {
	glm::vec3 least(0.0f), greatest(0.0f);
	for (size_t i = 0; i < carries.size(); i++) {
		if (carries[i]) {
			least = glm::min(least, islands.islands[i].least);
			greatest = glm::max(greatest, islands.islands[i].greatest);
		}
	}
	const glm::vec3 extent = greatest - least;
	const float longest = std::max({ extent.x, extent.y, extent.z });
	cell = std::max({ CELL * height, longest / MAX_CELLS, 1e-6f });
	origin = least;
	size_t count = 1;
	for (int axis = 0; axis < 3; axis++) {
		counts[axis] = static_cast<int>(extent[axis] / cell) + 1;
		count *= static_cast<size_t>(counts[axis]);
	}
	cells.resize(count);
	const float spacing = std::max(SPACING * height, longest / 1000.0f);
	std::unordered_set<uint64_t> known;
	const auto add = [&](const glm::vec3 &place, int island) {
		uint64_t key = mix_bits(static_cast<uint64_t>(island));
		size_t number = 0;
		for (int axis = 0; axis < 3; axis++) {
			key = mix_bits(key ^ static_cast<uint64_t>(static_cast<int64_t>(std::floor(place[axis] / spacing))));
			number = number * static_cast<size_t>(counts[axis]) + static_cast<size_t>(coordinate(place, axis));
		}
		if (known.insert(key).second) {
			cells[number].push_back({ place, island });
		}
	};
	int first = 0;
	for (const ModelSurface &surface : surfaces) {
		for (int i = 0; i < surface.index_count; i++) {
			const int from = first + surface.indices[i];
			const int to = first + surface.indices[i % 3 == 2 ? i - 2 : i + 1];
			const int island = islands.of_vertex[static_cast<size_t>(from)];
			if (!carries[static_cast<size_t>(island)]) {
				continue;
			}
			const glm::vec3 start = places[static_cast<size_t>(from)];
			const glm::vec3 way = places[static_cast<size_t>(to)] - start;
			const int steps = std::clamp(static_cast<int>(glm::length(way) / spacing), 1, MAX_STEPS);
			for (int step = 0; step < steps; step++) {
				add(start + way * (static_cast<float>(step) / static_cast<float>(steps)), island);
			}
		}
		first += surface.vertices;
	}
}

int CarrierPoints::coordinate(const glm::vec3 &place, int axis) const {
	const float at = std::clamp((place[axis] - origin[axis]) / cell, 0.0f, static_cast<float>(counts[axis] - 1));
	return static_cast<int>(at);
}

void CarrierPoints::look_in(
		const int (&at)[3], const glm::vec3 &place, const std::vector<bool> &is_open, Found &best) const {
	size_t number = 0;
	for (int axis = 0; axis < 3; axis++) {
		if (at[axis] < 0 || at[axis] >= counts[axis]) {
			return;
		}
		number = number * static_cast<size_t>(counts[axis]) + static_cast<size_t>(at[axis]);
	}
	for (const Point &point : cells[number]) {
		const glm::vec3 way = point.place - place;
		const float square = glm::dot(way, way);
		if (is_open[static_cast<size_t>(point.island)] && (best.island < 0 || square < best.square)) {
			best = { point.island, square };
		}
	}
}

void CarrierPoints::look_in_shell(
		const int (&middle)[3], int ring, const glm::vec3 &place, const std::vector<bool> &is_open, Found &best) const {
	for (int x = -ring; x <= ring; x++) {
		for (int y = -ring; y <= ring; y++) {
			const bool is_side = std::abs(x) == ring || std::abs(y) == ring;
			for (int z = -ring; z <= ring; z += is_side || ring == 0 ? 1 : 2 * ring) {
				look_in({ middle[0] + x, middle[1] + y, middle[2] + z }, place, is_open, best);
			}
		}
	}
}

CarrierPoints::Found CarrierPoints::nearest(const glm::vec3 &place, const std::vector<bool> &is_open) const {
	const int middle[3] = { coordinate(place, 0), coordinate(place, 1), coordinate(place, 2) };
	const int last = std::max({ counts[0], counts[1], counts[2] });
	Found best;
	for (int ring = 0; ring <= last; ring++) {
		look_in_shell(middle, ring, place, is_open, best);
		const float searched =
				cell * static_cast<float>(ring); // A place outside of the grid is farther from all of it.
		if (best.island >= 0 && best.square <= searched * searched) {
			break;
		}
	}
	return best;
}

} // namespace undergrowth
