#include "climb/climb_chunks.hpp"

#include "base/random.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace undergrowth {

namespace {

using Key = std::tuple<int, int, int, int, int>; // Body, cube, and the axis of the surface.

int cube_of(float at, float size) {
	return static_cast<int>(std::floor(at / size));
}

Key key_of(int body, const glm::vec3 &place, float size, int side = 0) {
	return { body, cube_of(place.x, size), cube_of(place.y, size), cube_of(place.z, size), side };
}

/// The nearest of the six directions along an axis.
int side_of(const glm::vec3 &normal) {
	const glm::vec3 size(std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z));
	const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
	return 2 * axis + (normal[axis] < 0.0f ? 1 : 0);
}

/// Numbers keys in the order of their first use.
class Numbers {
public:
	int of(const Key &key) { return known.emplace(key, static_cast<int>(known.size())).first->second; }
	int count() const { return static_cast<int>(known.size()); }

private:
	std::map<Key, int> known;
};

} // namespace

std::vector<ClimbChunk> divide_climb(const Climb &climb, float size) {
	std::vector<ClimbChunk> chunks;
	Numbers numbers;
	const auto chunk_at = [&](int body, const glm::vec3 &place) -> ClimbChunk & {
		const auto number = static_cast<std::size_t>(numbers.of(key_of(body, place, size)));
		if (number == chunks.size()) {
			chunks.emplace_back();
			chunks.back().body = body;
		}
		return chunks[number];
	};
	for (std::size_t i = 0; i < climb.leaves.size(); i++) {
		chunk_at(climb.leaves[i].body, climb.leaves[i].place).leaves.push_back(static_cast<int>(i));
	}
	for (ClimbChunk &chunk : chunks) {
		std::sort(chunk.leaves.begin(), chunk.leaves.end(),
				[](int a, int b) { return mix_bits(static_cast<uint64_t>(a)) < mix_bits(static_cast<uint64_t>(b)); });
	}
	for (const ClimbShoot &shoot : climb.shoots) {
		ClimbChunk *last = nullptr;
		for (int i = shoot.first; i + 1 < shoot.first + shoot.count; i++) {
			const ClimbPoint &point = climb.points[static_cast<std::size_t>(i)];
			ClimbChunk &chunk = chunk_at(point.body, point.place);
			if (last != &chunk) {
				chunk.stems.push_back({ i, 1 });
			}
			chunk.stems.back().count++;
			last = &chunk;
		}
	}
	return chunks;
}

ClimbCells find_cells(const Climb &climb, float size, int max) {
	ClimbCells found;
	for (float cell = size;; cell *= 1.5f) {
		Numbers numbers;
		found.of_leaves.clear();
		for (const ClimbLeaf &leaf : climb.leaves) {
			found.of_leaves.push_back(numbers.of(key_of(leaf.body, leaf.place, cell, side_of(leaf.out))));
		}
		if (numbers.count() <= max || cell > 1e4f) {
			found.cells.resize(static_cast<std::size_t>(numbers.count()));
			break;
		}
	}
	std::vector<glm::vec3> sums(found.cells.size(), glm::vec3(0.0f));
	for (std::size_t i = 0; i < climb.leaves.size(); i++) {
		const auto number = static_cast<std::size_t>(found.of_leaves[i]);
		found.cells[number].body = climb.leaves[i].body;
		found.cells[number].leaves++;
		found.cells[number].place += climb.leaves[i].place;
		sums[number] += climb.leaves[i].out;
	}
	for (std::size_t i = 0; i < sums.size(); i++) {
		found.cells[i].place /= static_cast<float>(found.cells[i].leaves);
		const float length = glm::length(sums[i]);
		found.cells[i].normal = length > 1e-6f ? sums[i] / length : glm::vec3(0.0f, 1.0f, 0.0f);
	}
	return found;
}

} // namespace undergrowth
