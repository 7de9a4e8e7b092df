#pragma once

#include "../golden.hpp"
#include "base/random.hpp"
#include "field/field_simulation.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Fixture of the field tests: fields of random plants, and a hash of all drawn and stored states of a field.
namespace undergrowth {

inline constexpr float FIELD_STEP = 1.0f / 60.0f; // s.
inline constexpr float HALF_SIDE = 50.0f; // m.

inline MotionPlant chance_plant(int index) {
	const auto noise = [index](uint64_t which) { return signed_noise(which, static_cast<uint64_t>(index)); };
	MotionPlant plant;
	plant.root = { HALF_SIDE * noise(1), 0.2f * noise(2), HALF_SIDE * noise(3) };
	plant.length = 0.75f + 0.25f * noise(4);
	plant.rest = { 0.2f * noise(5), 1.0f, 0.2f * noise(6) };
	return plant;
}

inline MotionSpecies species_of(Law law) {
	MotionSpecies species;
	species.law = law;
	species.joint.mass = 0.4f;
	return species;
}

inline FieldWind wave_wind() {
	FieldWind wind;
	wind.wind.kind = WindKind::waves;
	wind.wind.strength = 1.5f;
	wind.wind.direction = 0.7f;
	wind.speed = 6.0f;
	return wind;
}

/// `count` random plants of `species` in pages of `page_size`.
inline void add_plants(FieldSimulation &field, int species, int count, int page_size = MotionPage::PAGE_PLANTS) {
	for (int begin = 0; begin < count; begin += page_size) {
		std::vector<MotionPlant> plants;
		for (int i = begin; i < std::min(begin + page_size, count); i++) {
			plants.push_back(chance_plant(i));
		}
		field.add_page(species, plants.data(), static_cast<int>(plants.size()));
	}
}

/// A field of both laws in small pages under waves.
inline FieldSimulation mixed_field(const FieldSettings &settings, int count_of_each, int page_size = 256) {
	FieldSimulation field(settings);
	for (const Law law : { Law::elasticity, Law::spring }) {
		add_plants(field, field.add_species(species_of(law)), count_of_each, page_size);
	}
	field.set_wind(wave_wind());
	return field;
}

inline FieldSimulation single_plant(Law law, const MotionPlant &plant, const FieldSettings &settings = {}) {
	FieldSimulation field(settings);
	field.add_page(field.add_species(species_of(law)), &plant, 1);
	return field;
}

inline uint64_t hash_field(const FieldSimulation &field) {
	GoldenHash hash;
	for (int page = 0; page < field.page_count(); page++) {
		if (field.page(page).swings()) {
			hash.add(field.page(page).bends(), 2 * static_cast<std::size_t>(field.page(page).size()));
		}
		for (int i = 0; i < field.page(page).size(); i++) {
			const TipState state = field.state(page, i);
			hash.add(&state, 1);
		}
	}
	return hash.value();
}

} // namespace undergrowth
