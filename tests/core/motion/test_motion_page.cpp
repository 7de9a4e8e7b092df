#include "varied.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <vector>

using namespace undergrowth;

namespace {

constexpr float BEND_TOLERANCE = 1.1e-3f;

} // namespace

TEST_CASE("an empty page steps and interpolates without effect") {
	for (const Law law : BOTH_LAWS) {
		MotionPage page(0, species_with(law, {}), nullptr, 0, FRAME_STEP, true, MotionPage::Keeps::directions);
		apply_wind(page, 0);
		page.interpolate(0.5f, nullptr);
		CHECK(page.size() == 0);
		CHECK(page.step_length() == FRAME_STEP);
	}
}

TEST_CASE("a set state is returned unchanged") {
	for (const Law law : BOTH_LAWS) {
		const glm::vec3 direction = glm::normalize(glm::vec3(0.4f, 0.8f, -0.2f));
		const glm::vec3 raw = { 0.3f, -0.1f, 0.9f };
		const glm::vec3 rate = raw - glm::dot(raw, direction) * direction;
		const MotionPage page = plant_page(law, {}, { direction, rate });
		CHECK(glm::length(page.state(0).direction - direction) < STATE_TOLERANCE);
		CHECK(glm::length(page.state(0).rate - rate) < STATE_TOLERANCE);
	}
}

TEST_CASE("the state and the previous drawn pose survive a change of law and back") {
	MotionPage page = meadow(Law::elasticity, 0, 200);
	std::vector<TipState> states;
	std::vector<glm::vec3> last;
	for (int i = 0; i < 200; i++) {
		page.set_before(i, varied_state(i + 1).direction);
		states.push_back(page.state(i));
		last.push_back(page.before(i));
	}
	for (const Law law : { Law::spring, Law::elasticity }) {
		page.set_species(species_with(law, varied_joint(1)));
		for (int i = 0; i < 200; i++) {
			const auto at = static_cast<size_t>(i);
			CHECK(glm::length(page.state(i).direction - states[at].direction) < 4.0f * STATE_TOLERANCE);
			CHECK(glm::length(page.state(i).rate - states[at].rate) < 4.0f * STATE_TOLERANCE);
			CHECK(glm::length(page.before(i) - last[at]) < 4.0f * STATE_TOLERANCE);
		}
	}
}

TEST_CASE("with the spring law a tip below the ground moves to just above the horizon") {
	for (const glm::vec3 &direction : { glm::vec3(0.0f, -1.0f, 0.0f), glm::vec3(0.8f, -0.6f, 0.0f) }) {
		const MotionPage page = plant_page(Law::spring, {}, { direction, { 0.0f, 0.0f, 2.0f } });
		CHECK(is_finite(page.state(0)));
		CHECK(page.state(0).direction.y > 0.0f);
	}
}

TEST_CASE("a plant at another's row continues like one that was always there") {
	for (const Law law : BOTH_LAWS) {
		for (const MotionPage::Keeps keeps : { MotionPage::Keeps::bends, MotionPage::Keeps::directions }) {
			MotionPage moved = meadow(law, 0, 40, keeps);
			MotionPage alone = meadow(law, 39, 1, keeps);
			for (int i = 0; i < 60; i++) {
				if (i == 30) {
					moved.remove(3);
				}
				apply_wind(moved, i);
				apply_wind(alone, i);
			}
			CHECK(same_bits(moved.state(3), alone.state(0)));
			CHECK(moved.before(3) == alone.before(0));
			CHECK(moved.size() == 39);
		}
	}
}

TEST_CASE("a plant that grows, moves or turns continues from its state, like one that was always so") {
	for (const Law law : BOTH_LAWS) {
		MotionPage changed = meadow(law, 0, 5);
		apply_wind(changed, 0);
		const TipState before = changed.state(2);
		changed.set_plant(2, varied_plant(77));
		CHECK(same_bits(changed.state(2), before));
		CHECK(changed.root(2) == varied_plant(77).root);
		MotionPage always = meadow(law, 77, 1);
		always.set_state(0, before);
		changed.set_state(2, before);
		for (int i = 1; i < 30; i++) {
			apply_wind(changed, i);
			apply_wind(always, i);
		}
		CHECK(same_bits(changed.state(2), always.state(0)));
	}
}

TEST_CASE("a changed property of a species applies to existing plants") {
	for (const Law law : BOTH_LAWS) {
		for (float Joint::*property :
				{ &Joint::mass, &Joint::wind_weight, &Joint::elasticity, &Joint::natural_frequency }) {
			Joint joint;
			MotionPage page = plant_page(law, joint, leaning(0.2));
			joint.*property *= 3.0f;
			const TipState before = page.state(0);
			page.set_species(species_with(law, joint));
			CHECK(same_bits(page.state(0), before));
			MotionPage fresh = plant_page(law, joint, leaning(0.2));
			for (int i = 0; i < 20; i++) {
				step_in(page, { 0.5f, 0.0f, 0.0f });
				step_in(fresh, { 0.5f, 0.0f, 0.0f });
			}
			CHECK(same_bits(page.state(0), fresh.state(0)));
		}
	}
}

TEST_CASE("plants swing to given rest directions, also after a change of law and back") {
	Joint joint;
	joint.damping_ratio = 1.0f;
	const glm::vec3 lean = glm::normalize(glm::vec3(0.6f, 0.8f, 0.1f));
	MotionPage page = plant_page(Law::spring, joint, leaning(0.0));
	page.set_species(species_with(Law::elasticity, joint));
	page.set_rests(0, &lean, 1);
	CHECK(page.rest(0) == glm::vec3(0.0f, 1.0f, 0.0f));
	page.apply_impulse(0, { 0.5f, 0.0f, 0.7f }); // A swinging plant must not be mistaken for one at rest.
	record_x(page, 10);
	page.set_species(species_with(Law::spring, joint));
	CHECK(page.rest(0) == glm::vec3(0.0f, 1.0f, 0.0f));
	page.set_rests(0, &lean, 1);
	CHECK(glm::length(page.rest(0) - lean) < STATE_TOLERANCE);
	record_x(page, 1200);
	CHECK(glm::length(page.state(0).direction - lean) < STATE_TOLERANCE);
}

TEST_CASE("an impulse changes the velocity by impulse/mass along the sphere, and not the previous drawn pose") {
	for (const Law law : BOTH_LAWS) {
		Joint joint;
		joint.length = 2.0f;
		joint.mass = 0.5f;
		MotionPage page = plant_page(law, joint, leaning(0.5));
		page.set_before(0, leaning(0.4).direction);
		page.apply_impulse(0, { 1.0f, 0.0f, 0.3f });
		const TipState tip = page.state(0);
		const float along = static_cast<float>(std::cos(0.5));
		CHECK(glm::length(tip.rate - glm::vec3(along * along, -along * std::sin(0.5f), 0.3f)) < 4.0f * STATE_TOLERANCE);
		CHECK(glm::length(tip.direction - leaning(0.5).direction) < STATE_TOLERANCE);
		CHECK(glm::length(page.before(0) - leaning(0.4).direction) < STATE_TOLERANCE);
	}
}

TEST_CASE("interpolation runs from the last step but one to the last") {
	for (const Law law : BOTH_LAWS) {
		MotionPage page = meadow(law, 0, 37);
		for (int i = 0; i < 20; i++) {
			apply_wind(page, i);
		}
		std::vector<glm::vec3> before;
		for (int i = 0; i < 37; i++) {
			before.push_back(page.state(i).direction);
		}
		apply_wind(page, 20);
		std::vector<glm::vec3> start(37), middle(37), end(37);
		page.interpolate(0.0f, start.data());
		page.interpolate(0.5f, middle.data());
		page.interpolate(1.0f, end.data());
		for (size_t i = 0; i < 37; i++) {
			const glm::vec3 now = page.state(static_cast<int>(i)).direction;
			CHECK(glm::length(start[i] - before[i]) < STATE_TOLERANCE);
			CHECK(glm::length(page.before(static_cast<int>(i)) - before[i]) < STATE_TOLERANCE);
			CHECK(glm::length(end[i] - now) < STATE_TOLERANCE);
			CHECK(std::fabs(glm::length(middle[i]) - 1.0f) < STATE_TOLERANCE);
			CHECK(glm::length(middle[i] - glm::normalize(before[i] + now)) < 0.02f);
		}
	}
}

TEST_CASE("a page with directions moves like one with bends") {
	for (const Law law : BOTH_LAWS) {
		MotionPage floats = meadow(law, 0, 600);
		MotionPage halves = meadow(law, 0, 600, MotionPage::Keeps::bends);
		for (int i = 0; i < 40; i++) {
			apply_wind(floats, i);
			apply_wind(halves, i);
		}
		CHECK(hash_states(floats) == hash_states(halves));
		for (int i = 0; i < 600; i++) {
			REQUIRE(glm::distance(floats.before(i), halves.before(i)) < BEND_TOLERANCE);
		}
	}
}
