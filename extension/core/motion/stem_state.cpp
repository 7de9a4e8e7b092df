#include "motion/stem_state.hpp"

#include "motion/gnomonic.hpp"
#include "motion/part_bend.hpp"
#include "stem/stem_shape.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float EPSILON = 1e-6f;

glm::vec2 divided(const glm::vec2 &a, const glm::vec2 &b) {
	const float scale = 1.0f / std::max(glm::dot(b, b), EPSILON * EPSILON);
	return glm::vec2(a.x * b.x + a.y * b.y, a.y * b.x - a.x * b.y) * scale;
}

/// Product with the complex conjugate of `a`.
glm::vec2 multiplied(const glm::vec2 &a, const glm::vec2 &b) {
	return { a.x * b.x + a.y * b.y, a.x * b.y - a.y * b.x };
}

/// Rate of a direction from the rate of its bend.
glm::vec3 rate_of_direction(const glm::vec2 &bend, const glm::vec2 &rate) {
	const float scale = 1.0f / (1.0f + glm::dot(bend, bend));
	const float growth = 2.0f * glm::dot(bend, rate) * scale;
	const glm::vec2 across = 2.0f * scale * (rate - growth * bend);
	return { across.x, -2.0f * growth * scale, across.y };
}

glm::vec2 rate_of_bend(const glm::vec3 &direction, const glm::vec3 &rate) {
	const float scale = 1.0f / std::max(1.0f + direction.y, EPSILON);
	const glm::vec2 bend = glm::vec2(direction.x, direction.z) * scale;
	return (glm::vec2(rate.x, rate.z) - bend * rate.y) * scale;
}

/// `v`, shortened to `max` if it is longer; zero if it is not a number.
glm::vec2 no_longer(const glm::vec2 &v, float max) {
	const float largest = std::max(std::fabs(v.x), std::fabs(v.y));
	if (largest > 0.0f && glm::dot(v, v) < 0.999f * max * max) {
		return v; // Surely no longer, without a division and a root.
	}
	if (!std::isfinite(v.x) || !std::isfinite(v.y) || largest <= 0.0f) {
		return { 0.0f, 0.0f };
	}
	const float size = largest * glm::length(v / largest); // Avoids squares of large numbers.
	return size > max ? v * (max / size) : v;
}

} // namespace

// A turn of the sphere about a horizontal axis is a Möbius map of the stereographic plane.
glm::vec2 out_of_rest(const glm::vec2 &bend, const glm::vec2 &rest) {
	return divided(bend + rest, glm::vec2(1.0f, 0.0f) - multiplied(rest, bend));
}

glm::vec2 into_rest(const glm::vec2 &bend, const glm::vec2 &rest) {
	return divided(bend - rest, glm::vec2(1.0f, 0.0f) + multiplied(rest, bend));
}

glm::vec2 tip_bend(const StemConstants &stem, const StemState &state) {
	glm::vec2 bend = { 0.0f, 0.0f };
	for (int k = 0; k < stem.modes; k++) {
		bend += state.place[k] * stem.mode[k].tip_slope;
	}
	return bend;
}

TipState tip_state(const StemConstants &stem, const StemState &state, const glm::vec2 &rest) {
	glm::vec2 rate = { 0.0f, 0.0f };
	for (int k = 0; k < stem.modes; k++) {
		rate += state.rate[k] * stem.mode[k].tip_slope;
	}
	const glm::vec2 bend = tip_bend(stem, state);
	return safe_state({ turned(from_stereographic(bend), rest), turned(rate_of_direction(bend, rate), rest) });
}

StemState safe_stem(const StemConstants &stem, const StemState &state) {
	StemState safe;
	for (int k = 0; k < stem.modes; k++) {
		safe.place[k] = no_longer(state.place[k], MAX_STEM_AMPLITUDE);
		safe.rate[k] = no_longer(state.rate[k], MAX_STEM_RATE * stem.mode[k].frequency);
	}
	return safe;
}

StemBends bends_of(const StemConstants &stem, const StemState &state, const glm::vec2 &rest) {
	return { pack_bend(out_of_rest(state.place[0] * stem.mode[0].tip_slope, rest)),
		pack_bend(state.place[1] * stem.mode[1].tip_slope) };
}

StemBends bends_in_modes(const StemConstants &stem, const StemBends &bends, const glm::vec2 &rest) {
	StemState state;
	divide_tip(stem, into_rest(stereographic(bends.first), rest) + stereographic(bends.second), state.place);
	return bends_of(stem, state, rest);
}

void divide_tip(const StemConstants &stem, const glm::vec2 &tip, glm::vec2 *modes) {
	for (int k = 0; k < stem.modes; k++) {
		modes[k] = stem.modes == 1 ? tip / stem.mode[k].tip_slope : tip * stem.mode[k].dead_share;
	}
}

/// The second mode's part of the tip's bend, minus its share of the sum of both.
static glm::vec2 beyond_share(const StemConstants &stem, const glm::vec2 *modes) {
	const glm::vec2 second = modes[1] * stem.mode[1].tip_slope;
	return second - (1.0f - first_share(stem)) * (modes[0] * stem.mode[0].tip_slope + second);
}

StemSecond second_of(const StemConstants &stem, const StemState &state, const glm::vec2 &rest) {
	if (stem.modes == 1) {
		return {};
	}
	const glm::vec2 bend = beyond_share(stem, state.place);
	const glm::vec2 rate = beyond_share(stem, state.rate);
	return { turned({ bend.x, 0.0f, bend.y }, rest), turned({ rate.x, 0.0f, rate.y }, rest) };
}

MotionState motion_between(
		const StemConstants &stem, const ModeBends &before, const ModeBends &now, const glm::vec2 &rest, float step) {
	const glm::vec2 was[] = { into_rest(before.first, rest), before.second };
	const glm::vec2 is[] = { into_rest(now.first, rest), now.second };
	StemState state;
	for (int k = 0; k < stem.modes; k++) {
		state.place[k] = is[k] / stem.mode[k].tip_slope;
		state.rate[k] = (is[k] - was[k]) / (step * stem.mode[k].tip_slope);
	}
	state = safe_stem(stem, state);
	return { tip_state(stem, state, rest), second_of(stem, state, rest) };
}

/// Moves a part of the tip's bend, or of its rate, from the first mode to the second.
static void move_over(const StemConstants &stem, const glm::vec3 &more, const glm::vec2 &rest, glm::vec2 *modes) {
	const glm::vec3 here = turned(more, -rest);
	const glm::vec2 across(here.x, here.z);
	modes[0] -= across / stem.mode[0].tip_slope;
	modes[1] += across / stem.mode[1].tip_slope;
}

StemState stem_state(const StemConstants &stem, const TipState &tip, const glm::vec2 &rest, const StemSecond &second) {
	const TipState safe = safe_state(tip);
	const glm::vec3 direction = turned(safe.direction, -rest);
	const glm::vec3 rate = turned(safe.rate, -rest);
	const float height = std::max(1.0f + direction.y, EPSILON);
	StemState state;
	for (int k = 0; k < stem.modes; k++) {
		const StemMode &mode = stem.mode[k];
		const float scale = stem.modes == 1 ? 1.0f / (height * mode.tip_slope) : mode.dead_share / height;
		state.place[k] = glm::vec2(direction.x, direction.z) * scale;
	}
	divide_tip(stem, rate_of_bend(direction, rate), state.rate);
	if (stem.modes == 2) {
		move_over(stem, second.bend, rest, state.place);
		move_over(stem, second.rate, rest, state.rate);
	}
	return safe_stem(stem, state);
}

} // namespace undergrowth
