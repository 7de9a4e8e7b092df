#pragma once

#include "placement/habitat_curve.hpp"
#include "placement/habitat_raster.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace undergrowth {

/// What the suitability of a position depends on.
enum class HabitatFactor : uint8_t {
	slope, ///< rad.
	height, ///< m, field axes.
	texture, ///< Value of the habitat's texture.
	moisture, ///< 0 to 1, of a HabitatSurvey.
	light, ///< 0 to 1, of a HabitatSurvey.
	distance, ///< m, from the habitat's lines.
	value, ///< Suitability by the habitat's values in a HabitatSurvey, which its curve has already been applied to.
};

inline constexpr std::size_t HABITAT_FACTORS = 7;

/// The factors at a position.
struct HabitatPlace {
	std::array<float, HABITAT_FACTORS> factors{};

	float &operator[](HabitatFactor factor) { return factors[static_cast<std::size_t>(factor)]; }
	float operator[](HabitatFactor factor) const { return factors[static_cast<std::size_t>(factor)]; }
};

/// Where a species grows: a curve for each factor. Their product is the suitability.
struct Habitat {
	std::array<HabitatCurve, HABITAT_FACTORS> curves; ///< One that is not set ignores its factor.
	HabitatRaster texture;

	HabitatCurve &curve(HabitatFactor factor) { return curves[static_cast<std::size_t>(factor)]; }
	const HabitatCurve &curve(HabitatFactor factor) const { return curves[static_cast<std::size_t>(factor)]; }
	bool uses(HabitatFactor factor) const { return curve(factor).is_set(); }
	/// Chance from 0 to 1 that a plant grows there.
	double suitability(const HabitatPlace &place) const;
};

} // namespace undergrowth
