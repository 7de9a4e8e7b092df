#pragma once

#include "wind/wind_kernels.hpp"

#include <glm/vec3.hpp>

namespace undergrowth {

/// What stirs the air at one place: an explosion, a fan or a rotor above, a body that moves. Ready for plants whose
/// roots are told in axes of their own, `scale` metres of the world to one of theirs; velocities are in metres per
/// second, along those axes. Only the horizontal part moves plants.
struct AirSource {
	enum class Kind {
		/// Outward, U·(1 - y)/((1 + (r/radius)²)·(1 + y²)²) with y = (age - r/front)/duration above 0: out and, weaker,
		/// back again (Friedlander's wave without exponentials).
		explosion,
		/// Outward along the ground, 2·U·2x/(1 + x²) with x = r/(1.3·radius) (a jet on a wall); from six diameters
		/// above
		/// the ground on, in inverse proportion to the height.
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
};

/// The speed that a disc of `radius` (m) induces to push with `thrust` (N): √(F/2ρπR²).
float induced_speed(float thrust, float radius);

/// How far from its place a source is felt at all (m of the world).
float reach_of(const AirSource &source);
/// Whether it is felt anywhere in a box of roots.
bool reaches(const AirSource &source, const glm::vec3 &low, const glm::vec3 &high);

/// What it adds to the velocity at a root.
glm::vec3 velocity_at(const AirSource &source, const glm::vec3 &root);

/// Adds what those do that reach a box of roots to velocities out_x and out_z of `count` plants. Tells whether any
/// does.
bool any_reaches(const AirSources &sources, const glm::vec3 &low, const glm::vec3 &high);
/// Adds what those do that reach it to velocities out_x and out_z of `count` plants whose roots are in it.
void add_sources(const AirSources &sources, const glm::vec3 &low, const glm::vec3 &high, const float *x, const float *y,
		const float *z, int count, float *out_x, float *out_z);

} // namespace undergrowth
