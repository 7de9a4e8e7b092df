#pragma once

#include "wind/travelling_wind.hpp"

#include <glm/common.hpp>

namespace undergrowth {

/// How many steps after the prototypes the wind comes to a place: `base` at the origin, and more by metre of x and z.
/// Beyond LONGEST_WAY, and before 0, the way ends: plants there show what those at the end do.
struct DelayPlane {
	static constexpr int LONGEST_WAY = 896; ///< Steps.

	float x = 0.0f;
	float z = 0.0f;
	float base = 0.0f;

	float at(float place_x, float place_z) const {
		return glm::clamp(base + (x * place_x + z * place_z), 0.0f, static_cast<float>(LONGEST_WAY));
	}
	bool operator==(const DelayPlane &other) const { return x == other.x && z == other.z && base == other.base; }
	bool operator!=(const DelayPlane &other) const { return !(*this == other); }
};

/// The delays that followers have now. Where the wind turns or gets faster, or far plants come, all delays become
/// others; what followers show then goes over from the old delays to the new ones within a second, so that none jumps.
/// What changes meanwhile waits for the next second.
class FollowDelays {
public:
	static constexpr float GOING_OVER = 1.0f; ///< s.

	explicit FollowDelays(float step);

	/// Without going over: nobody has seen the old ones.
	void set(const DelayPlane &plane);
	/// Where to go from the next step on.
	void want(const DelayPlane &plane) { wanted = plane; }
	/// To the present step.
	void step();

	const DelayPlane &before() const { return old_plane; }
	const DelayPlane &after() const { return new_plane; }
	/// How much of after() followers show, `fraction` of a step after the present one began; the rest is of before().
	float share(float fraction) const;

private:
	DelayPlane old_plane, new_plane, wanted;
	int most_steps;
	int steps; ///< Since it began to go over; one more than most_steps where it is there.
};

} // namespace undergrowth
