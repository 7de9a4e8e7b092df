#include "field/view/near_square.hpp"

#include <limits>

using namespace godot;

namespace undergrowth {

AABB NearSquare::box() const {
	return AABB(Vector3(low.x, lowest, low.y),
			Vector3(float(columns) * CELL_SIZE, highest - lowest, float(rows) * CELL_SIZE));
}

AABB NearSquare::box_of(int cell) const {
	const Vector3 first(low.x + float(cell % columns) * CELL_SIZE, lowest, low.y + float(cell / columns) * CELL_SIZE);
	return AABB(first, Vector3(CELL_SIZE, highest - lowest, CELL_SIZE));
}

int NearSquare::count_ranked(int cell, float cut) const {
	const int first = begins[size_t(cell)], end = begins[size_t(cell) + 1];
	int plant = first;
	while (plant < end && plants[size_t(plant)].rank() <= cut) {
		plant++;
	}
	return plant - first;
}

int NearSquare::count_within(const Vector3 &place, const FieldLevel &level) const {
	int count = 0;
	const float near = std::max(level.begin - level.margin, 0.0f);
	const float far = level.end > 0.0f ? level.end : std::numeric_limits<float>::max();
	for_each_cell(place, far, [&](int cell) {
		for (int i = begins[size_t(cell)]; i < begins[size_t(cell) + 1]; i++) {
			const float away = root(i).distance_to(place);
			count += away >= near && away < far ? 1 : 0;
		}
	});
	return count;
}

} // namespace undergrowth
