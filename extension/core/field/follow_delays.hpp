#pragma once

#include "wind/field_wind.hpp"

#include <glm/common.hpp>

namespace undergrowth {

/// Delay of the wind at a position relative to the prototypes, in steps: `base` at the origin plus a slope per metre of
/// x and z, clamped to [0, LONGEST_WAY].
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

/// Present delays of followers. When the wind turns or changes its speed, or distant plants are added, all delays
/// change. Followers then blend from the old delays to the new ones within a second. Further changes wait for the next
/// second.
class FollowDelays {
public:
	static constexpr float GOING_OVER = 1.0f; ///< s.

	explicit FollowDelays(float step);

	/// Sets the delays without blending.
	void set(const DelayPlane &plane);
	/// Starts blending to `plane` at the next step.
	void want(const DelayPlane &plane) { wanted = plane; }
	/// Advances by one step.
	void step();

	const DelayPlane &before() const { return old_plane; }
	const DelayPlane &after() const { return new_plane; }
	/// Weight of after(), `fraction` of a step after the present one started; before() has the rest.
	float share(float fraction) const;

private:
	DelayPlane old_plane, new_plane, wanted;
	int max_steps;
	int steps; ///< Steps since blending started; max_steps + 1 when complete.
};

} // namespace undergrowth
