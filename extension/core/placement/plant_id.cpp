#include "placement/plant_id.hpp"

#include "base/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace undergrowth {

namespace {

constexpr int CELL_BITS = 25; ///< The whole range of positions in cells of a square centimetre, both signs.
constexpr int SPACING_BITS = 12;
constexpr int64_t MIDDLE = int64_t(1) << (CELL_BITS - 1);
constexpr int64_t CELL_MASK = (int64_t(1) << CELL_BITS) - 1;
constexpr int64_t ADDED = int64_t(1) << 62;
/// Left side of a cell relative to its number: rows are shifted (Placement), and no plant is nearer to a side than 0.15
/// cells.
constexpr double EVEN_SIDE = -0.25;
constexpr double ODD_SIDE = 0.25;

double side_of(int64_t row) {
	return (row & 1) == 0 ? EVEN_SIDE : ODD_SIDE;
}

/// Hash that separates the ids of different spacings.
int64_t mark_of(double spacing) {
	uint64_t bits = 0;
	std::memcpy(&bits, &spacing, sizeof(bits));
	return static_cast<int64_t>(mix_bits(bits) >> (64 - SPACING_BITS)) << (2 * CELL_BITS);
}

int64_t cell(double place) {
	const auto max = static_cast<double>(MIDDLE - 1);
	const double within = std::clamp(place, -max, max);
	const auto towards_zero = static_cast<int64_t>(within); // std::floor() is a function call for old processors.
	return towards_zero - static_cast<int64_t>(static_cast<double>(towards_zero) > within);
}

} // namespace

PlantId generated_plant_id(float x, float z, double spacing) {
	const int64_t row = cell(static_cast<double>(z) / spacing);
	const int64_t column = cell(static_cast<double>(x) / spacing - side_of(row));
	return mark_of(spacing) | ((row + MIDDLE) << CELL_BITS) | (column + MIDDLE);
}

bool matches_spacing(PlantId id, double spacing) {
	return (id >> (2 * CELL_BITS)) << (2 * CELL_BITS) == mark_of(spacing);
}

bool share_ids(double spacing, double other) {
	return mark_of(spacing) == mark_of(other);
}

PlantId added_plant_id(int64_t number) {
	return ADDED | number;
}

bool is_added(PlantId id) {
	return (id & ADDED) != 0;
}

int64_t added_plant_number(PlantId id) {
	return id & ~ADDED;
}

void generated_plant_cell(PlantId id, int &column, int &row) {
	row = static_cast<int>(((id >> CELL_BITS) & CELL_MASK) - MIDDLE);
	column = static_cast<int>((id & CELL_MASK) - MIDDLE);
}

void generated_plant_position(PlantId id, double spacing, float &x, float &z) {
	int column = 0;
	int row = 0;
	generated_plant_cell(id, column, row);
	x = static_cast<float>((static_cast<double>(column) + side_of(row) + 0.5) * spacing);
	z = static_cast<float>((static_cast<double>(row) + 0.5) * spacing);
}

} // namespace undergrowth
