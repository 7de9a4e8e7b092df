#include "mesh/deviation.hpp"

#include "base/random.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace undergrowth {

namespace {

// Maxima of a full deviation. The sum for the shape stays below 1, so that no ring turns inside out.
constexpr float CENTER_SHARE = 0.06f; // Fraction of the height.
constexpr float SCALE_SHARE = 0.22f;
constexpr float TWICE_SHARE = 0.16f;
constexpr float THRICE_SHARE = 0.12f;
constexpr float BRIGHTNESS_SHARE = 0.25f;
constexpr float HUE_SHARE = 0.18f;
constexpr float SHADE_SHARE = 0.15f;
// Fraction of brightness and hue that is common to the whole plant. A meadow shows it more than spots on one plant.
constexpr float WHOLE_PLANT_SHARE = 0.6f;

} // namespace

Bearing make_bearing(glm::vec2 point) {
	const float length = glm::length(point);
	if (!(length > 0.0f)) {
		return { glm::vec2(0.0f), glm::vec2(0.0f), glm::vec2(0.0f) };
	}
	const glm::vec2 once = point / length;
	const glm::vec2 twice = { once.x * once.x - once.y * once.y, 2.0f * once.x * once.y };
	return { once, twice, { twice.x * once.x - twice.y * once.y, twice.y * once.x + twice.x * once.y } };
}

float Deviation::Ring::stretch(const Bearing &bearing) const {
	return scale + glm::dot(twice, bearing.twice) + glm::dot(thrice, bearing.thrice);
}

glm::vec4 Deviation::Ring::tint(const glm::vec4 &untinted, const Bearing &bearing) const {
	const float light = brightness + glm::dot(shade, bearing.once);
	const glm::vec4 tinted = { untinted.x * light * (1.0f + hue), untinted.y * light, untinted.z * light * (1.0f - hue),
		untinted.w };
	return { glm::clamp(glm::vec3(tinted), 0.0f, 1.0f), untinted.w };
}

Deviation::Deviation(float p_shape, float p_color, uint64_t seed) : shape(p_shape), color(p_color) {
	if (shape <= 0.0f && color <= 0.0f) {
		return; // at() is not called, and most meshes are regular.
	}
	uint64_t index = 0;
	for (auto &row : knots) {
		for (float &knot : row) {
			knot = signed_noise(seed, index++);
		}
	}
	plant_brightness = signed_noise(seed, index++);
	plant_hue = signed_noise(seed, index);
}

Deviation::Ring Deviation::at(float offset) const {
	const float place = offset * SPANS;
	const int span = std::clamp(static_cast<int>(place), 0, SPANS - 1);
	const float t = place - static_cast<float>(span);
	const float s = 1.0f - t;
	const float share[4] = { s * s * s / 6.0f, (4.0f - 6.0f * t * t + 3.0f * t * t * t) / 6.0f,
		(4.0f - 6.0f * s * s + 3.0f * s * s * s) / 6.0f, t * t * t / 6.0f };
	float value[CHANNELS];
	for (int i = 0; i < CHANNELS; i++) {
		value[i] = share[0] * knots[span][i] + share[1] * knots[span + 1][i] + share[2] * knots[span + 2][i] +
				share[3] * knots[span + 3][i];
	}

	const float spots = 1.0f - WHOLE_PLANT_SHARE;
	Ring ring;
	ring.center = glm::vec2(value[CENTER_X], value[CENTER_Z]) * (CENTER_SHARE * shape * offset);
	ring.scale = 1.0f + SCALE_SHARE * shape * value[SCALE];
	ring.twice = glm::vec2(value[TWICE_X], value[TWICE_Z]) * (TWICE_SHARE * shape);
	ring.thrice = glm::vec2(value[THRICE_X], value[THRICE_Z]) * (THRICE_SHARE * shape);
	ring.brightness =
			1.0f + BRIGHTNESS_SHARE * color * (WHOLE_PLANT_SHARE * plant_brightness + spots * value[BRIGHTNESS]);
	ring.hue = HUE_SHARE * color * (WHOLE_PLANT_SHARE * plant_hue + spots * value[HUE]);
	ring.shade = glm::vec2(value[SHADE_X], value[SHADE_Z]) * (SHADE_SHARE * color);
	return ring;
}

} // namespace undergrowth
