#include "model/model_islands.hpp"

#include "base/random.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <unordered_map>

namespace undergrowth {

namespace {

constexpr float WELD = 1e-5f; // Of the size of the model.

/// Sets of vertices that are united.
class Union {
public:
	explicit Union(size_t count) : parents(count) { std::iota(parents.begin(), parents.end(), 0); }

	int root_of(int one) {
		while (parents[static_cast<size_t>(one)] != one) {
			int &parent = parents[static_cast<size_t>(one)];
			parent = parents[static_cast<size_t>(parent)];
			one = parent;
		}
		return one;
	}
	void unite(int one, int other) {
		const int a = root_of(one);
		const int b = root_of(other);
		parents[static_cast<size_t>(std::max(a, b))] = std::min(a, b);
	}

private:
	std::vector<int> parents;
};

float size_of(const std::vector<glm::vec3> &places) {
	glm::vec3 least = places[0], greatest = places[0];
	for (const glm::vec3 &place : places) {
		least = glm::min(least, place);
		greatest = glm::max(greatest, place);
	}
	return glm::length(greatest - least);
}

uint64_t key_of(const glm::vec3 &place, float cell, int surface) {
	uint64_t key = mix_bits(static_cast<uint64_t>(surface));
	for (int axis = 0; axis < 3; axis++) {
		key = mix_bits(key ^ static_cast<uint64_t>(static_cast<int64_t>(std::floor(place[axis] / cell + 0.5f))));
	}
	return key;
}

void weld(const std::vector<ModelSurface> &surfaces, const std::vector<glm::vec3> &places, Union &sets) {
	const float cell = std::max(WELD * size_of(places), 1e-7f);
	std::unordered_map<uint64_t, int> known;
	known.reserve(places.size());
	int vertex = 0;
	for (size_t surface = 0; surface < surfaces.size(); surface++) {
		for (int i = 0; i < surfaces[surface].vertices; i++, vertex++) {
			const uint64_t key = key_of(places[static_cast<size_t>(vertex)], cell, static_cast<int>(surface));
			const auto [entry, is_new] = known.emplace(key, vertex);
			if (!is_new) {
				sets.unite(entry->second, vertex);
			}
		}
	}
}

// Numbers the islands by their first vertex, and lists their vertices.
void list_islands(
		const std::vector<ModelSurface> &surfaces, const std::vector<bool> &is_used, Union &sets, ModelIslands &found) {
	std::vector<int> numbers(is_used.size(), -1);
	found.of_vertex.assign(is_used.size(), -1);
	int vertex = 0;
	for (size_t surface = 0; surface < surfaces.size(); surface++) {
		for (int i = 0; i < surfaces[surface].vertices; i++, vertex++) {
			if (!is_used[static_cast<size_t>(vertex)]) {
				continue;
			}
			int &number = numbers[static_cast<size_t>(sets.root_of(vertex))];
			if (number < 0) {
				number = static_cast<int>(found.islands.size());
				found.islands.emplace_back();
				found.islands.back().surface = static_cast<int>(surface);
				found.islands.back().is_foliage = surfaces[surface].is_foliage;
			}
			found.of_vertex[static_cast<size_t>(vertex)] = number;
			found.islands[static_cast<size_t>(number)].count++;
		}
	}
	int first = 0;
	for (ModelIsland &island : found.islands) {
		island.first = first;
		first += island.count;
		island.count = 0;
	}
	found.members.resize(static_cast<size_t>(first));
}

void fill_islands(const std::vector<glm::vec3> &places, ModelIslands &found) {
	for (size_t vertex = 0; vertex < places.size(); vertex++) {
		const int number = found.of_vertex[vertex];
		if (number < 0) {
			continue;
		}
		ModelIsland &island = found.islands[static_cast<size_t>(number)];
		island.least = island.count == 0 ? places[vertex] : glm::min(island.least, places[vertex]);
		island.greatest = island.count == 0 ? places[vertex] : glm::max(island.greatest, places[vertex]);
		found.members[static_cast<size_t>(island.first + island.count++)] = static_cast<int>(vertex);
	}
}

} // namespace

ModelIslands find_islands(const std::vector<ModelSurface> &surfaces, const std::vector<glm::vec3> &places) {
	Union sets(places.size());
	weld(surfaces, places, sets);
	std::vector<bool> is_used(places.size(), false);
	int first = 0;
	for (const ModelSurface &surface : surfaces) {
		for (int i = 0; i < surface.index_count; i++) {
			is_used[static_cast<size_t>(first + surface.indices[i])] = true;
			if (i % 3 != 0) {
				sets.unite(first + surface.indices[i - 1], first + surface.indices[i]);
			}
		}
		first += surface.vertices;
	}
	ModelIslands found;
	list_islands(surfaces, is_used, sets, found);
	fill_islands(places, found);
	first = 0;
	for (const ModelSurface &surface : surfaces) {
		for (int i = 0; i < surface.index_count; i += 3) {
			const auto at = [&](int corner) {
				return places[static_cast<size_t>(first + surface.indices[i + corner])];
			};
			const int island = found.of_vertex[static_cast<size_t>(first + surface.indices[i])];
			found.islands[static_cast<size_t>(island)].area +=
					0.5f * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
		}
		first += surface.vertices;
	}
	return found;
}

} // namespace undergrowth
