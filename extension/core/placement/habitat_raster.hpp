#pragma once

#include "placement/habitat_curve.hpp"

#include <glm/vec2.hpp>

#include <vector>

namespace undergrowth {

/// Values at the centres of square or rectangular cells of the field's ground plane, bilinear between them.
struct HabitatRaster {
	glm::vec2 low = { 0.0f, 0.0f }; ///< m, corner of the first cell.
	glm::vec2 cell = { 1.0f, 1.0f }; ///< m, > 0.
	int columns = 0;
	int rows = 0;
	bool repeats = false; ///< Beyond its sides. False: continues the values at its border.
	std::vector<float> values; ///< Row by row.

	bool is_empty() const { return values.empty(); }
	/// Value at a position (m); 1 without values.
	float at(const glm::vec2 &place) const;
	/// The same with the values that a curve gives for those of the cells: between the numbers 1 and 3 of two kinds of
	/// ground there is none of kind 2.
	float at(const glm::vec2 &place, const HabitatCurve &curve) const;

private:
	template <class Value> float mix(const glm::vec2 &place, Value value_at) const;
	float value(double column, double row) const;
};

} // namespace undergrowth
