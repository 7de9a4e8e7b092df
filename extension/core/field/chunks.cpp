#include "field/chunks.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace undergrowth {

namespace {

constexpr float USUAL_SIZE = 16.0f; ///< m.
constexpr double FARTHEST_CHUNK = 1.0e9;
constexpr int KINDS = 65536; ///< Species times variants.

int chunk_coordinate(float place, float size) {
	const double chunk = std::floor(static_cast<double>(place) / static_cast<double>(size));
	return static_cast<int>(std::clamp(chunk, -FARTHEST_CHUNK, FARTHEST_CHUNK));
}

/// Place along Hilbert's curve (Hilbert 1891), which goes from each square to one beside it.
uint64_t curve_key(int column, int row) {
	constexpr uint32_t MIDDLE = 0x80000000u;
	uint32_t x = static_cast<uint32_t>(column) + MIDDLE;
	uint32_t y = static_cast<uint32_t>(row) + MIDDLE;
	uint64_t key = 0;
	for (uint32_t side = MIDDLE; side != 0; side >>= 1) {
		const bool right = (x & side) != 0;
		const bool upper = (y & side) != 0;
		key = 4 * key + ((right ? 3u : 0u) ^ (upper ? 1u : 0u));
		if (!upper) {
			// The curve within the two lower quarters is turned.
			const uint32_t flip = right ? 0xffffffffu : 0u;
			const uint32_t turned = x ^ flip;
			x = y ^ flip;
			y = turned;
		}
	}
	return key;
}

int kind_of(const FieldPlants &plants, std::size_t i) {
	return plants.species[i] * 256 + plants.variant[i];
}

/// Chunks in their order, without plants, and each plant's chunk.
std::vector<FieldChunk> find_chunks(const FieldPlants &plants, float size, std::vector<int> &of_plant) {
	const std::size_t count = plants.x.size();
	std::vector<uint64_t> keys(count);
	std::vector<std::pair<uint64_t, FieldChunk>> found;
	for (std::size_t i = 0; i < count; i++) {
		FieldChunk chunk;
		chunk.column = chunk_coordinate(plants.x[i], size);
		chunk.row = chunk_coordinate(plants.z[i], size);
		// Plants come in rows: most follow one of the same chunk.
		if (i > 0 && chunk.column == found.back().second.column && chunk.row == found.back().second.row) {
			keys[i] = keys[i - 1];
			continue;
		}
		keys[i] = curve_key(chunk.column, chunk.row);
		found.emplace_back(keys[i], chunk);
	}
	const auto is_before = [](const auto &a, const auto &b) { return a.first < b.first; };
	const auto is_same = [](const auto &a, const auto &b) { return a.first == b.first; };
	std::sort(found.begin(), found.end(), is_before);
	found.erase(std::unique(found.begin(), found.end(), is_same), found.end());
	of_plant.resize(count);
	for (std::size_t i = 0; i < count; i++) {
		if (i > 0 && keys[i] == keys[i - 1]) {
			of_plant[i] = of_plant[i - 1];
			continue;
		}
		const std::pair<uint64_t, FieldChunk> wanted = { keys[i], {} };
		of_plant[i] = static_cast<int>(std::lower_bound(found.begin(), found.end(), wanted, is_before) - found.begin());
	}
	std::vector<FieldChunk> chunks;
	for (const auto &entry : found) {
		chunks.push_back(entry.second);
	}
	return chunks;
}

/// Stable: the entries of `order` by key(entry), which is in [0, keys).
template <class Key> std::vector<int> counting_sort(const std::vector<int> &order, int keys, Key key) {
	std::vector<int> starts(static_cast<std::size_t>(keys) + 1, 0);
	for (const int entry : order) {
		starts[static_cast<std::size_t>(key(entry)) + 1]++;
	}
	for (std::size_t i = 1; i < starts.size(); i++) {
		starts[i] += starts[i - 1];
	}
	std::vector<int> sorted(order.size());
	for (const int entry : order) {
		sorted[static_cast<std::size_t>(starts[static_cast<std::size_t>(key(entry))]++)] = entry;
	}
	return sorted;
}

/// How far plant i reaches from its root (m).
float plant_reach(const FieldPlants &plants, std::size_t i, const float *reach, int species_count) {
	const int species = plants.species[i];
	if (species >= species_count || !(reach[species] > 0.0f)) {
		return 0.0f;
	}
	const float height = static_cast<float>(plants.height[i]) * (FieldPlants::MOST_HEIGHT / 65536.0f);
	// Crowns keep their width where a plant is lower.
	return reach[species] * plants.scale[i] * std::max(1.0f, height);
}

void find_box(FieldChunk &chunk, const FieldPlants &plants, const float *reach, int species_count) {
	for (auto i = static_cast<std::size_t>(chunk.begin); i < static_cast<std::size_t>(chunk.end); i++) {
		const glm::vec3 root = { plants.x[i], plants.y[i], plants.z[i] };
		const glm::vec3 around = glm::vec3(plant_reach(plants, i, reach, species_count));
		const bool is_first = i == static_cast<std::size_t>(chunk.begin);
		chunk.low = is_first ? root - around : glm::min(chunk.low, root - around);
		chunk.high = is_first ? root + around : glm::max(chunk.high, root + around);
	}
}

void find_ranges(FieldChunks &field, FieldChunk &chunk, const FieldPlants &plants) {
	chunk.first_range = static_cast<int>(field.ranges.size());
	for (int i = chunk.begin; i < chunk.end; i++) {
		const auto at = static_cast<std::size_t>(i);
		if (i == chunk.begin || kind_of(plants, at) != kind_of(plants, at - 1)) {
			field.ranges.push_back({ i, i, plants.species[at], plants.variant[at] });
		}
		field.ranges.back().end = i + 1;
	}
	chunk.last_range = static_cast<int>(field.ranges.size());
}

bool is_near_box(const FieldChunk &chunk, const glm::vec3 &centre, float radius) {
	double squared = 0.0;
	for (int axis = 0; axis < 3; axis++) {
		const double nearest = std::clamp(centre[axis], chunk.low[axis], chunk.high[axis]);
		squared += (nearest - static_cast<double>(centre[axis])) * (nearest - static_cast<double>(centre[axis]));
	}
	return squared <= static_cast<double>(radius) * static_cast<double>(radius);
}

bool is_in_sphere(const FieldPlants &plants, std::size_t i, const glm::vec3 &centre, float radius) {
	const double x = static_cast<double>(plants.x[i]) - static_cast<double>(centre.x);
	const double y = static_cast<double>(plants.y[i]) - static_cast<double>(centre.y);
	const double z = static_cast<double>(plants.z[i]) - static_cast<double>(centre.z);
	return x * x + y * y + z * z <= static_cast<double>(radius) * static_cast<double>(radius);
}

} // namespace

FieldChunks sort_into_chunks(FieldPlants &plants, float size, const float *reach, int species_count) {
	FieldChunks field;
	field.size = std::isfinite(size) && size > 0.0f ? size : USUAL_SIZE;
	std::vector<int> of_plant;
	field.chunks = find_chunks(plants, field.size, of_plant);
	std::vector<int> order(plants.x.size());
	for (std::size_t i = 0; i < order.size(); i++) {
		order[i] = static_cast<int>(i);
	}
	order = counting_sort(order, KINDS, [&](int i) { return kind_of(plants, static_cast<std::size_t>(i)); });
	const auto chunk_of = [&](int i) { return of_plant[static_cast<std::size_t>(i)]; };
	order = counting_sort(order, static_cast<int>(field.chunks.size()), chunk_of);
	plants = plants.reordered(order);

	int begin = 0;
	for (std::size_t i = 0; i < field.chunks.size(); i++) {
		FieldChunk &chunk = field.chunks[i];
		chunk.begin = begin;
		while (begin < plants.size() && chunk_of(order[static_cast<std::size_t>(begin)]) == static_cast<int>(i)) {
			begin++;
		}
		chunk.end = begin;
		find_box(chunk, plants, reach, species_count);
		find_ranges(field, chunk, plants);
	}
	return field;
}

std::vector<int> find_in_sphere(
		const FieldPlants &plants, const FieldChunks &chunks, const glm::vec3 &centre, float radius) {
	std::vector<int> found;
	if (!(radius >= 0.0f)) {
		return found;
	}
	for (const FieldChunk &chunk : chunks.chunks) {
		if (!is_near_box(chunk, centre, radius)) {
			continue;
		}
		for (int i = chunk.begin; i < chunk.end; i++) {
			if (is_in_sphere(plants, static_cast<std::size_t>(i), centre, radius)) {
				found.push_back(i);
			}
		}
	}
	return found;
}

} // namespace undergrowth
