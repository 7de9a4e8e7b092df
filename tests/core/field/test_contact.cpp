#include "contact_fixture.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace undergrowth;

TEST_CASE("two plants that swing into each other separate and lose energy") {
	for (const Law law : BOTH_LAWS) {
		const MotionSpecies species = tips_of(law);
		double max[2] = {}; // Without contact, and with it.
		for (const bool touching : { false, true }) {
			FieldSimulation field = row_of(species, 2, 0.4f);
			TipContact contact;
			contact.fit(field);
			field.apply_impulse(0, 0, { 0.35f, 0.0f, 0.02f });
			field.apply_impulse(0, 1, { -0.3f, 0.0f, 0.0f });
			const double start = energy(field, species);
			for (int i = 0; i < 60 * 60; i++) {
				field.step();
				if (touching) {
					contact.resolve(field);
					REQUIRE(tip_distance(field, 0, 1) > 2.0f * RADIUS - DEEPEST);
				}
				max[touching ? 1 : 0] = std::max(max[touching ? 1 : 0], energy(field, species));
			}
			CHECK((energy(field, species) < 0.8 * start) == touching);
		}
		CHECK(max[1] <= max[0] * (1.0 + ENERGY_TOLERANCE));
	}
}

TEST_CASE("tips beyond the range of cells touch nothing and block nothing") {
	FieldSimulation field((FieldSettings()));
	std::vector<MotionPlant> plants(3);
	plants[1].root.x = 1e12f;
	plants[2].root.z = -1e20f;
	field.add_page(field.add_species(tips_of(Law::spring)), plants.data(), 3);
	TipContact contact;
	contact.fit(field);
	contact.resolve(field);
	CHECK(field.state(0, 1).direction == glm::vec3(0.0f, 1.0f, 0.0f));
	CHECK(field.state(0, 2).direction == glm::vec3(0.0f, 1.0f, 0.0f));
}

TEST_CASE("a contact alone never adds kinetic energy, for any number of tips") {
	for (const Law law : BOTH_LAWS) {
		for (int trial = 0; trial < 50; trial++) {
			const MotionSpecies species = tips_of(law);
			FieldSimulation field((FieldSettings()));
			std::vector<MotionPlant> plants(40);
			for (int i = 0; i < 40; i++) {
				plants[static_cast<size_t>(i)].root = { 0.3f * static_cast<float>(i % 7), 0.0f,
					0.3f * static_cast<float>(i / 7) };
			}
			field.add_page(field.add_species(species), plants.data(), 40);
			const auto noise = [trial](int which, int i) {
				return signed_noise(static_cast<uint64_t>(100 * trial + which), static_cast<uint64_t>(i));
			};
			for (int i = 0; i < 40; i++) {
				field.page(0).set_state(
						i, { { 0.4f * noise(1, i), 1.0f, 0.4f * noise(2, i) }, { noise(3, i), 0.0f, noise(4, i) } });
			}
			TipContact contact;
			contact.fit(field);
			const auto motion = [&field] {
				double sum = 0.0;
				for (int i = 0; i < 40; i++) {
					const glm::vec3 rate = field.state(0, i).rate;
					sum += static_cast<double>(glm::dot(rate, rate));
				}
				return sum;
			};
			const double before = motion();
			contact.resolve(field);
			CHECK(motion() <= before * (1.0 + 1e-5));
		}
	}
}

TEST_CASE("plants pushed together by a wind part when it ends, and come to rest") {
	for (const Law law : BOTH_LAWS) {
		MotionSpecies species = tips_of(law);
		species.joint.inner_friction = 0.6f;
		species.joint.damping_ratio = 0.2f;
		FieldSimulation field = row_of(species, 2, 0.35f);
		TipContact contact;
		contact.fit(field);
		for (int i = 0; i < 600; i++) {
			field.apply_impulse(0, 0, { 0.05f, 0.0f, 0.0f });
			field.apply_impulse(0, 1, { -0.05f, 0.0f, 0.0f });
			field.step();
			contact.resolve(field);
		}
		CHECK(contact.contacts(0, 0) == 1);
		CHECK(std::fabs(tip_distance(field, 0, 1) - 2.0f * RADIUS) < APART_TOLERANCE);
		CHECK(glm::length(field.state(0, 0).rate) < 0.05f);
		for (int i = 0; i < 3000; i++) {
			field.step();
			contact.resolve(field);
		}
		CHECK(contact.contacts(0, 0) == 0);
		for (int i = 0; i < 2; i++) {
			CHECK(glm::length(field.state(0, i).rate) < REST_SPEED);
			CHECK(glm::distance(field.state(0, i).direction, field.page(0).rest(i)) < REST_SPEED);
		}
	}
}

TEST_CASE("plants too close to separate in calm air stay at rest") {
	for (const Law law : BOTH_LAWS) {
		FieldSimulation field = row_of(tips_of(law), 5, 0.05f);
		TipContact contact;
		contact.fit(field);
		for (int i = 0; i < 300; i++) {
			field.step();
			contact.resolve(field);
		}
		for (int i = 0; i < 5; i++) {
			CHECK(glm::distance(field.state(0, i).direction, field.page(0).rest(i)) < 1e-3f);
		}
	}
}

TEST_CASE("a removed plant pushes nothing, not even from its old root") {
	for (const Law law : BOTH_LAWS) {
		for (const int gone : { 0, 1 }) {
			FieldSimulation field((FieldSettings()));
			std::vector<MotionPlant> plants(2);
			plants[0].root.x = gone == 0 ? 0.0f : 0.05f;
			plants[1].root.x = 0.05f - plants[0].root.x;
			plants[static_cast<size_t>(1 - gone)].length = 0.05f;
			field.add_page(field.add_species(tips_of(law)), plants.data(), 2);
			MotionPage &page = field.page(0);
			const float towards = page.root(gone).x - page.root(1 - gone).x;
			page.set_state(1 - gone, { { 20.0f * towards, 1.0f, 0.0f }, glm::vec3(0.0f) });
			page.drop(gone);
			const glm::vec3 before = page.tip(1 - gone);
			REQUIRE(glm::distance(before, page.root(gone)) < RADIUS);
			TipContact contact;
			contact.fit(field);
			contact.resolve(field);
			CHECK(page.tip(1 - gone) == before);
		}
	}
}

TEST_CASE("the grid finds the contacts that comparing every pair finds") {
	FieldSimulation field((FieldSettings()));
	MotionSpecies species = tips_of(Law::elasticity);
	const int kind = field.add_species(species);
	for (int page = 0; page < 3; page++) {
		std::vector<MotionPlant> plants;
		for (int i = 0; i < 300; i++) {
			MotionPlant plant = chance_plant(1000 * page + i);
			plant.root *= 0.08f;
			plants.push_back(plant);
		}
		field.add_page(kind, plants.data(), 300);
	}
	field.set_wind(wave_wind());
	for (int i = 0; i < 100; i++) {
		field.step();
	}
	TipContact contact;
	contact.fit(field);
	contact.gather(field, 0, 3);
	contact.sort();
	contact.count(field, 0, 3);
	int total = 0;
	for (int a = 0; a < 900; a++) {
		int expected = 0;
		for (int b = 0; b < 900; b++) {
			const MotionPage &first = field.page(a / 300);
			const MotionPage &second = field.page(b / 300);
			const glm::vec3 up = { 0.0f, 1.0f, 0.0f };
			const float calm = glm::distance(first.root(a % 300) + first.length(a % 300) * up,
					second.root(b % 300) + second.length(b % 300) * up);
			const float wanted = std::min(2.0f * RADIUS, calm);
			expected += a != b && glm::distance(first.tip(a % 300), second.tip(b % 300)) < wanted ? 1 : 0;
		}
		REQUIRE(contact.contacts(a / 300, a % 300) == expected);
		total += expected;
	}
	CHECK(total > 20);
}

TEST_CASE("a field with contact stays within its memory") {
	FieldSimulation field((FieldSettings()));
	add_plants(field, field.add_species(species_of(Law::elasticity)), 100000);
	TipContact contact;
	contact.fit(field);
	CHECK(field.bytes_per_plant() + static_cast<double>(contact.bytes()) / 100000.0 <= 96.5);
}
