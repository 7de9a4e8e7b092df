#include "field/contact.hpp"
#include "field_fixture.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>

using namespace undergrowth;

namespace {

constexpr Law BOTH_LAWS[] = { Law::elasticity, Law::spring };
constexpr float RADIUS = 0.1f; // m.
constexpr float APART_TOLERANCE = 0.003f; // m; contact is solved once a step, halfway for each of the two.
constexpr float DEEPEST = 0.25f * RADIUS; // What fast tips may overlap after a step in which they met.
/// Of the most that the same swing has without contact, whose energy goes up and down a little with the step's own
/// error.
constexpr double ENERGY_TOLERANCE = 1e-3;
constexpr float REST_SPEED = 1e-3f; // 1/s.

MotionSpecies tips_of(Law law) {
	MotionSpecies species = species_of(law);
	species.collision_radius = RADIUS;
	species.joint.inner_friction = 0.0f;
	species.joint.damping_ratio = 0.0f;
	return species;
}

FieldSimulation row_of(const MotionSpecies &species, int count, float spacing) {
	FieldSimulation field((FieldSettings()));
	std::vector<MotionPlant> plants(static_cast<size_t>(count));
	for (int i = 0; i < count; i++) {
		plants[static_cast<size_t>(i)].root.x = spacing * static_cast<float>(i);
	}
	field.add_page(field.add_species(species), plants.data(), count);
	field.set_wind({ { WindKind::constant, 0.0f }, 0.0f });
	return field;
}

/// J; the elasticity law's force is (1 + e)·m·g·|y| upwards and m·g downwards, hence U = m·g·(L·y - (1 + e)·L·y²/2).
/// The spring law's t obeys t'' = -ω²·t: over m, (|t'|² + ω²·|t|²)/2.
double energy(const FieldSimulation &field, const MotionSpecies &species) {
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

float tip_distance(const FieldSimulation &field, int a, int b) {
	return glm::distance(field.page(0).tip(a), field.page(0).tip(b));
}

} // namespace

TEST_CASE("two plants that swing into each other part, and lose energy, never gain") {
	for (const Law law : BOTH_LAWS) {
		const MotionSpecies species = tips_of(law);
		double most[2] = {}; // Without contact, and with it.
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
				most[touching ? 1 : 0] = std::max(most[touching ? 1 : 0], energy(field, species));
			}
			CHECK((energy(field, species) < 0.8 * start) == touching);
		}
		CHECK(most[1] <= most[0] * (1.0 + ENERGY_TOLERANCE));
	}
}

TEST_CASE("a contact by itself never adds energy of motion, however many tips meet") {
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

TEST_CASE("plants that stand too close to be apart in calm air stay at rest") {
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

TEST_CASE("a field with contact keeps within its memory") {
	FieldSimulation field((FieldSettings()));
	add_plants(field, field.add_species(species_of(Law::elasticity)), 100000);
	TipContact contact;
	contact.fit(field);
	CHECK(field.bytes_per_plant() + static_cast<double>(contact.bytes()) / 100000.0 <= 96.0);
}

namespace {

constexpr float ABSURD_RADIUS = 50.0f; // m.

/// `count` chance plants on 30 x 30 m, as many as fields have, with tips of `radius`.
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

/// Two plants 1 m high, each of a species of its own, 0.4 m apart.
FieldSimulation pair_of(const MotionSpecies &left, const MotionSpecies &right) {
	FieldSimulation field((FieldSettings()));
	MotionPlant plant;
	field.add_page(field.add_species(left), &plant, 1);
	plant.root.x = 0.4f;
	field.add_page(field.add_species(right), &plant, 1);
	return field;
}

} // namespace

TEST_CASE("contact costs as much as there are plants, whatever their radius") {
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
			CHECK(contact.candidate_count() <= static_cast<std::size_t>(count * TipContact::MOST_CONTACTS));
			if (radius != 1.0f) { // In between, it depends on who stands where.
				CHECK(contact.is_crowded() == (radius == ABSURD_RADIUS));
			}
			int most = 0;
			for (int i = 0; i < count; i++) {
				most = std::max(most, contact.contacts(0, i));
			}
			CHECK(most > 0);
			CHECK(most <= TipContact::MOST_CONTACTS);
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
		FieldSimulation field = lawn_of(law, 300, ABSURD_RADIUS);
		TipContact contact;
		contact.fit(field);
		for (int i = 0; i < 300; i++) {
			field.apply_impulse(0, i, { 0.3f * signed_noise(31, static_cast<uint64_t>(i)), 0.0f, 0.1f });
		}
		MotionSpecies species = tips_of(law);
		double most = energy(field, species);
		const double start = most;
		for (int i = 0; i < 600; i++) {
			field.step();
			contact.resolve(field);
			most = std::max(most, energy(field, species));
		}
		CHECK(most <= start * (1.0 + 0.05));
		CHECK(energy(field, species) < 0.5 * start);
	}
}

TEST_CASE("large tips touch wherever their species stands among others") {
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

TEST_CASE("tips at the very same place part") {
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

TEST_CASE("of two that meet the heavier one gives way less, and their momentum stays") {
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

TEST_CASE("a radius that grows while plants swing reaches their contact, and bodies that touch them") {
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
