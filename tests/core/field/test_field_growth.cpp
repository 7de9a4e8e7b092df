// Plants that are added to existing pages.

#include "field_fixture.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

namespace undergrowth {

TEST_CASE("a page with appended plants moves like one created whole") {
	for (const Law law : { Law::elasticity, Law::spring }) {
		FieldSimulation whole({});
		FieldSimulation grown({});
		std::vector<MotionPlant> plants;
		for (int i = 0; i < 100; i++) {
			plants.push_back(chance_plant(i));
		}
		CHECK(whole.add_page(whole.add_species(species_of(law)), plants.data(), 100) == 0);
		CHECK(grown.add_page(grown.add_species(species_of(law)), plants.data(), 37) == 0);
		CHECK(grown.add_to_page(0, plants.data() + 37, 63));
		whole.set_wind(wave_wind());
		grown.set_wind(wave_wind());
		for (int i = 0; i < 100; i++) {
			whole.step();
			grown.step();
		}
		for (int i = 0; i < 200; i++) {
			CHECK(whole.page(0).bends()[i] == grown.page(0).bends()[i]);
		}
	}
}

TEST_CASE("followers added later get their own prototype") {
	FieldSettings settings;
	settings.prototypes = 8;
	FieldSimulation field(settings);
	add_plants(field, field.add_species(species_of(Law::spring)), 10);
	const MotionPlant more[2] = { chance_plant(10), chance_plant(11) };
	CHECK(field.add_to_page(0, more, 2));
	CHECK(field.plant_count() == 12);
	CHECK(field.follower(0, 11).prototype < 8);
	field.step();
	CHECK(glm::length(field.state(0, 11).direction) == doctest::Approx(1.0f));
}

TEST_CASE("plants added later do not change the motion of existing plants") {
	FieldSimulation field({});
	FieldSimulation alone({});
	add_plants(field, field.add_species(species_of(Law::elasticity)), 50);
	add_plants(alone, alone.add_species(species_of(Law::elasticity)), 50);
	field.set_wind(wave_wind());
	alone.set_wind(wave_wind());
	for (int i = 0; i < 60; i++) {
		if (i == 30) {
			const MotionPlant more = chance_plant(50);
			CHECK(field.add_to_page(0, &more, 1));
		}
		field.step();
		alone.step();
	}
	for (int i = 0; i < 50; i++) {
		CHECK(field.state(0, i).direction == alone.state(0, i).direction);
	}
}

TEST_CASE("a full page and invalid plants are rejected without any change") {
	FieldSimulation field({});
	add_plants(field, field.add_species(species_of(Law::spring)), MotionPage::PAGE_PLANTS - 1);
	const MotionPlant two[2] = { chance_plant(1), chance_plant(2) };
	CHECK_FALSE(field.add_to_page(0, two, 2));
	MotionPlant bad = chance_plant(3);
	bad.length = 0.0f;
	CHECK_FALSE(field.add_to_page(0, &bad, 1));
	CHECK(field.plant_count() == MotionPage::PAGE_PLANTS - 1);
	CHECK(field.add_to_page(0, two, 1));
	CHECK(field.plant_count() == MotionPage::PAGE_PLANTS);
}

} // namespace undergrowth
