#include "conventions.hpp"
#include "placement/placement.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

/// True if `value` is a number from `min` to `max`.
bool is_within(double value, double min, double max) {
	return value >= min && value <= max;
}

bool is_bad_exclusion(const Polygon &polygon) {
	const AreaFault fault = find_area_fault(polygon);
	return fault == AreaFault::not_finite || fault == AreaFault::too_far;
}

PlacementFault find_species_fault(const PlacementSpecies &species) {
	constexpr double LARGEST = 3.4e38;
	if (!is_within(species.weight, 0.0, LARGEST)) {
		return PlacementFault::bad_weight;
	}
	if (species.variants < 1 || species.variants > 256) {
		return PlacementFault::bad_variants;
	}
	if (!(species.min_scale > 0.0f) || !is_within(species.max_scale, species.min_scale, LARGEST)) {
		return PlacementFault::bad_scale;
	}
	const bool is_in_range =
			is_within(species.height_deviation, 0.0, 1.0) && is_within(species.max_lean, 0.0, 0.5001 * PI);
	return is_in_range ? PlacementFault::none : PlacementFault::bad_deviation;
}

PlacementFault find_all_species_fault(const std::vector<PlacementSpecies> &all) {
	if (all.empty()) {
		return PlacementFault::no_species;
	}
	if (all.size() > PlacementRequest::MAX_SPECIES) {
		return PlacementFault::too_many_species;
	}
	// Reports the fault of the list that comes first in the enumeration.
	std::vector<PlacementFault> faults(all.size());
	std::transform(all.begin(), all.end(), faults.begin(), find_species_fault);
	faults.erase(std::remove(faults.begin(), faults.end(), PlacementFault::none), faults.end());
	const auto has_weight = [](const PlacementSpecies &species) { return species.weight > 0.0f; };
	const bool all_zero = std::none_of(all.begin(), all.end(), has_weight);
	if (all_zero) {
		faults.push_back(PlacementFault::no_weight);
	}
	return faults.empty() ? PlacementFault::none : *std::min_element(faults.begin(), faults.end());
}

bool are_too_many(const PlacementRequest &request) {
	if (request.map) {
		return false; // Only Placement measures the painted part of the area.
	}
	const double cells_a_metre = std::sqrt(static_cast<double>(request.density));
	const AreaBox box = placed_box(request);
	const double width = std::max(box.high.x - box.low.x, 0.0f);
	const double depth = std::max(box.high.y - box.low.y, 0.0f);
	const double area = std::min(std::abs(signed_area(request.area)), width * depth);
	return area * request.density > PlacementRequest::MAX_PLANTS ||
			std::max(width, depth) * cells_a_metre > PlacementRequest::MAX_PLANTS;
}

} // namespace

AreaBox placed_box(const PlacementRequest &request) {
	const AreaBox box = bounding_box(request.area);
	return request.within ? common_box(box, *request.within) : box;
}

PlacementFault find_placement_fault(const PlacementRequest &request) {
	if (find_area_fault(request.area) != AreaFault::none) {
		return PlacementFault::bad_area;
	}
	if (std::any_of(request.exclusions.begin(), request.exclusions.end(), is_bad_exclusion)) {
		return PlacementFault::bad_exclusion;
	}
	if (!is_within(request.density, 0.0, PlacementRequest::MAX_DENSITY)) {
		return PlacementFault::bad_density;
	}
	const PlacementFault fault = find_all_species_fault(request.species);
	if (fault != PlacementFault::none) {
		return fault;
	}
	if (!is_within(request.clumping, 0.0, 1.0) || !is_within(request.drift_size, 0.01f, FARTHEST_COORDINATE)) {
		return PlacementFault::bad_clumping;
	}
	if (!is_within(request.combed, 0.0, 1.0)) {
		return PlacementFault::bad_combed;
	}
	if (!is_within(request.edge_falloff, 0.0, PlacementRequest::MAX_FALLOFF)) {
		return PlacementFault::bad_falloff;
	}
	return are_too_many(request) ? PlacementFault::too_many_plants : PlacementFault::none;
}

const char *describe(PlacementFault fault) {
	switch (fault) {
		case PlacementFault::none:
			return "The field is sound.";
		case PlacementFault::bad_area:
			return "The field's area is empty: set at least three points that are not on one line.";
		case PlacementFault::bad_exclusion:
			return "An exclusion has a point that is not finite or more than 100 km away: set it again.";
		case PlacementFault::bad_density:
			return "The density must be from 0 to 10000 plants per square metre.";
		case PlacementFault::no_species:
			return "The field has no species: add one.";
		case PlacementFault::too_many_species:
			return "The field has more than 256 species: distribute them over several fields.";
		case PlacementFault::bad_weight:
			return "The weight of a species must be 0 or more.";
		case PlacementFault::no_weight:
			return "All species have a weight of 0: set the weight of at least one.";
		case PlacementFault::bad_variants:
			return "A species must have 1 to 256 variants.";
		case PlacementFault::bad_scale:
			return "The scale range of a species must be above 0, with the smaller number first.";
		case PlacementFault::bad_deviation:
			return "The height deviation of a species must be from 0 to 1, and its lean from 0 to 90°.";
		case PlacementFault::bad_clumping:
			return "Clumping must be from 0 to 1, and the size of clumps from 1 cm to 100 km.";
		case PlacementFault::bad_combed:
			return "Combed must be from 0 to 1.";
		case PlacementFault::bad_falloff:
			return "The edge falloff must be from 0 to 100 m.";
		case PlacementFault::too_many_plants:
			return "The field would have more than 4 million plants: reduce the density or the area.";
	}
	return "";
}

} // namespace undergrowth
