#pragma once

#include "wind/wind_kernels.hpp"

#include <glm/vec3.hpp>

namespace undergrowth {

/// A local source of wind: an explosion, a fan or rotor above the ground, or the wake of a moving body. Positions are
/// in the local axes of the plants, of which one unit is `scale` metres of the world. Velocities are metres per second
/// along those axes. The vertical part of an explosion's or a fan's air presses stems that are bent.
struct AirSource {
	enum class Kind {
		/// Outward, U·(1 - y)/((1 + (r/radius)²)·(1 + y²)²) with y = (age - r/front)/duration above 0: outward, then
		/// weaker inward (Friedlander's wave without exponentials).
		explosion,
		/// Outward along the ground, 2·U·2x/(1 + x²) with x = r/(1.3·radius) (a jet on a wall); inversely
		/// proportional to the height above six diameters. Eddies are added, also in the middle. By continuity the
		/// air comes down with 2·U·4·h/(1.3·radius·(1 + x²)²), at most 2·U, to plants with three quarters of their
		/// height at h.
		fan,
		/// Potential flow about a sphere, and behind it a wake that spreads as r^(1/3) and slows as r^(-2/3).
		wake,
	};

	Kind kind = Kind::explosion;
	glm::vec3 place = { 0.0f, 0.0f, 0.0f };
	glm::vec3 velocity = { 0.0f, 0.0f, 0.0f }; ///< m/s, of a wake's body.
	float scale = 1.0f; ///< > 0.
	float speed = 0.0f; ///< m/s: U, at the middle of an explosion, or induced by a fan's disc.
	float radius = 1.0f; ///< m of the world, > 0: where an explosion has half its speed; of the disc; of the body.
	float age = 0.0f; ///< s, of an explosion.
	float duration = 0.2f; ///< s, > 0, of an explosion's push.
	float front = 340.0f; ///< m/s, > 0, of an explosion's front.
	float height = 0.0f; ///< m of the world, of a fan above the ground.
	float unrest = 0.0f; ///< Standard deviation of a fan's eddies, over its mean speed or, in the middle, over 2·U.
	float eddies = 0.0f; ///< Turns of a fan's eddies so far, at eddy_rate(). They repeat after EDDY_TURNS.
};

constexpr float EDDY_TURNS = 64.0f;
/// Turns a second of the eddies of a fan with this induced speed (m/s) and radius (m).
float eddy_rate(float speed, float radius);

/// The speed that a disc of `radius` (m) induces to push with `thrust` (N): √(F/2ρπR²).
float induced_speed(float thrust, float radius);

/// Radius outside of which a source has no effect (m of the world).
float reach_of(const AirSource &source);
/// True if the source has an effect anywhere in a box of roots.
bool reaches(const AirSource &source, const glm::vec3 &low, const glm::vec3 &high);

/// Velocity that the source adds to the wind at a plant of `height` (in the units of the axes): where the plant is at
/// the height of the source, or else at its nearer end. A wake's is horizontal.
glm::vec3 velocity_at(const AirSource &source, const glm::vec3 &root, float height = 0.0f);

/// True if any source reaches the box of roots.
bool any_reaches(const AirSources &sources, const glm::vec3 &low, const glm::vec3 &high);
/// Adds the velocities of all sources that reach the box to out_x, out_y (or null) and out_z of `count` plants in it,
/// by their roots and heights.
void add_sources(const AirSources &sources, const glm::vec3 &low, const glm::vec3 &high, const float *x, const float *y,
		const float *z, const float *heights, int count, float *out_x, float *out_y, float *out_z);

} // namespace undergrowth
