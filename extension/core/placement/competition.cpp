#include "placement/competition.hpp"

#include "base/portable_math.hpp"
#include "base/random.hpp"
#include "placement/plant_removal.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace undergrowth {

namespace {

/// Gives competition its own random numbers.
constexpr uint64_t COMPETITION_SEED = 0x3C6EF372FE94F82Bu;
/// Shade is a sum of whole numbers, which does not depend on the order of the plants.
constexpr double FULL_SHADE = 65536.0;
/// Extinction of light at the foot of a larger plant, with full strength.
constexpr double EXTINCTION = 2.0;

/// Plants in the cells of a grid that is as wide as the reach, so that neighbours are in adjacent cells.
class ShadeGrid {
public:
	ShadeGrid(const FieldPlants &of, float reach) : plants(of), side(reach) {
		const auto [low_x, high_x] = std::minmax_element(of.x.begin(), of.x.end());
		const auto [low_z, high_z] = std::minmax_element(of.z.begin(), of.z.end());
		low = { *low_x, *low_z };
		columns = static_cast<int>((*high_x - low.x) / side) + 1;
		rows = static_cast<int>((*high_z - low.y) / side) + 1;
		starts.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) + 1, 0);
		for (std::size_t i = 0; i < of.x.size(); i++) {
			starts[cell(column_of(i), row_of(i)) + 1]++;
		}
		for (std::size_t i = 1; i < starts.size(); i++) {
			starts[i] += starts[i - 1];
		}
		members.resize(of.x.size());
		std::vector<int> ends(starts.begin(), starts.end() - 1);
		for (std::size_t i = 0; i < of.x.size(); i++) {
			members[static_cast<std::size_t>(ends[cell(column_of(i), row_of(i))]++)] = i;
		}
	}

	template <class Visit> void visit_near(std::size_t plant, Visit visit) const {
		const int column = column_of(plant);
		for (int row = std::max(row_of(plant) - 1, 0); row <= std::min(row_of(plant) + 1, rows - 1); row++) {
			const std::size_t first = cell(std::max(column - 1, 0), row);
			const std::size_t last = cell(std::min(column + 1, columns - 1), row);
			for (int i = starts[first]; i < starts[last + 1]; i++) {
				visit(members[static_cast<std::size_t>(i)]);
			}
		}
	}

private:
	const FieldPlants &plants;
	float side; ///< m.
	glm::vec2 low = { 0.0f, 0.0f };
	int columns = 0;
	int rows = 0;
	std::vector<int> starts; ///< Of each cell in `members`, and their end.
	std::vector<std::size_t> members;

	int column_of(std::size_t i) const { return static_cast<int>((plants.x[i] - low.x) / side); }
	int row_of(std::size_t i) const { return static_cast<int>((plants.z[i] - low.y) / side); }
	std::size_t cell(int column, int row) const {
		return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
	}
};

/// What a plant needs to shade others.
struct Crown {
	float dominance = 0.0f;
	float square_radius = 0.0f; ///< m².
	float tolerance = 1.0f;
};

std::vector<Crown> crowns_of(const Competition &competition, const FieldPlants &plants) {
	const float reach = competition.reach();
	std::vector<Crown> crowns(plants.x.size());
	for (std::size_t i = 0; i < crowns.size(); i++) {
		if (plants.species[i] < competition.species.size()) {
			const Competitor &kind = competition.species[plants.species[i]];
			const float radius = std::min(kind.shade_radius * plants.scale[i], reach);
			crowns[i] = { kind.vigor * plants.scale[i] * static_cast<float>(plants.height[i]), radius * radius,
				kind.shade_tolerance };
		}
	}
	return crowns;
}

/// Sum of the shades of larger plants of other species, each from 0 at the side of its crown to FULL_SHADE.
uint64_t shade_at(
		const FieldPlants &plants, const std::vector<Crown> &crowns, const ShadeGrid &grid, std::size_t plant) {
	uint64_t shade = 0;
	grid.visit_near(plant, [&](std::size_t other) {
		if (plants.species[other] == plants.species[plant] || crowns[other].dominance <= crowns[plant].dominance) {
			return;
		}
		const float dx = plants.x[other] - plants.x[plant];
		const float dz = plants.z[other] - plants.z[plant];
		const float square = dx * dx + dz * dz;
		if (square < crowns[other].square_radius) {
			shade += static_cast<uint64_t>(FULL_SHADE *
					(1.0 - static_cast<double>(square) / static_cast<double>(crowns[other].square_radius)));
		}
	});
	return shade;
}

} // namespace

float Competition::reach() const {
	float widest = 0.0f;
	for (const Competitor &kind : species) {
		widest = std::max(widest, kind.shade_radius);
	}
	return is_on() ? std::min(CROWN_SCALE * widest, MAX_RADIUS) : 0.0f;
}

void compete(const Competition &competition, FieldPlants &plants, std::vector<float> &heights,
		std::vector<glm::vec3> &normals) {
	const float reach = competition.reach();
	if (!(reach > 0.0f) || plants.size() == 0) {
		return;
	}
	const std::vector<Crown> crowns = crowns_of(competition, plants);
	const ShadeGrid grid(plants, reach);
	std::vector<int> removed;
	for (std::size_t i = 0; i < plants.x.size(); i++) {
		const uint64_t shade = shade_at(plants, crowns, grid, i);
		if (shade == 0) {
			continue;
		}
		const double light = portable_exp(
				-EXTINCTION * static_cast<double>(competition.strength) * (static_cast<double>(shade) / FULL_SHADE));
		const auto tolerance = static_cast<double>(crowns[i].tolerance);
		const uint64_t bits = bits_of_place(competition.seed ^ COMPETITION_SEED, plants.x[i], plants.z[i]);
		if (!(static_cast<double>(bits >> 32) * (1.0 / 4294967296.0) < tolerance + (1.0 - tolerance) * light)) {
			removed.push_back(static_cast<int>(i));
		}
	}
	remove_plants(removed, plants, heights, normals);
}

} // namespace undergrowth
