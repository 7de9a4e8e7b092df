#pragma once

#include "field_fixture.hpp"

/// Fixture of the tests of prototypes and their followers.
namespace undergrowth {

inline constexpr int PROTOTYPES = 64;
inline constexpr int FOLLOWERS = 300;

/// Random plants that follow prototypes under waves that travel at `speed` (m/s).
inline FieldSimulation prototype_field(Law law, float speed, int count = FOLLOWERS) {
	FieldSettings settings;
	settings.prototypes = PROTOTYPES;
	FieldSimulation field(settings);
	add_plants(field, field.add_species(species_of(law)), count);
	FieldWind wind = wave_wind();
	wind.speed = speed;
	field.set_wind(wind);
	return field;
}

/// Direction of a prototype after its newest step.
inline glm::vec3 newest(const Prototypes &models, int prototype) {
	return from_stereographic(models.bend(prototype, 0.0f, 1.0f));
}

} // namespace undergrowth
