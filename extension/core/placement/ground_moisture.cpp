#include "placement/ground_moisture.hpp"

#include "base/portable_math.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <utility>

namespace undergrowth {

namespace {

constexpr double DIAGONAL = 1.4142135623730951;
/// Of the slopes towards lower neighbours, by which water is divided (Freeman 1991).
constexpr double FLOW_EXPONENT = 1.1;
/// m. A filled pit is deeper than rounding.
constexpr double PIT_DEPTH = 0.001;

struct Neighbour {
	int column;
	int row;
	double distance; ///< In steps.
};

constexpr std::array<Neighbour, 8> NEIGHBOURS = { { { 1, 0, 1.0 }, { -1, 0, 1.0 }, { 0, 1, 1.0 }, { 0, -1, 1.0 },
		{ 1, 1, DIAGONAL }, { -1, 1, DIAGONAL }, { 1, -1, DIAGONAL }, { -1, -1, DIAGONAL } } };

/// The ground with filled pits, and the order in which water reaches its points from the outlets (priority flood,
/// Barnes et al. 2014).
class FilledGround {
public:
	explicit FilledGround(const HeightGrid &of) : grid(of), levels(of.size(), 0.0), outlets(of.size(), -1) {
		for (int row = 0; row < grid.rows; row++) {
			for (int column = 0; column < grid.columns; column++) {
				if (is_ground(column, row) && is_border(column, row)) {
					const std::size_t here = grid.index(column, row);
					enter(here, static_cast<double>(grid.heights[here]), static_cast<int64_t>(here));
				}
			}
		}
		while (!waiting.empty()) {
			const std::size_t here = waiting.top().point;
			waiting.pop();
			order.push_back(here);
			visit_neighbours(here, [&](std::size_t next, double) {
				if (outlets[next] < 0) {
					enter(next, std::max(levels[here], static_cast<double>(grid.heights[next])),
							static_cast<int64_t>(here));
				}
			});
		}
	}

	/// From the lowest outlet up: a point comes after all lower ones.
	const std::vector<std::size_t> &flood_order() const { return order; }
	double level(std::size_t point) const { return levels[point]; }
	bool is_outlet(std::size_t point) const { return outlets[point] == static_cast<int64_t>(point); }
	/// The point from which the flood reached this one: water of level ground flows there.
	std::size_t outlet(std::size_t point) const { return static_cast<std::size_t>(outlets[point]); }

	template <class Visit> void visit_neighbours(std::size_t here, Visit visit) const {
		const auto width = static_cast<std::size_t>(grid.columns);
		const int column = static_cast<int>(here % width);
		const int row = static_cast<int>(here / width);
		for (const Neighbour &neighbour : NEIGHBOURS) {
			if (is_ground(column + neighbour.column, row + neighbour.row)) {
				visit(grid.index(column + neighbour.column, row + neighbour.row), neighbour.distance);
			}
		}
	}

private:
	struct Entry {
		double level;
		uint64_t number; ///< Of entries, so that equal levels have one order.
		std::size_t point;

		bool operator<(const Entry &other) const {
			return level > other.level || (level == other.level && number > other.number);
		}
	};

	const HeightGrid &grid;
	std::vector<double> levels;
	std::vector<int64_t> outlets; ///< -1: not reached.
	std::vector<std::size_t> order;
	std::priority_queue<Entry> waiting; ///< The lowest first.
	uint64_t entry_count = 0;

	bool is_ground(int column, int row) const {
		return column >= 0 && row >= 0 && column < grid.columns && row < grid.rows &&
				std::isfinite(grid.heights[grid.index(column, row)]);
	}

	bool is_border(int column, int row) const {
		return std::any_of(NEIGHBOURS.begin(), NEIGHBOURS.end(),
				[&](const Neighbour &neighbour) { return !is_ground(column + neighbour.column, row + neighbour.row); });
	}

	void enter(std::size_t point, double level, int64_t outlet) {
		levels[point] = level;
		outlets[point] = outlet;
		waiting.push({ level, entry_count++, point });
	}
};

/// Passes the water of a point to its lower neighbours.
void pass_on(const FilledGround &ground, std::size_t here, std::vector<double> &areas) {
	std::array<std::pair<std::size_t, double>, NEIGHBOURS.size()> lower;
	std::size_t count = 0;
	double sum = 0.0;
	ground.visit_neighbours(here, [&](std::size_t next, double distance) {
		const double fall = ground.level(here) - ground.level(next);
		if (fall > 0.0) {
			const double part = portable_pow(fall / distance, FLOW_EXPONENT);
			lower[count++] = { next, part };
			sum += part;
		}
	});
	if (!(sum > 0.0) && !ground.is_outlet(here)) {
		areas[ground.outlet(here)] += areas[here];
	}
	for (std::size_t i = 0; i < count; i++) {
		areas[lower[i].first] += areas[here] * (lower[i].second / sum);
	}
}

std::vector<double> drain(const HeightGrid &grid, const FilledGround &ground) {
	const double own = static_cast<double>(grid.step) * static_cast<double>(grid.step);
	std::vector<double> areas(grid.size(), 0.0);
	for (const std::size_t point : ground.flood_order()) {
		areas[point] = own;
	}
	std::for_each(ground.flood_order().rbegin(), ground.flood_order().rend(),
			[&](std::size_t point) { pass_on(ground, point, areas); });
	return areas;
}

} // namespace

std::vector<double> find_drained_areas(const HeightGrid &grid) {
	return drain(grid, FilledGround(grid));
}

HabitatRaster find_moisture(const HeightGrid &grid) {
	const FilledGround ground(grid);
	const std::vector<double> areas = drain(grid, ground);
	HabitatRaster raster = grid.raster(0.0f);
	for (const std::size_t point : ground.flood_order()) {
		const auto width = static_cast<std::size_t>(grid.columns);
		const glm::dvec2 slope = grid.gradient(static_cast<int>(point % width), static_cast<int>(point / width));
		const double steepness = std::max(std::sqrt(slope.x * slope.x + slope.y * slope.y), MIN_DRAINING_SLOPE);
		const double index = portable_log(areas[point] / static_cast<double>(grid.step) / steepness);
		const bool is_pit = ground.level(point) > static_cast<double>(grid.heights[point]) + PIT_DEPTH;
		raster.values[point] = is_pit ? 1.0f : static_cast<float>(std::clamp(index / WETTEST_INDEX, 0.0, 1.0));
	}
	return raster;
}

} // namespace undergrowth
