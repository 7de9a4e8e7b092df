#include "swing.hpp"

#include "../field/allocations.hpp"
#include "base/random.hpp"
#include "wind/travelling_wind.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <vector>

using namespace undergrowth;

namespace {

constexpr Law BOTH_LAWS[] = { Law::elasticity, Law::spring };
constexpr float STATE_TOLERANCE = 1e-6f;
constexpr float BEND_TOLERANCE = 1.1e-3f;

float noise(int index, int which) {
	return signed_noise(static_cast<uint64_t>(which), static_cast<uint64_t>(index));
}

MotionPlant varied_plant(int index) {
	MotionPlant plant;
	plant.root = { 20.0f * noise(index, 14), 0.0f, 20.0f * noise(index, 15) };
	plant.length = 1.0f + 0.8f * noise(index, 1);
	plant.rest = glm::normalize(glm::vec3(0.5f * noise(index, 7), 1.0f, 0.5f * noise(index, 8)));
	return plant;
}

Joint varied_joint(int index) {
	Joint joint;
	joint.mass = 0.6f + 0.5f * noise(index, 2);
	joint.elasticity = 5.0f + 4.0f * noise(index, 3);
	joint.inner_friction = 0.3f + 0.3f * noise(index, 4);
	joint.above_ground = index % 3 != 0;
	joint.natural_frequency = 1.5f + noise(index, 5);
	joint.damping_ratio = 0.8f + 0.8f * noise(index, 6);
	return joint;
}

TipState varied_state(int index) {
	return { { noise(index, 9), 1.0f, noise(index, 10) }, { noise(index, 11), noise(index, 12), noise(index, 13) } };
}

/// Plants [first, first + count), each in a state of its own, under one species.
MotionPage meadow(Law law, int first, int count, MotionPage::Keeps keeps = MotionPage::Keeps::directions) {
	std::vector<MotionPlant> plants;
	for (int i = 0; i < count; i++) {
		plants.push_back(varied_plant(first + i));
	}
	MotionPage page(0, species_with(law, varied_joint(1)), plants.data(), count, FRAME_STEP, true, keeps);
	for (int i = 0; i < count; i++) {
		page.set_state(i, varied_state(first + i));
	}
	return page;
}

void blow(MotionPage &page, int step, SimdLevel level = best_simd_level()) {
	FieldWind wind;
	wind.wind.kind = WindKind::waves;
	wind.wind.strength = 2.0f;
	wind.wind.direction = 0.9f;
	page.step(wind_at_time(wind, step * static_cast<double>(FRAME_STEP)), winds_along(wind), level);
}

bool same_bits(const TipState &a, const TipState &b) {
	return std::memcmp(&a, &b, sizeof a) == 0;
}

bool is_finite(const TipState &state) {
	return std::isfinite(state.direction.x + state.direction.y + state.direction.z) &&
			std::isfinite(state.rate.x + state.rate.y + state.rate.z);
}

} // namespace

TEST_CASE("an empty page steps and interpolates without effect") {
	for (const Law law : BOTH_LAWS) {
		MotionPage page(0, species_with(law, {}), nullptr, 0, FRAME_STEP, true, MotionPage::Keeps::directions);
		blow(page, 0);
		page.interpolate(0.5f, nullptr);
		CHECK(page.size() == 0);
		CHECK(page.step_length() == FRAME_STEP);
	}
}

TEST_CASE("a state comes back as it was put in") {
	for (const Law law : BOTH_LAWS) {
		const glm::vec3 direction = glm::normalize(glm::vec3(0.4f, 0.8f, -0.2f));
		const glm::vec3 raw = { 0.3f, -0.1f, 0.9f };
		const glm::vec3 rate = raw - glm::dot(raw, direction) * direction;
		const MotionPage page = plant_page(law, {}, { direction, rate });
		CHECK(glm::length(page.state(0).direction - direction) < STATE_TOLERANCE);
		CHECK(glm::length(page.state(0).rate - rate) < STATE_TOLERANCE);
	}
}

TEST_CASE("the state and what was drawn before survive a change of law, there and back") {
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

TEST_CASE("a tip below the ground comes to the spring law just above the horizon") {
	for (const glm::vec3 &direction : { glm::vec3(0.0f, -1.0f, 0.0f), glm::vec3(0.8f, -0.6f, 0.0f) }) {
		const MotionPage page = plant_page(Law::spring, {}, { direction, { 0.0f, 0.0f, 2.0f } });
		CHECK(is_finite(page.state(0)));
		CHECK(page.state(0).direction.y > 0.0f);
	}
}

TEST_CASE("a plant that took another's place goes on as if it had always stood there") {
	for (const Law law : BOTH_LAWS) {
		for (const MotionPage::Keeps keeps : { MotionPage::Keeps::bends, MotionPage::Keeps::directions }) {
			MotionPage moved = meadow(law, 0, 40, keeps);
			MotionPage alone = meadow(law, 39, 1, keeps);
			for (int i = 0; i < 60; i++) {
				if (i == 30) {
					moved.remove(3);
				}
				blow(moved, i);
				blow(alone, i);
			}
			CHECK(same_bits(moved.state(3), alone.state(0)));
			CHECK(moved.before(3) == alone.before(0));
			CHECK(moved.size() == 39);
		}
	}
}

TEST_CASE("a plant that grows, moves or turns goes on from where it is, and is then as one that always was so") {
	for (const Law law : BOTH_LAWS) {
		MotionPage changed = meadow(law, 0, 5);
		blow(changed, 0);
		const TipState before = changed.state(2);
		changed.set_plant(2, varied_plant(77));
		CHECK(same_bits(changed.state(2), before));
		CHECK(changed.root(2) == varied_plant(77).root);
		MotionPage always = meadow(law, 77, 1);
		always.set_state(0, before);
		changed.set_state(2, before);
		for (int i = 1; i < 30; i++) {
			blow(changed, i);
			blow(always, i);
		}
		CHECK(same_bits(changed.state(2), always.state(0)));
	}
}

TEST_CASE("a species' property that changes is felt by plants that stand") {
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

TEST_CASE("plants swing to the rest directions that they are given, also after their law changed there and back") {
	Joint joint;
	joint.damping_ratio = 1.0f;
	const glm::vec3 lean = glm::normalize(glm::vec3(0.6f, 0.8f, 0.1f));
	MotionPage page = plant_page(Law::spring, joint, leaning(0.0));
	page.set_species(species_with(Law::elasticity, joint));
	page.set_rests(&lean);
	CHECK(page.rest(0) == glm::vec3(0.0f, 1.0f, 0.0f));
	page.set_species(species_with(Law::spring, joint));
	CHECK(page.rest(0) == glm::vec3(0.0f, 1.0f, 0.0f));
	page.set_rests(&lean);
	CHECK(glm::length(page.rest(0) - lean) < STATE_TOLERANCE);
	record_x(page, 1200);
	CHECK(glm::length(page.state(0).direction - lean) < STATE_TOLERANCE);
}

TEST_CASE("a blow changes the velocity by impulse/mass along the sphere, and not what was drawn before") {
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

TEST_CASE("interpolation goes from the last step but one to the last") {
	for (const Law law : BOTH_LAWS) {
		MotionPage page = meadow(law, 0, 37);
		for (int i = 0; i < 20; i++) {
			blow(page, i);
		}
		std::vector<glm::vec3> before;
		for (int i = 0; i < 37; i++) {
			before.push_back(page.state(i).direction);
		}
		blow(page, 20);
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

TEST_CASE("a page that keeps directions moves as one that keeps bends") {
	for (const Law law : BOTH_LAWS) {
		MotionPage floats = meadow(law, 0, 600);
		MotionPage halves = meadow(law, 0, 600, MotionPage::Keeps::bends);
		for (int i = 0; i < 40; i++) {
			blow(floats, i);
			blow(halves, i);
		}
		CHECK(hash_states(floats) == hash_states(halves));
		for (int i = 0; i < 600; i++) {
			REQUIRE(glm::distance(floats.before(i), halves.before(i)) < BEND_TOLERANCE);
		}
	}
}

TEST_CASE("plants divided among pages anyhow, at every level, give the same bits") {
	for (const Law law : BOTH_LAWS) {
		MotionPage whole = meadow(law, 0, 601);
		MotionPage best = meadow(law, 0, 601);
		MotionPage first = meadow(law, 0, 123);
		MotionPage rest = meadow(law, 123, 478);
		for (int i = 0; i < 300; i++) {
			blow(whole, i, SimdLevel::baseline);
			blow(best, i, SimdLevel::avx2);
			blow(first, i, i % 2 == 0 ? SimdLevel::avx2 : SimdLevel::baseline);
			blow(rest, i);
		}
		CHECK(hash_states(whole) == hash_states(best));
		for (int i = 0; i < 601; i++) {
			REQUIRE(same_bits(whole.state(i), i < 123 ? first.state(i) : rest.state(i - 123)));
		}
	}
}

TEST_CASE("a step of a page that keeps directions allocates nothing") {
	for (const Law law : BOTH_LAWS) {
		MotionPage page = meadow(law, 0, 1000);
		std::vector<glm::vec3> drawn(1000);
		blow(page, 0);
		const long before = allocation_count();
		for (int i = 1; i < 30; i++) {
			blow(page, i);
			page.interpolate(0.5f, drawn.data());
		}
		CHECK(allocation_count() == before);
	}
}

TEST_CASE("no joint, state or wind, however extreme, leads to a number that is none") {
	constexpr float NONE = std::numeric_limits<float>::quiet_NaN();
	constexpr float INF = std::numeric_limits<float>::infinity();
	constexpr float EXTREMES[] = { 0.0f, 1e-30f, 1e-6f, 1.0f, 1e6f, 1e30f, -1.0f, NONE, INF };
	std::vector<MotionPage> pages;
	for (const Law law : BOTH_LAWS) {
		for (const float a : EXTREMES) {
			for (const float b : EXTREMES) {
				Joint joint;
				joint.mass = b;
				joint.length = std::isfinite(a) && a > 0.0f ? a : 1.0f;
				pages.push_back(plant_page(law, joint, leaning(1.0)));
				joint = Joint{};
				joint.elasticity = a;
				joint.inner_friction = b;
				joint.natural_frequency = a;
				joint.damping_ratio = b;
				pages.push_back(plant_page(law, joint, leaning(-0.5)));
				joint.length = 1e-3f;
				joint.mass = 1e-3f;
				joint.wind_weight = a;
				joint.above_ground = false;
				pages.push_back(plant_page(law, joint, { { a, b, 1.0f }, { b, a, a } }));
			}
		}
	}
	const float strengths[] = { 1e6f, 0.0f, NONE, 1e30f, INF };
	for (MotionPage &page : pages) {
		for (int i = 0; i < 500; i++) {
			FieldWind wind;
			wind.wind.strength = strengths[(i / 7) % 5];
			wind.wind.direction = (i / 7) % 5 == 2 ? NONE : static_cast<float>(i);
			page.step(wind_at_time(wind, i), winds_along(wind));
			if (i % 100 == 0) {
				page.apply_impulse(0, { 1e6f, -1e6f, NONE });
				page.apply_impulse(0, { 1e6f, -1e6f, 1e30f });
			}
		}
		glm::vec3 drawn;
		page.interpolate(0.5f, &drawn);
		REQUIRE(is_finite(page.state(0)));
		REQUIRE(std::fabs(glm::length(page.state(0).direction) - 1.0f) < 4.0f * STATE_TOLERANCE);
		REQUIRE(std::fabs(glm::length(drawn) - 1.0f) < 4.0f * STATE_TOLERANCE);
	}
}

TEST_CASE("a run of each law has the same bits on every platform") {
	constexpr uint64_t ELASTICITY_GOLDEN = 0xb68b263b2a6dc52aull;
	constexpr uint64_t SPRING_GOLDEN = 0x60ec898e2215eba4ull;
	for (const Law law : BOTH_LAWS) {
		MotionPage page = meadow(law, 0, 50);
		for (int i = 0; i < 600; i++) {
			blow(page, i);
		}
		CHECK(hash_states(page) == (law == Law::elasticity ? ELASTICITY_GOLDEN : SPRING_GOLDEN));
	}
}
