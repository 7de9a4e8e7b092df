// Shelter of low plants among taller ones.

#include "field/field_simulation.hpp"

#include "motion/part_air.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float BETWEEN_READINGS = 1.0f; // s.

} // namespace

/// Adds the live plants in rows [begin, end) of a page, or removes them with a sign of -1.
void FieldSimulation::add_to_canopy(const MotionPage &page, int begin, int end, float sign) {
	for (int row = begin; row < end; row++) {
		if (!page.is_gone(row)) {
			canopy.add(page.species(), page.roots_x()[row], page.roots_z()[row], sign * page.drag_area(row));
		}
	}
}

void FieldSimulation::rebuild_canopy() {
	for (int species = 0; species < species_count(); species++) {
		canopy.set_height(species, kinds[static_cast<std::size_t>(species)].canopy_height);
	}
	canopy.clear();
	for (const Entry &entry : entries) {
		add_to_canopy(entry.page, 0, entry.page.size(), 1.0f);
	}
}

/// A new page reads its canopy at once, other pages at most once in BETWEEN_READINGS, so that a field that streams
/// does not read all at each step.
void FieldSimulation::shelter_page(int page) {
	Beat &own = beat(page);
	const bool is_due = own.canopy_version < 0 || own.last_step - own.canopy_step >= steps_in(BETWEEN_READINGS);
	if (species_count() < 2 || own.canopy_version == canopy.version() || !is_due) {
		return;
	}
	own.canopy_version = canopy.version();
	own.canopy_step = own.last_step;
	MotionPage &plants = at(page).page;
	plants.set_taller_plants(canopy.higher_than(canopy.height(plants.species()), plants.low(), plants.high()));
}

/// Prototypes have the mean canopy of the field.
void FieldSimulation::shelter_prototypes() {
	if (species_count() < 2 || canopy_of_models == canopy.version()) {
		return;
	}
	canopy_of_models = canopy.version();
	for (std::size_t i = 0; i < models.size(); i++) {
		models[i].set_taller_plants(canopy.higher_than(canopy.height(static_cast<int>(i))));
	}
}

float FieldSimulation::air_speed(int species) const {
	const MotionSpecies &kind = kinds[static_cast<std::size_t>(species)];
	const TallerPlants taller = canopy.higher_than(canopy.height(species));
	const glm::vec3 middle = 0.5f * (box_low + box_high);
	return air_speed_at(wind_at_time(blowing, along, time()), along, kind, taller, kind.canopy_height, middle);
}

glm::vec2 FieldSimulation::air_around(const glm::vec3 &root, float height) const {
	WindSnapshot now = wind_at_time(blowing, along, time());
	now.sources = { stirring.data(), static_cast<int>(stirring.size()) };
	const PlantCanopy grown = canopy.around(root, height, -1);
	return air_at(now, along, grown.height, grown.taller, height, root);
}

float FieldSimulation::stirred_speed() const {
	float fastest = 0.0f;
	for (const AirSource &source : stirring) {
		fastest = std::max(fastest, std::fabs(source.speed));
	}
	return fastest;
}

} // namespace undergrowth
