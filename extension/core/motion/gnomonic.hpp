#pragma once

#include "motion/joint.hpp"

namespace undergrowth {

/// A tip's motion in the plane that touches the unit sphere at its top: t = (x, z)/y of the direction.
struct GnomonicState {
	float x = 0.0f;
	float z = 0.0f;
	float rate_x = 0.0f; ///< 1/s.
	float rate_z = 0.0f; ///< 1/s.
};

/// The nearest usable state: a unit direction and a finite rate in the tangent plane, 1e4 1/s at most.
TipState safe_state(const TipState &state);

/// Both ways between the sphere and the plane. A direction at or below the horizon becomes one just above it.
GnomonicState to_gnomonic(const TipState &state);
TipState from_gnomonic(const GnomonicState &state);

} // namespace undergrowth
