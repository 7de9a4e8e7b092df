#include "field_fixture.hpp"

#include "motion/swing_clock.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

using namespace undergrowth;

namespace {

constexpr int FRAMES_A_STEP = 4;
constexpr int PLANTS = 40;

/// Max movement of leaves from one frame to the next, with four frames per step, at this interval.
float farthest_of_leaves(Law law, int interval) {
	FieldSettings settings;
	settings.update_interval = interval;
	FieldSimulation field(settings);
	MotionSpecies species = species_of(law);
	species.has_parts = true;
	add_plants(field, field.add_species(species), PLANTS);
	field.set_wind(wave_wind());
	PartMotion leaf;
	leaf.frequency = 2.0f;
	leaf.side = { 1.0f, 0.0f };
	SwingClock clock;
	std::vector<glm::vec2> before(PLANTS);
	float farthest = 0.0f;
	for (int i = 0; i < 300; i++) {
		field.step();
		clock.step(static_cast<double>(settings.step));
		for (int frame = 1; frame <= FRAMES_A_STEP; frame++) {
			const float fraction = static_cast<float>(frame) / FRAMES_A_STEP;
			for (int k = 0; k < PLANTS; k++) {
				StemMotion stem = field.shown_stem(0, k, fraction);
				stem.clock = clock.now(fraction);
				const glm::vec2 now = part_bend(leaf, stem);
				farthest = i > 60 ? std::max(farthest, glm::distance(now, before[static_cast<size_t>(k)])) : 0.0f;
				before[static_cast<size_t>(k)] = now;
			}
		}
	}
	return farthest;
}

} // namespace

TEST_CASE("leaves move as evenly at long intervals as at every step") {
	for (const Law law : { Law::elasticity, Law::spring }) {
		const float each_step = farthest_of_leaves(law, 1);
		CHECK(each_step > 1e-3f);
		CHECK(farthest_of_leaves(law, 4) < 1.3f * each_step);
	}
}
