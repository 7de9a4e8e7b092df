#pragma once

#include "stem/stem_constants.hpp"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace undergrowth {

/// Blows and pushes on a stem. `places` and `rates` (1/s) are the amplitudes of its modes, one of each; vectors are
/// seen from the frame of its rest direction, and `scale` is the length that `stem` is for over the plant's own. Joints
/// are 1 to stem.joints from the bottom to the tip; stem.joints + 1 is the head's centre. A bent stem is as heavy
/// across itself as an upright one; along itself the root holds it.

/// kg: what a blow across the stem has to move at a joint. Its speed changes by impulse/mass.
float mass_at_joint(const StemConstants &stem, int joint);

/// m/s.
glm::vec3 velocity_of_joint(
		const StemConstants &stem, const glm::vec2 *places, const glm::vec2 *rates, int joint, float scale = 1.0f);

/// A blow (N·s) on a joint changes the rates, which stay within MOST_BLOWN_RATE of each mode's frequency.
void strike_stem(const StemConstants &stem, const glm::vec2 *places, glm::vec2 *rates, int joint,
		const glm::vec3 &impulse, float scale = 1.0f);

/// Moves a joint by `way` (m) the easiest way: what springs store grows least. Amplitudes stay within
/// MOST_PUSHED_PLACE.
void push_stem(const StemConstants &stem, glm::vec2 *places, int joint, const glm::vec3 &way, float scale = 1.0f);

inline constexpr float MOST_BLOWN_RATE = 6.0f; ///< Over the frequency in rad/s.
inline constexpr float MOST_PUSHED_PLACE = 1.5f; ///< As in the steps.

} // namespace undergrowth
