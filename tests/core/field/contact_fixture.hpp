#pragma once

#include "field/contact.hpp"
#include "field_fixture.hpp"

#include <glm/geometric.hpp>

/// Fixture of the tests of contact: tips that touch.
namespace undergrowth {

inline constexpr Law BOTH_LAWS[] = { Law::elasticity, Law::spring };
inline constexpr float RADIUS = 0.1f; // m.
inline constexpr float APART_TOLERANCE = 0.003f; // m. Contact is solved once per step and moves each tip half the way.
// Overlap of fast tips that is allowed after the step in which they meet.
inline constexpr float DEEPEST = 0.25f * RADIUS;
/// Relative to the max energy of the same swing without contact, which varies slightly by the error of the step.
inline constexpr double ENERGY_TOLERANCE = 1e-3;
inline constexpr float REST_SPEED = 1e-3f; // 1/s.

inline MotionSpecies tips_of(Law law) {
	MotionSpecies species = species_of(law);
	species.collision_radius = RADIUS;
	species.joint.inner_friction = 0.0f;
	species.joint.damping_ratio = 0.0f;
	return species;
}

inline FieldSimulation row_of(const MotionSpecies &species, int count, float spacing) {
	FieldSimulation field((FieldSettings()));
	std::vector<MotionPlant> plants(static_cast<size_t>(count));
	for (int i = 0; i < count; i++) {
		plants[static_cast<size_t>(i)].root.x = spacing * static_cast<float>(i);
	}
	field.add_page(field.add_species(species), plants.data(), count);
	field.set_wind({ { WindKind::constant, 0.0f }, 0.0f });
	return field;
}

/// J. The elasticity law's force is (1 + e)·m·g·|y| upwards and m·g downwards, hence U = m·g·(L·y - (1 + e)·L·y²/2).
/// The spring law's t obeys t'' = -ω²·t, so the energy over m is (|t'|² + ω²·|t|²)/2.
inline double energy(const FieldSimulation &field, const MotionSpecies &species) {
	const double mass = static_cast<double>(species.joint.mass);
	const double gravity = static_cast<double>(STANDARD_GRAVITY);
	double sum = 0.0;
	for (int i = 0; i < field.page(0).size(); i++) {
		const TipState state = field.state(0, i);
		const double length = static_cast<double>(field.page(0).length(i));
		const double y = static_cast<double>(state.direction.y);
		if (species.law == Law::elasticity) {
			const double speed = length * static_cast<double>(glm::length(state.rate));
			const double lift = 1.0 + static_cast<double>(species.joint.elasticity);
			sum += 0.5 * mass * speed * speed + mass * gravity * length * ((y - 1.0) + 0.5 * lift * (1.0 - y * y));
			continue;
		}
		const glm::dvec3 t = glm::dvec3(state.direction) / y;
		const glm::dvec3 rate = (glm::dvec3(state.rate) - t * static_cast<double>(state.rate.y)) / y;
		const double omega = 2.0 * PI * static_cast<double>(species.joint.natural_frequency);
		sum += 0.5 * mass * (glm::dot(rate, rate) + omega * omega * (t.x * t.x + t.z * t.z));
	}
	return sum;
}

inline float tip_distance(const FieldSimulation &field, int a, int b) {
	return glm::distance(field.page(0).tip(a), field.page(0).tip(b));
}

} // namespace undergrowth
