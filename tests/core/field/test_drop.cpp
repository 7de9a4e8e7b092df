#include "field/contact.hpp"
#include "field_fixture.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

using namespace undergrowth;

namespace {

constexpr int PLANTS = 60;
constexpr int PROTOTYPES[] = { 0, 8 };

FieldSimulation field_with(int prototypes, Law law = Law::elasticity) {
	FieldSettings settings;
	settings.prototypes = prototypes;
	FieldSimulation field(settings);
	add_plants(field, field.add_species(species_of(law)), PLANTS, PLANTS / 3);
	field.set_wind(wave_wind());
	for (int i = 0; i < 30; i++) {
		field.step();
	}
	return field;
}

MovingBody ball_around(const glm::vec3 &place) {
	MovingBody ball;
	ball.from = ball.to = place;
	ball.radius = 1.5f;
	return ball;
}

} // namespace

TEST_CASE("dropping a plant removes it and leaves all other plants unchanged") {
	for (const int prototypes : PROTOTYPES) {
		for (const Law law : { Law::elasticity, Law::spring }) {
			FieldSimulation field = field_with(prototypes, law);
			FieldSimulation whole = field_with(prototypes, law);
			field.drop(1, 4);
			field.drop(1, 4);
			CHECK(field.plant_count() == PLANTS - 1);
			CHECK(field.page(1).size() == PLANTS / 3);
			CHECK(field.page(1).live_count() == PLANTS / 3 - 1);
			CHECK(field.page(1).is_gone(4));
			CHECK(field.due_count() == whole.due_count() - (prototypes == 0 ? 1 : 0));
			field.set_species(0, species_of(law));
			whole.set_species(0, species_of(law));
			for (int i = 0; i < 60; i++) {
				field.step();
				whole.step();
			}
			for (int page = 0; page < 3; page++) {
				for (int i = 0; i < PLANTS / 3; i++) {
					if (page == 1 && i == 4) {
						REQUIRE(glm::length(field.state(1, 4).direction) == doctest::Approx(1.0));
						continue;
					}
					REQUIRE(field.page(page).root(i) == whole.page(page).root(i));
					REQUIRE(field.state(page, i).direction == whole.state(page, i).direction);
					REQUIRE(field.state(page, i).rate == whole.state(page, i).rate);
				}
			}
		}
	}
}

TEST_CASE("no body, impulse or query finds a dropped plant") {
	for (const int prototypes : PROTOTYPES) {
		FieldSimulation field = field_with(prototypes);
		const glm::vec3 root = field.page(0).root(7);
		REQUIRE(field.is_point_in_plants(root, 0.01f));
		field.apply_impulse(0, 7, { 0.3f, 0.0f, 0.0f });
		const int simulated = field.simulated_count();
		field.drop(0, 7);
		CHECK(field.simulated_count() == simulated - 1);
		CHECK_FALSE(field.is_point_in_plants(root, 0.01f));
		const TipState before = field.state(0, 7);
		field.apply_impulse(0, 7, { 0.3f, 0.0f, 0.0f });
		CHECK(field.state(0, 7).rate == before.rate);
		CHECK(field.simulated_count() == simulated - 1);
		const MovingBody ball = ball_around(root);
		int visited = 0;
		for_each_in_reach(field.page(0), ball, [&](int index) { visited += index == 7 ? 1 : 0; });
		CHECK(visited == 0);
		field.set_bodies(&ball, 1);
		field.step();
		CHECK((prototypes == 0 || field.follower(0, 7).detached == 0));
	}
}

TEST_CASE("dropped plants touch nothing") {
	MotionPlant plants[3];
	plants[1].root.x = 0.03f;
	plants[1].root.y = 0.98f; // At the tip of the first.
	plants[2].root.x = 0.06f;
	FieldSimulation field((FieldSettings()));
	field.add_page(field.add_species(species_of(Law::spring)), plants, 3);
	field.apply_impulse(0, 2, { -0.4f, 0.0f, 0.0f });
	field.step();
	field.step();
	TipContact contact;
	contact.fit(field);
	contact.resolve(field);
	REQUIRE(contact.contacts(0, 0) == 1);
	REQUIRE(contact.contacts(0, 2) == 1);
	field.drop(0, 1);
	contact.fit(field);
	contact.resolve(field);
	CHECK(contact.contacts(0, 0) == 1);
	field.drop(0, 2);
	contact.fit(field);
	contact.resolve(field);
	for (int i = 0; i < 3; i++) {
		CHECK(contact.contacts(0, i) == 0);
	}
}

TEST_CASE("the next page reuses the number of a removed page, and all other pages are unchanged") {
	for (const int prototypes : PROTOTYPES) {
		FieldSimulation field = field_with(prototypes);
		field.apply_impulse(1, 3, { 0.3f, 0.0f, 0.0f });
		field.apply_impulse(2, 3, { 0.3f, 0.0f, 0.0f });
		const glm::vec3 root = field.page(1).root(3);
		field.set_page_multiple(1, 4);
		field.step();
		const TipState kept = field.state(2, 5);
		field.remove_page(1);
		CHECK(field.page_count() == 3);
		CHECK(field.plant_count() == 2 * PLANTS / 3);
		CHECK(field.page(1).size() == 0);
		CHECK_FALSE(field.is_point_in_plants(root, 0.01f));
		CHECK(field.state(2, 5).direction == kept.direction);
		if (prototypes > 0) {
			REQUIRE(field.detached_followers(0)->count() == 1);
			CHECK(field.detached_followers(0)->page_of(0) == 2);
			CHECK(field.follower(2, 3).detached == 1);
		}
		field.step();
		const MotionPlant plants[2];
		CHECK(field.add_page(0, plants, 2) == 1);
		CHECK(field.page_interval(1) == 1);
		CHECK(field.changed_pages() == (prototypes > 0 ? std::vector<int>{ 1, 2 } : std::vector<int>()));
		CHECK(field.add_page(0, plants, 1) == 3);
		CHECK(field.plant_count() == 2 * PLANTS / 3 + 3);
		field.step();
		CHECK((prototypes > 0 || field.has_stepped(1)));
		CHECK(field.state(1, 1).direction.y < 1.0f);
	}
}

TEST_CASE("removed distant plants no longer delay the remaining ones") {
	FieldSettings settings;
	settings.prototypes = 8;
	FieldSimulation field(settings);
	MotionPlant plant;
	const int species = field.add_species(species_of(Law::elasticity));
	field.set_wind({ { WindKind::waves, 1.0f }, 10.0f });
	field.add_page(species, &plant, 1);
	const float alone = field.prototype_lead();
	const WindSnapshot wind = wind_at_time(field.wind(), 0.0);
	plant.root = glm::vec3(wind.delay_x, 0.0f, wind.delay_z) * -300.0f;
	const int far = field.add_page(species, &plant, 1);
	CHECK(field.prototype_lead() > alone + 2.0f);
	field.remove_page(far);
	CHECK(field.prototype_lead() == alone);
}
