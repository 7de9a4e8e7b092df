#include "placement/density_brush.hpp"

#include "placement/area_row.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

/// Smaller steps, in codes, change nothing.
constexpr float MIN_STEP = 0.1f;
constexpr float MAX_CODE = 255.0f;
/// Plants/m²: one per hectare. A smaller density becomes 0.
constexpr float MIN_PLANTS = 1.0e-4f;

/// Returns `code` moved by `step` codes: by at least one, and not beyond `end`.
uint8_t moved(uint8_t code, float step, float end) {
	if (std::abs(step) < MIN_STEP || static_cast<float>(code) == end) {
		return code;
	}
	const float whole = std::copysign(std::max(std::floor(std::abs(step) + 0.5f), 1.0f), step);
	const float to = static_cast<float>(code) + whole;
	return static_cast<uint8_t>(step > 0.0f ? std::min(to, end) : std::max(to, end));
}

uint8_t approached(uint8_t code, float end, float share) {
	return moved(code, (end - static_cast<float>(code)) * share, end);
}

/// Unrounded code of plants/m².
float exact_plants_code(float plants) {
	const float share = std::clamp(plants / DensityCell::MAX_PLANT_DENSITY, 0.0f, 1.0f);
	return std::sqrt(share) * static_cast<float>(DensityCell::MAX_PLANTS);
}

/// Code of the cell's plants/m² after `share` of the way to `end`.
uint16_t approached_plants(const DensityCell &cell, float end, float share) {
	const uint16_t end_code = plants_code(end);
	const float plants = cell.plant_density();
	const float to = plants + (end - plants) * share;
	if (cell.plants == end_code || (to < MIN_PLANTS && end < MIN_PLANTS)) {
		return end_code;
	}
	const float step = exact_plants_code(to) - static_cast<float>(cell.plants);
	if (std::abs(step) < MIN_STEP) {
		return cell.plants;
	}
	const float whole = std::copysign(std::max(std::floor(std::abs(step) + 0.5f), 1.0f), step);
	return static_cast<uint16_t>(static_cast<float>(cell.plants) + whole);
}

/// Mean of a cell and the eight around it.
DensityCell mean_around(const DensityMap &map, int layer, int column, int row) {
	int density = 0;
	int height = 0;
	int scale_jitter = 0;
	int color_jitter = 0;
	float plants = 0.0f;
	for (int i = 0; i < 9; i++) {
		const DensityCell cell = map.cell(layer, column + i % 3 - 1, row + i / 3 - 1);
		density += cell.density;
		height += cell.height;
		scale_jitter += cell.scale_jitter;
		color_jitter += cell.color_jitter;
		plants += cell.plant_density();
	}
	const auto mean = [](int sum) { return static_cast<uint8_t>((sum + 4) / 9); };
	return { mean(density), mean(height), plants_code(plants / 9.0f), mean(scale_jitter), mean(color_jitter) };
}

DensityCell smoothed(const DensityCell &cell, const DensityCell &mean, float share) {
	return { approached(cell.density, mean.density, share), approached(cell.height, mean.height, share),
		approached_plants(cell, mean.plant_density(), share), approached(cell.scale_jitter, mean.scale_jitter, share),
		approached(cell.color_jitter, mean.color_jitter, share) };
}

DensityCell changed(DensityCell cell, const DensityStroke &stroke, float weight) {
	const float share = std::min(weight * stroke.strength, 1.0f);
	if (stroke.does == DensityStroke::Does::add) {
		const float end = stroke.value > 0.0f ? MAX_CODE : 0.0f;
		cell.density = moved(cell.density, stroke.value * weight * MAX_CODE, end);
		cell.plants = stroke.value > 0.0f ? cell.plants : approached_plants(cell, 0.0f, -stroke.value * weight);
	} else if (stroke.does == DensityStroke::Does::approach) {
		cell.density = approached(cell.density, static_cast<float>(density_code(stroke.value)), share);
		cell.plants = approached_plants(cell, 0.0f, share);
	} else if (stroke.does == DensityStroke::Does::approach_plants) {
		cell.density = approached(cell.density, 0.0f, share);
		cell.plants = approached_plants(cell, stroke.value, share);
	} else if (stroke.does == DensityStroke::Does::set_scale_jitter) {
		const float end = std::min(stroke.value, DensityCell::MAX_SCALE_JITTER);
		cell.scale_jitter = approached(cell.scale_jitter, static_cast<float>(density_code(end)), share);
	} else if (stroke.does == DensityStroke::Does::set_color_jitter) {
		cell.color_jitter = approached(cell.color_jitter, static_cast<float>(density_code(stroke.value)), share);
	} else {
		cell.height = approached(cell.height, static_cast<float>(height_code(stroke.value)), share);
	}
	return cell;
}

/// Sets cells and collects the range of those that change.
class Changes {
public:
	Changes(DensityMap &on, int in) : map(on), layer(in) {}

	void set(int column, int row, const DensityCell &cell) {
		if (map.cell(layer, column, row) != cell) {
			map.set_cell(layer, column, row, cell);
			cells.take_in({ column, row, column, row });
		}
	}

	CellRange finish() {
		map.tidy(layer, cells);
		return cells;
	}

private:
	DensityMap &map;
	int layer;
	CellRange cells;
};

/// Sets both densities of all cells in a polygon.
CellRange fill_cells(DensityMap &map, int layer, const Polygon &polygon, uint8_t density, uint16_t plants) {
	const CellRange cells = map.cells_around(bounding_box(polygon));
	Changes changes(map, layer);
	for (int row = cells.first_row; row <= cells.last_row; row++) {
		const double z = static_cast<double>(map.middle_of(0, row).y);
		const AreaRow edges(polygon, {}, z, z);
		for (int column = cells.first_column; column <= cells.last_column; column++) {
			if (edges.holds(map.middle_of(column, row))) {
				DensityCell cell = map.cell(layer, column, row);
				cell.density = density;
				cell.plants = plants;
				changes.set(column, row, cell);
			}
		}
	}
	return changes.finish();
}

template <class Act> void for_each_cell(const CellRange &cells, const Act &act) {
	for (int row = cells.first_row; row <= cells.last_row; row++) {
		for (int column = cells.first_column; column <= cells.last_column; column++) {
			act(column, row);
		}
	}
}

} // namespace

float DensityBrush::weight(float distance) const {
	const float hard = radius * (1.0f - falloff);
	if (distance >= radius || distance < hard) {
		return distance < hard ? 1.0f : 0.0f;
	}
	const float way = (radius - distance) / (radius - hard);
	return way * way * (3.0f - 2.0f * way);
}

bool is_valid(const DensityBrush &brush) {
	const auto is_near = [](float place) { return std::abs(place) <= FARTHEST_COORDINATE; };
	return is_near(brush.centre.x) && is_near(brush.centre.y) && brush.radius > 0.0f &&
			brush.radius <= DensityBrush::MAX_RADIUS && brush.falloff >= 0.0f && brush.falloff <= 1.0f;
}

uint8_t density_code(float density) {
	return static_cast<uint8_t>(std::floor(std::clamp(density, 0.0f, 1.0f) * MAX_CODE + 0.5f));
}

uint8_t height_code(float factor) {
	const float code = std::floor(factor * static_cast<float>(DensityCell::USUAL_HEIGHT) + 0.5f);
	return static_cast<uint8_t>(std::clamp(code, static_cast<float>(DensityCell::MIN_HEIGHT), MAX_CODE));
}

uint16_t plants_code(float plants) {
	return static_cast<uint16_t>(std::floor(exact_plants_code(plants) + 0.5f));
}

CellRange paint(DensityMap &map, int layer, const DensityBrush &brush, const DensityStroke &stroke) {
	const CellRange cells = map.cells_around({ brush.centre - brush.radius, brush.centre + brush.radius });
	// Means use the cells before the stroke.
	const bool smooths = stroke.does == DensityStroke::Does::smooth;
	const DensityMap before = smooths ? map.share() : DensityMap();
	Changes changes(map, layer);
	for_each_cell(cells, [&](int column, int row) {
		const glm::vec2 way = map.middle_of(column, row) - brush.centre;
		const float weight = brush.weight(std::sqrt(way.x * way.x + way.y * way.y));
		if (weight <= 0.0f) {
			return;
		}
		const DensityCell cell = map.cell(layer, column, row);
		if (smooths) {
			const DensityCell mean = mean_around(before, layer, column, row);
			changes.set(column, row, smoothed(cell, mean, weight * stroke.strength));
		} else {
			changes.set(column, row, changed(cell, stroke, weight));
		}
	});
	return changes.finish();
}

CellRange fill_polygon(DensityMap &map, int layer, const Polygon &polygon, float density) {
	return fill_cells(map, layer, polygon, density_code(density), 0);
}

CellRange fill_polygon_plants(DensityMap &map, int layer, const Polygon &polygon, float plants) {
	return fill_cells(map, layer, polygon, 0, plants_code(plants));
}

} // namespace undergrowth
