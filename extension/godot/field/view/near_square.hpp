#pragma once

#include "base/convert.hpp"
#include "field/view/drawn_plant.hpp"
#include "field/view/field_level.hpp"

#include <godot_cpp/variant/aabb.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace undergrowth {

/// The plants of one species in one square, sorted by cells, and by rank in each cell. NearPlants and ShadowPlants draw
/// those near the cameras.
struct NearSquare {
	static constexpr float CELL_SIZE = 1.0f; ///< m.

	int species = 0;
	int stride = 0; ///< Floats per plant, as in a multimesh.
	std::vector<DrawnPlant> plants;
	glm::vec2 low = { 0.0f, 0.0f }; ///< m, of the first cell.
	int columns = 0;
	int rows = 0;
	std::vector<int> begins; ///< First plant of each cell, and the end of the last one.
	float lowest = 0.0f; ///< Height of the lowest root (m).
	float highest = 0.0f;
	float reach = 0.0f; ///< Largest distance of a plant's parts from its root (m).
	std::vector<uint16_t> drawn; ///< By plant: bits of the levels that draw it. Only NearPlants writes it.

	godot::Vector3 root(int plant) const { return to_godot(plants[size_t(plant)].root); }
	/// Writes the instances of `count` plants, for the meshes of some variants: mesh i is that of variant i, and
	/// variant v is drawn by mesh v % `meshes`. `heights`: m, of all variants. `add(mesh)` returns where one plant is
	/// written.
	template <class Add>
	void write(int first, int count, const std::vector<float> &heights, size_t meshes, const Add &add) const;
	/// Around the roots of all plants.
	godot::AABB box() const;
	/// The same for a cell, which may be larger.
	godot::AABB box_of(int cell) const;
	/// Returns the number of plants in a cell with at most this rank. They are its first ones.
	int count_ranked(int cell, float cut) const;
	/// Returns the number of plants within the distances of a level from `place` (field axes).
	int count_within(const godot::Vector3 &place, const FieldLevel &level) const;
	/// Calls visit(cell) for the cells that a square of side 2 * far around `place` (m, field axes) meets.
	template <class Visit> void for_each_cell(const godot::Vector3 &place, float far, const Visit &visit) const;
};

template <class Add>
void NearSquare::write(int first, int count, const std::vector<float> &heights, size_t meshes, const Add &add) const {
	for (int i = first; i < first + count; i++) {
		const DrawnPlant &plant = plants[size_t(i)];
		const size_t mesh = plant.variant % meshes;
		plant.write(stride, heights[mesh], add(mesh));
	}
}

template <class Visit>
void NearSquare::for_each_cell(const godot::Vector3 &place, float far, const Visit &visit) const {
	const auto cell_at = [](float at, float first, int count) {
		return int(std::clamp(std::floor((at - first) / CELL_SIZE), -1.0f, float(count)));
	};
	const int left = std::max(cell_at(float(place.x) - far, low.x, columns), 0);
	const int right = std::min(cell_at(float(place.x) + far, low.x, columns), columns - 1);
	const int first = std::max(cell_at(float(place.z) - far, low.y, rows), 0);
	const int last = std::min(cell_at(float(place.z) + far, low.y, rows), rows - 1);
	for (int row = first; row <= last; row++) {
		for (int column = left; column <= right; column++) {
			visit(row * columns + column);
		}
	}
}

} // namespace undergrowth
