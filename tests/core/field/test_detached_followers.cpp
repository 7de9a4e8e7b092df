#include "field/detached_followers.hpp"
#include "field_fixture.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

using namespace undergrowth;

namespace {

constexpr float JUMP = 0.12f; // Between two steps: the change of a direction by waves and decay, with a margin.
constexpr int RUNG_DOWN =
		static_cast<int>((DetachedFollowers::ALONE + DetachedFollowers::GOING_BACK) / FIELD_STEP) + 2; // Steps.

FieldSimulation following_field(Law law, int count = 200) {
	FieldSettings settings;
	settings.prototypes = 16;
	FieldSimulation field(settings);
	std::vector<MotionPlant> plants;
	for (int i = 0; i < count; i++) {
		MotionPlant plant = chance_plant(i);
		plant.root = { 0.1f * static_cast<float>(i % 100), 0.0f, 0.4f * static_cast<float>(i / 100) };
		plants.push_back(plant);
		if (i == count - 1 || static_cast<int>(plants.size()) == MotionPage::PAGE_PLANTS) {
			const int kind = field.species_count() > 0 ? 0 : field.add_species(species_of(law));
			field.add_page(kind, plants.data(), static_cast<int>(plants.size()));
			plants.clear();
		}
	}
	field.set_wind(wave_wind());
	for (int i = 0; i < 60; i++) {
		field.step();
	}
	return field;
}

/// A capsule at `x` that moves along +x.
MovingBody walker(float x) {
	MovingBody body;
	body.from = { x, 0.3f, 0.2f };
	body.to = { x, 1.5f, 0.2f };
	body.radius = 0.3f;
	body.velocity = { 1.5f, 0.0f, 0.0f };
	return body;
}

float depth(const FieldSimulation &field, int plant, const MovingBody &body) {
	const MotionPage &page = field.page(0);
	const glm::vec3 tip = page.root(plant) + page.length(plant) * field.state(0, plant).direction;
	return body.radius - glm::distance(tip, nearest_on_segment(body.from, body.to, tip));
}

} // namespace

TEST_CASE("a pushed plant returns slowly at both ends, and only after it has swung alone") {
	DetachedFollowers some(0, species_of(Law::spring), FIELD_STEP);
	some.reserve(1);
	const glm::vec3 up = { 0.0f, 1.0f, 0.0f };
	REQUIRE(some.add(chance_plant(1), 0, 0, { { up, {} }, {} }, {}) == 0);
	const int alone = static_cast<int>(DetachedFollowers::ALONE / FIELD_STEP + 0.5f);
	const int back = static_cast<int>(DetachedFollowers::GOING_BACK / FIELD_STEP + 0.5f);
	std::vector<float> shares;
	for (int i = 0; i < alone + back + 5; i++) {
		shares.push_back(some.grow_older(0, {}));
	}
	for (int i = 0; i < alone - 1; i++) {
		REQUIRE(shares[static_cast<std::size_t>(i)] == 0.0f);
	}
	const auto after = [&](float part) {
		return shares[static_cast<std::size_t>(alone - 1 + static_cast<int>(part * static_cast<float>(back)))];
	};
	CHECK(after(0.1f) == doctest::Approx(0.028).epsilon(0.02));
	CHECK(after(0.5f) == doctest::Approx(0.5).epsilon(0.02));
	CHECK(after(0.9f) == doctest::Approx(0.972).epsilon(0.02));
	CHECK(shares.back() == 1.0f);
}

TEST_CASE("a plant that is held does not return") {
	DetachedFollowers some(0, species_of(Law::spring), FIELD_STEP);
	some.reserve(1);
	REQUIRE(some.add(chance_plant(1), 0, 0, { { { 0.0f, 1.0f, 0.0f }, {} }, {} }, {}) == 0);
	for (int i = 0; i < RUNG_DOWN; i++) {
		REQUIRE(some.grow_older(0, {}) == 0.0f);
		some.hold(0);
	}
}

TEST_CASE("a body pushes followers, which swing out and follow again without a jump") {
	for (const Law law : { Law::elasticity, Law::spring }) {
		FieldSimulation field = following_field(law);
		const int plants = field.plant_count();
		int max_detached = 0;
		std::vector<glm::vec3> before(static_cast<size_t>(plants));
		for (int i = 0; i < 240 + RUNG_DOWN; i++) {
			const MovingBody body = walker(1.0f + 1.5f * FIELD_STEP * static_cast<float>(i));
			field.set_bodies(&body, i < 240 ? 1 : 0);
			field.step();
			max_detached = std::max(max_detached, field.detached_followers(0)->count());
			for (int k = 0; k < plants; k++) {
				if (i < 240) {
					REQUIRE(depth(field, k, body) < 0.05f);
				}
				const glm::vec3 now = field.state(0, k).direction;
				if (i > 242) {
					REQUIRE(glm::distance(now, before[static_cast<size_t>(k)]) < JUMP);
				}
				before[static_cast<size_t>(k)] = now;
			}
		}
		CHECK(max_detached > 20);
		CHECK(max_detached < plants);
		CHECK(field.detached_followers(0)->count() == 0);
		for (int k = 0; k < plants; k++) {
			REQUIRE(field.follower(0, k).detached == 0);
		}
	}
}

TEST_CASE("followers without a push continue to follow next to pushed neighbours") {
	FieldSimulation pushed = following_field(Law::elasticity);
	FieldSimulation calm = following_field(Law::elasticity);
	for (int i = 0; i < 300; i++) {
		const MovingBody body = walker(4.0f);
		pushed.set_bodies(&body, i < 30 ? 1 : 0);
		pushed.step();
		calm.step();
		int detached = 0;
		for (int k = 0; k < pushed.plant_count(); k++) {
			if (pushed.follower(0, k).detached > 0) {
				detached++;
				continue;
			}
			REQUIRE(pushed.state(0, k).direction == calm.state(0, k).direction);
		}
		REQUIRE(detached == pushed.detached_followers(0)->count());
	}
}

TEST_CASE("an impulse moves a follower for a while") {
	FieldSimulation field = following_field(Law::spring);
	const glm::vec3 before = field.state(0, 7).direction;
	CHECK(field.changed_pages().empty());
	field.apply_impulse(0, 7, { 1.0f, 0.0f, 0.0f });
	field.apply_impulse(0, 8, { 1.0f, 0.0f, 0.0f });
	CHECK(field.changed_pages() == std::vector<int>{ 0 });
	field.forget_changed_pages();
	field.drop(0, 8);
	CHECK(field.changed_pages() == std::vector<int>{ 0 });
	field.forget_changed_pages();
	CHECK(field.changed_pages().empty());
	CHECK(field.detached_followers(0)->count() == 1);
	CHECK(field.simulated_count() == 17);
	for (int i = 0; i < 6; i++) {
		field.step();
	}
	CHECK(field.state(0, 7).direction.x > before.x + 0.1f);
	for (int i = 0; i < RUNG_DOWN; i++) {
		field.step();
	}
	CHECK(field.detached_followers(0)->count() == 0);
}

TEST_CASE("the room for loose plants limits their number") {
	FieldSimulation field = following_field(Law::elasticity, DetachedFollowers::MAX_COUNT + 500);
	for (int page = 0; page < field.page_count(); page++) {
		for (int i = 0; i < field.page(page).size(); i++) {
			field.apply_impulse(page, i, { 0.1f, 0.0f, 0.0f });
		}
	}
	CHECK(field.detached_followers(0)->count() == DetachedFollowers::MAX_COUNT);
	for (int i = 0; i < RUNG_DOWN; i++) {
		field.step();
	}
	CHECK(field.detached_followers(0)->count() == 0);
}

TEST_CASE("dropped plants do not affect loose plants") {
	FieldSimulation field = following_field(Law::elasticity, 60);
	for (int i = 0; i < 60; i += 2) {
		field.apply_impulse(0, i, { 0.4f, 0.0f, 0.0f });
	}
	for (const int index : { 0, 58, 30, 31, 5, 4, 56 }) {
		field.drop(0, index);
		field.step();
		const DetachedFollowers &detached = *field.detached_followers(0);
		int pointed_at = 0;
		for (int i = 0; i < field.page(0).size(); i++) {
			const int number = field.follower(0, i).detached - 1;
			if (number >= 0) {
				pointed_at++;
				REQUIRE_FALSE(field.page(0).is_gone(i));
				REQUIRE(number < detached.count());
				REQUIRE(detached.index_of(number) == i);
				REQUIRE(detached.page().root(number) == field.page(0).root(i));
			}
		}
		REQUIRE(pointed_at == detached.count());
	}
	CHECK(field.detached_followers(0)->count() == 25);
}

TEST_CASE("a page changes if one of its plants gets the row of a dropped loose plant of another page") {
	FieldSimulation field = following_field(Law::spring, MotionPage::PAGE_PLANTS + 10);
	REQUIRE(field.page_count() == 2);
	field.apply_impulse(0, 3, { 0.4f, 0.0f, 0.0f });
	field.apply_impulse(1, 5, { 0.4f, 0.0f, 0.0f });
	field.forget_changed_pages();
	field.drop(0, 3);
	CHECK(field.follower(1, 5).detached == 1);
	CHECK(field.changed_pages() == std::vector<int>{ 0, 1 });
}

TEST_CASE("a pushed follower of a leaning species swings about its rest direction") {
	MotionSpecies species = species_of(Law::spring);
	species.lean = 0.5f;
	species.joint.damping_ratio = 1.0f;
	FieldSettings settings;
	settings.prototypes = 16;
	FieldSimulation field(settings);
	std::vector<MotionPlant> plants(10);
	for (int i = 0; i < 10; i++) {
		const float around = 0.6f * static_cast<float>(i);
		plants[static_cast<size_t>(i)].root.x = static_cast<float>(i);
		plants[static_cast<size_t>(i)].rest = { std::sin(0.5f) * std::sin(around), std::cos(0.5f),
			std::sin(0.5f) * std::cos(around) };
	}
	field.add_page(field.add_species(species), plants.data(), 10);
	field.set_wind({ { WindKind::constant, 0.0f }, 0.0f });
	field.step();
	std::vector<glm::vec3> rests;
	for (int i = 0; i < 10; i++) {
		rests.push_back(field.state(0, i).direction);
		field.apply_impulse(0, i, { 0.2f, 0.0f, 0.2f });
	}
	for (int i = 0; i < static_cast<int>(0.9f * DetachedFollowers::ALONE / FIELD_STEP); i++) {
		field.step();
	}
	REQUIRE(field.detached_followers(0)->count() == 10);
	for (int i = 0; i < 10; i++) {
		CHECK(glm::distance(field.state(0, i).direction, rests[static_cast<size_t>(i)]) < 0.01f);
	}
}

TEST_CASE("a follower that is pushed again is loose for as long as after the first push") {
	FieldSimulation field = following_field(Law::spring);
	const int almost = static_cast<int>(0.9f * DetachedFollowers::ALONE / FIELD_STEP);
	field.apply_impulse(0, 7, { 0.2f, 0.0f, 0.0f });
	for (int i = 0; i < 3; i++) {
		for (int k = 0; k < almost; k++) {
			field.step();
		}
		REQUIRE(field.detached_followers(0)->count() == 1);
		const glm::vec3 own = field.detached_followers(0)->page().direction(0);
		REQUIRE(glm::distance(field.state(0, 7).direction, own) < 1e-3f);
		field.apply_impulse(0, 7, { 0.2f, 0.0f, 0.0f });
	}
	for (int k = 0; k < RUNG_DOWN; k++) {
		field.step();
	}
	CHECK(field.detached_followers(0)->count() == 0);
}

TEST_CASE("a pushed follower swings in the wind like a simulated plant") {
	for (const Law law : { Law::elasticity, Law::spring }) {
		FieldSimulation following = following_field(law);
		FieldSimulation simulated((FieldSettings()));
		MotionPlant plant;
		plant.root = following.page(0).root(40);
		plant.length = following.page(0).length(40);
		simulated.add_page(simulated.add_species(species_of(law)), &plant, 1);
		simulated.set_wind(wave_wind());
		while (simulated.time() < following.time()) {
			simulated.step();
		}
		following.apply_impulse(0, 40, { 0.1f, 0.0f, 0.2f });
		simulated.page(0).set_state(0, following.state(0, 40));
		for (int i = 0; i < 120; i++) {
			following.step();
			simulated.step();
			const glm::vec3 way = following.state(0, 40).direction - simulated.state(0, 0).direction;
			REQUIRE(glm::length(way) < 1e-4f);
			REQUIRE(glm::distance(following.state(0, 40).rate, simulated.state(0, 0).rate) < 1e-3f);
		}
	}
}

TEST_CASE("the drawn motion of returning followers matches their rate") {
	FieldSimulation field = following_field(Law::spring);
	field.apply_impulse(0, 7, { 0.3f, 0.0f, 0.0f });
	const int alone = static_cast<int>(DetachedFollowers::ALONE / FIELD_STEP);
	for (int i = 0; i < RUNG_DOWN; i++) {
		const glm::vec3 before = field.state(0, 7).direction;
		field.step();
		if (i > alone + 2 && field.detached_followers(0)->count() > 0) {
			const glm::vec3 rate = (field.state(0, 7).direction - before) / FIELD_STEP;
			CHECK(glm::distance(field.state(0, 7).rate, rate) < 0.15f);
		}
	}
}

TEST_CASE("bodies with invalid numbers push no follower") {
	FieldSimulation field = following_field(Law::spring);
	MovingBody bodies[3] = { walker(2.0f), walker(4.0f), walker(6.0f) };
	bodies[0].velocity.x = std::numeric_limits<float>::quiet_NaN();
	bodies[1].radius = std::numeric_limits<float>::infinity();
	bodies[2].from.y = std::numeric_limits<float>::quiet_NaN();
	field.set_bodies(bodies, 3);
	field.step();
	CHECK(field.detached_followers(0)->count() == 0);
}
