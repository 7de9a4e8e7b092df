#include "../base/sanitized.hpp"
#include "contact_fixture.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace undergrowth;

namespace {

constexpr float ABSURD_RADIUS = 50.0f; // m.

/// `count` random plants on 30 x 30 m, as dense as in fields, with tips of `radius`.
FieldSimulation lawn_of(Law law, int count, float radius) {
	MotionSpecies species = tips_of(law);
	species.collision_radius = radius;
	FieldSimulation field((FieldSettings()));
	std::vector<MotionPlant> plants;
	for (int i = 0; i < count; i++) {
		plants.push_back(chance_plant(i));
		plants.back().root *= 0.3f;
		plants.back().rest = { 0.0f, 1.0f, 0.0f };
	}
	field.add_page(field.add_species(species), plants.data(), count);
	field.set_wind({ { WindKind::constant, 0.0f }, 0.0f });
	return field;
}

void find_contacts(TipContact &contact, FieldSimulation &field) {
	contact.gather(field, 0, field.page_count());
	contact.sort();
	contact.count(field, 0, field.page_count());
}

/// Two plants 1 m high, of different species, 0.4 m apart.
FieldSimulation pair_of(const MotionSpecies &left, const MotionSpecies &right) {
	FieldSimulation field((FieldSettings()));
	MotionPlant plant;
	field.add_page(field.add_species(left), &plant, 1);
	plant.root.x = 0.4f;
	field.add_page(field.add_species(right), &plant, 1);
	return field;
}

} // namespace

TEST_CASE("the cost of contact grows with the number of plants, not with their radius") {
	for (const float radius : { RADIUS, 1.0f, ABSURD_RADIUS }) {
		for (const int count : { 500, 1000, 2000, 4000 }) {
			FieldSimulation field = lawn_of(Law::elasticity, count, radius);
			for (int i = 0; i < count; i++) {
				field.page(0).set_state(i, { { 0.5f * signed_noise(9, static_cast<uint64_t>(i)), 0.8f, 0.0f }, {} });
			}
			TipContact contact;
			contact.fit(field);
			find_contacts(contact, field);
			CAPTURE(radius);
			CHECK(contact.candidate_count() <= static_cast<std::size_t>(count * TipContact::MAX_CONTACTS));
			if (radius != 1.0f) { // In between, it depends on the positions.
				CHECK(contact.is_crowded() == (radius == ABSURD_RADIUS));
			}
			int max = 0;
			for (int i = 0; i < count; i++) {
				max = std::max(max, contact.contacts(0, i));
			}
			CHECK(max > 0);
			CHECK(max <= TipContact::MAX_CONTACTS);
		}
	}
}

TEST_CASE("tips of any radius never gain energy of motion from contact") {
	for (const Law law : BOTH_LAWS) {
		for (const float radius : { 0.5f, 3.0f, ABSURD_RADIUS }) {
			const int count = 600;
			FieldSimulation field = lawn_of(law, count, radius);
			const auto noise = [](int which, int i) {
				return signed_noise(static_cast<uint64_t>(which), static_cast<uint64_t>(i));
			};
			double before = 0.0;
			for (int i = 0; i < count; i++) {
				field.page(0).set_state(i,
						{ { 0.4f * noise(21, i), 1.0f, 0.4f * noise(22, i) }, { noise(23, i), 0.0f, noise(24, i) } });
				const glm::vec3 way = field.page(0).length(i) * field.state(0, i).rate;
				before += static_cast<double>(glm::dot(way, way));
			}
			TipContact contact;
			contact.fit(field);
			contact.resolve(field);
			double after = 0.0;
			for (int i = 0; i < count; i++) {
				const glm::vec3 way = field.page(0).length(i) * field.state(0, i).rate;
				after += static_cast<double>(glm::dot(way, way));
			}
			CAPTURE(radius);
			CHECK(after <= before * (1.0 + 1e-5));
			CHECK(after < 0.95 * before);
		}
	}
}

TEST_CASE("a crowd of tips with an absurd radius comes to rest") {
	for (const Law law : BOTH_LAWS) {
		const int tips = repetitions(300, 60);
		FieldSimulation field = lawn_of(law, tips, ABSURD_RADIUS);
		TipContact contact;
		contact.fit(field);
		for (int i = 0; i < tips; i++) {
			field.apply_impulse(0, i, { 0.3f * signed_noise(31, static_cast<uint64_t>(i)), 0.0f, 0.1f });
		}
		MotionSpecies species = tips_of(law);
		double max = energy(field, species);
		const double start = max;
		for (int i = 0; i < 600; i++) {
			field.step();
			contact.resolve(field);
			max = std::max(max, energy(field, species));
		}
		CHECK(max <= start * (1.0 + 0.05));
		CHECK(energy(field, species) < 0.5 * start);
	}
}

TEST_CASE("large tips touch at any index of their species") {
	MotionSpecies large = tips_of(Law::elasticity);
	large.collision_radius = 0.3f;
	const MotionSpecies small = tips_of(Law::elasticity);
	for (const bool is_last : { false, true }) {
		FieldSimulation field((FieldSettings()));
		std::vector<MotionPlant> plants(2);
		plants[1].root.x = 0.7f;
		MotionPlant far;
		far.root.x = 30.0f;
		const int first = field.add_species(is_last ? small : large);
		const int second = field.add_species(is_last ? large : small);
		field.add_page(first, is_last ? &far : plants.data(), is_last ? 1 : 2);
		field.add_page(second, is_last ? plants.data() : &far, is_last ? 2 : 1);
		const int page = is_last ? 1 : 0;
		field.page(page).set_state(0, { { 0.1f, 1.0f, 0.0f }, {} });
		field.page(page).set_state(1, { { -0.1f, 1.0f, 0.0f }, {} });
		TipContact contact;
		contact.fit(field);
		find_contacts(contact, field);
		CHECK(contact.contacts(page, 0) == 1);
		CHECK(contact.contacts(page, 1) == 1);
	}
}

TEST_CASE("tips at exactly the same position separate") {
	FieldSimulation field = row_of(tips_of(Law::elasticity), 2, 1.2f);
	field.page(0).set_state(0, { { 0.6f, 0.8f, 0.0f }, {} });
	field.page(0).set_state(1, { { -0.6f, 0.8f, 0.0f }, {} });
	REQUIRE(tip_distance(field, 0, 1) == 0.0f);
	TipContact contact;
	contact.fit(field);
	contact.resolve(field);
	CHECK(contact.contacts(0, 0) == 1);
	CHECK(tip_distance(field, 0, 1) > RADIUS);
}

TEST_CASE("of two touching tips the heavier one moves less, and momentum is conserved") {
	for (const Law law : BOTH_LAWS) {
		MotionSpecies light = tips_of(law);
		MotionSpecies heavy = tips_of(law);
		light.joint.mass = 0.1f;
		heavy.joint.mass = 0.9f;
		FieldSimulation field = pair_of(light, heavy);
		const glm::vec3 inwards = { 0.12f, 1.0f, 0.0f };
		const glm::vec3 outwards = { -0.12f, 1.0f, 0.0f };
		field.page(0).set_state(0, { inwards, { 0.5f, 0.0f, 0.0f } });
		field.page(1).set_state(0, { outwards, { -0.5f, 0.0f, 0.0f } });
		const float before[] = { field.state(0, 0).rate.x, field.state(1, 0).rate.x };
		const float at[] = { field.page(0).tip(0).x, field.page(1).tip(0).x };
		TipContact contact;
		contact.fit(field);
		contact.resolve(field);
		const float slowed[] = { before[0] - field.state(0, 0).rate.x, field.state(1, 0).rate.x - before[1] };
		const float moved[] = { at[0] - field.page(0).tip(0).x, field.page(1).tip(0).x - at[1] };
		CHECK(slowed[1] > 0.01f);
		CHECK(slowed[0] == doctest::Approx(9.0f * slowed[1]).epsilon(0.05));
		CHECK(moved[1] > 0.001f);
		CHECK(moved[0] == doctest::Approx(9.0f * moved[1]).epsilon(0.1));
	}
}

TEST_CASE("a radius that increases during motion applies to contact and to bodies") {
	MotionSpecies species = tips_of(Law::elasticity);
	species.collision_radius = 0.02f;
	FieldSimulation field = pair_of(species, species);
	TipContact contact;
	contact.fit(field);
	species.collision_radius = 0.3f;
	field.set_species(0, species);
	field.set_species(1, species);
	field.page(0).set_state(0, { { 0.1f, 1.0f, 0.0f }, {} });
	contact.resolve(field);
	CHECK(contact.contacts(0, 0) == 1);
	CHECK(glm::distance(field.page(0).tip(0), field.page(1).tip(0)) > 0.35f);
	MovingBody ball;
	ball.radius = 0.1f;
	ball.from = ball.to = field.page(1).root(0) + glm::vec3(0.0f, 1.35f, 0.0f);
	CHECK(boxes_overlap(field.page(1), ball));
	CHECK(touches_plants(field.page(1), ball, 0.0f));
}
