#pragma once

#include "motion/stem_state.hpp"

#include <glm/vec3.hpp>

namespace undergrowth {

// What acts on a stem at a place x, 0 at its root to 1 at its tip, or on the centre of its head (ON_HEAD). Between
// joints, how far the modes deflect it is taken from both. All vectors are in the frame of the rest. `scale`: the
// length that the constants are for over the plant's own; frequencies and masses are the same for both.

inline constexpr float ON_HEAD = 2.0f;

/// What all plants of a species have in common at x: computed once for many plants.
struct StemPoint {
	float deflection[MAX_STEM_MODES]; ///< φ of the modes (m).
	float give; ///< 2·Σ φ²/stiffness (m/N), not too small to divide by.
	float mass; ///< kg, stem_mass().
};
StemPoint stem_point(const StemConstants &stem, float x);

/// m/s, of a place. Along the stem nothing moves.
glm::vec3 stem_velocity(const StemConstants &stem, const StemState &state, float x, float scale);

/// kg: what moves with a place as a blow feels it, 1/Σ φ²/m; much at the root.
float stem_mass(const StemConstants &stem, float x);

/// A blow (N·s): the place's velocity changes by impulse over stem_mass() across the stem; the root
/// resists the part along the stem.
void apply_stem_impulse(const StemConstants &stem, StemState &state, float x, const glm::vec3 &impulse, float scale);

/// Moves a point by `way` (m) across the stem with minimum bending energy, like a slow push. For moves that are small
/// relative to the stem.
void push_stem(const StemConstants &stem, StemState &state, float x, const glm::vec3 &way, float scale);

// The same with a known point. `bend`: stem_bend() there.
glm::vec3 stem_velocity(
		const StemConstants &stem, const StemState &state, const StemPoint &point, const glm::vec2 &bend, float scale);
void apply_stem_impulse(const StemConstants &stem, StemState &state, const StemPoint &point, const glm::vec2 &bend,
		const glm::vec3 &impulse, float scale);
void push_stem(const StemConstants &stem, StemState &state, const StemPoint &point, const glm::vec2 &bend,
		const glm::vec3 &way, float scale);

} // namespace undergrowth
