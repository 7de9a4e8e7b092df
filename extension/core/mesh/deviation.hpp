#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>

namespace undergrowth {

/// Bearing of a ring's point around the axis: cosine and sine of one, two and three times its angle. Zero for a point
/// on the axis. (No initial values: meshes have an array of these and use part of it or none.)
struct Bearing {
	glm::vec2 once;
	glm::vec2 twice;
	glm::vec2 thrice;
};

Bearing make_bearing(glm::vec2 point);

/// The small irregularities of one plant (thesis, section 5.1.1): smooth random functions of offset and bearing only.
/// All levels of detail of one seed therefore show the same plant.
class Deviation {
public:
	/// Deviation of one ring from the regular shape.
	struct Ring {
		glm::vec2 center = glm::vec2(0.0f); ///< Shift as a fraction of the plant's height; 0 at the ground.
		float scale = 1.0f;
		glm::vec2 twice = glm::vec2(0.0f);
		glm::vec2 thrice = glm::vec2(0.0f);
		float brightness = 1.0f;
		float hue = 0.0f;
		glm::vec2 shade = glm::vec2(0.0f);

		/// Factor of the distance of a point from the axis, above 0.
		float stretch(const Bearing &bearing) const;
		/// Returns the colour of a point; alpha does not change. Components stay in [0, 1].
		glm::vec4 tint(const glm::vec4 &untinted, const Bearing &bearing) const;
	};

	/// Both amounts are from 0 to 1. If both are 0, do not call at().
	Deviation(float shape, float color, uint64_t seed);

	Ring at(float offset) const;

private:
	// Cubic B-splines over equal spans of the height: smooth, local and cheap.
	static constexpr int SPANS = 4;
	static constexpr int KNOTS = SPANS + 3;
	enum Channel {
		CENTER_X,
		CENTER_Z,
		SCALE,
		TWICE_X,
		TWICE_Z,
		THRICE_X,
		THRICE_Z,
		BRIGHTNESS,
		HUE,
		SHADE_X,
		SHADE_Z,
		CHANNELS
	};

	float shape;
	float color;
	float knots[KNOTS][CHANNELS];
	float plant_brightness;
	float plant_hue;
};

} // namespace undergrowth
