#include "../stem/stems.hpp"
#include "allocations.hpp"
#include "field_fixture.hpp"
#include "stem/stem_shape.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace undergrowth;

namespace {

constexpr int PLANTS = 300;
constexpr int PAGE = 100;
constexpr float HALVES = 1e-3f; // Of a plant's length: rounding of a bend by half floats.

MotionSpecies reed() {
	StemBeam beam = stem_of(0.3, 0.5);
	beam.modes = 2;
	MotionSpecies species;
	species.law = Law::stem;
	species.stem = solve_stem(beam).constants;
	species.stem.dead_slope = 0.3f;
	return species;
}

FieldSimulation reeds(const FieldSettings &settings = {}) {
	FieldSimulation field(settings);
	add_plants(field, field.add_species(reed()), PLANTS, PAGE);
	field.set_wind(wave_wind());
	return field;
}

/// Around the lower half of plant 0 and its neighbours.
MovingBody body_at(const FieldSimulation &field, int page) {
	MovingBody body;
	body.from = body.to = field.page(page).root(0) + glm::vec3(0.05f, 0.3f, 0.0f);
	body.radius = 0.2f;
	return body;
}

void step(FieldSimulation &field, float seconds) {
	for (int i = 0; i < static_cast<int>(60.0f * seconds); i++) {
		field.step();
	}
}

/// Max distance (in lengths) between a point on a plant at the end of a step and at the start of the next.
float largest_jump(FieldSimulation &field) {
	std::vector<glm::vec3> before;
	const auto each_place = [&](float fraction, auto visit) {
		for (int page = 0; page < field.page_count(); page++) {
			for (int i = 0; i < field.page(page).size(); i += 7) {
				for (const float share : { 0.3f, 0.6f, 1.0f }) {
					visit(field.shown_point(page, i, share, fraction));
				}
			}
		}
	};
	each_place(1.0f, [&](const glm::vec3 &place) { before.push_back(place); });
	field.step();
	float max = 0.0f;
	std::size_t next = 0;
	each_place(0.0f, [&](const glm::vec3 &place) { max = std::max(max, glm::distance(place, before[next++])); });
	return max;
}

} // namespace

TEST_CASE("a stem with its two modes in one is a stem of one mode") {
	for (const double head : { 0.0, 0.5, 2.0 }) {
		CAPTURE(head);
		StemBeam beam = stem_of(0.4, head);
		beam.head_drag_area = 0.002f;
		const StemConstants alone = solve_stem(beam).constants;
		beam.modes = 2;
		const StemConstants made = in_one_mode(solve_stem(beam).constants);
		const float size = alone.mode[0].dead_share; // Of its amplitude, at a tip bend of 1.
		CHECK(made.modes == 1);
		CHECK(made.mode[0].frequency == alone.mode[0].frequency);
		CHECK(made.mode[0].stiffness == doctest::Approx(size * size * alone.mode[0].stiffness).epsilon(1e-4));
		CHECK(made.mode[0].mass == doctest::Approx(size * size * alone.mode[0].mass).epsilon(1e-4));
		CHECK(made.mode[0].air_drag == doctest::Approx(size * size * alone.mode[0].air_drag).epsilon(0.01));
		CHECK(made.mode[0].air_lag == doctest::Approx(size * alone.mode[0].air_lag).epsilon(0.01));
		for (int j = 0; j <= alone.joints; j++) {
			CHECK(made.deflection[j][0] == doctest::Approx(size * alone.deflection[j][0]).epsilon(1e-4));
		}
	}
}

TEST_CASE("stems of a field step a second mode only during pushes and for a while after them") {
	FieldSimulation field = reeds();
	step(field, 1.0f);
	CHECK(field.page(0).modes() == 1);
	const MovingBody body = body_at(field, 0);
	field.set_bodies(&body, 1);
	field.step();
	field.step();
	CHECK(field.page(0).modes() == 2);
	CHECK(field.page(2).modes() == 1);
	field.set_bodies(nullptr, 0);
	step(field, DetachedFollowers::ALONE + 1.0f);
	CHECK(field.page(0).modes() == 2);
	step(field, DetachedFollowers::GOING_BACK);
	CHECK(field.page(0).modes() == 1);
}

TEST_CASE("impulses, touching tips and near cameras also start a second mode") {
	FieldSimulation field = reeds();
	field.step();
	field.apply_impulse(0, 3, { 0.002f, 0.0f, 0.0f });
	CHECK(field.page(0).modes() == 2);
	field.page(1).move_tip(2, { 0.01f, 0.0f, 0.0f }, {});
	field.set_page_near(2, true);
	field.step();
	CHECK(field.page(1).modes() == 2);
	CHECK(field.page(2).modes() == 2);
	CHECK(field.changed_pages().size() == 3);
	step(field, 6.0f);
	CHECK(field.page(1).modes() == 1);
	CHECK(field.page(2).modes() == 2);
}

TEST_CASE("a state with a second mode starts it and is returned again") {
	FieldSimulation field = reeds();
	field.step();
	const TipState tip = { glm::normalize(glm::vec3(0.3f, 1.0f, 0.1f)), { 0.2f, 0.0f, 0.1f } };
	field.set_state(0, 5, tip, {});
	CHECK(field.page(0).modes() == 1);
	const glm::vec2 rest = field.page(0).rest_bend(5);
	const StemSecond second = { turned({ 0.02f, 0.0f, -0.01f }, rest), turned({ 0.3f, 0.0f, 0.2f }, rest) };
	field.set_state(0, 5, tip, second);
	CHECK(field.page(0).modes() == 2);
	CHECK(glm::distance(field.motion(0, 5).second.bend, second.bend) < 1e-6f);
	CHECK(glm::distance(field.motion(0, 5).second.rate, second.rate) < 1e-5f);
	CHECK(glm::distance(field.state(0, 5).direction, tip.direction) < 1e-5f);
	const glm::vec3 along_sphere = tip.rate - glm::dot(tip.rate, tip.direction) * tip.direction;
	CHECK(glm::distance(field.state(0, 5).rate, along_sphere) < 1e-5f);
	CHECK(glm::length(field.motion(0, 6).second.bend) < 1e-6f);
}

TEST_CASE("no drawn pose jumps when a second mode begins or ends") {
	FieldSettings settings;
	for (const int interval : { 1, 3 }) {
		CAPTURE(interval);
		settings.update_interval = interval;
		FieldSimulation field = reeds(settings);
		step(field, 2.0f);
		const MovingBody body = body_at(field, 0);
		bool was_two = false;
		for (int i = 0; i < 400; i++) {
			field.set_bodies(&body, i < 40 ? 1 : 0);
			if (i == 60) {
				field.apply_impulse(1, 7, { 0.001f, 0.0f, 0.0f }); // Half way between two steps.
			}
			CAPTURE(i);
			REQUIRE(largest_jump(field) < HALVES);
			was_two = was_two || field.page(0).modes() == 2;
		}
		CHECK(was_two);
		CHECK(field.page(0).modes() == 1);
		CHECK(field.page(1).modes() == 1);
	}
}

TEST_CASE("stems near an approaching camera gain their second mode gradually") {
	FieldSimulation field = reeds();
	FieldSimulation awake = reeds();
	awake.set_page_near(0, true);
	step(field, 2.0f);
	step(awake, 2.0f);
	field.set_page_near(0, true);
	const auto second = [](const FieldSimulation &one) {
		float sum = 0.0f;
		for (int i = 0; i < PAGE; i++) {
			sum += glm::length(one.motion(0, i).second.bend);
		}
		return sum;
	};
	field.step();
	awake.step();
	CHECK(field.page(0).modes() == 2);
	CHECK(second(field) < 0.1f * second(awake));
	step(field, 20.0f);
	step(awake, 20.0f);
	CHECK(second(field) == doctest::Approx(second(awake)).epsilon(0.1));
}

TEST_CASE("repeated changes of modes in still air start no motion") {
	FieldSimulation field = reeds();
	FieldWind still;
	still.wind.strength = 0.0f;
	step(field, 2.0f);
	field.set_wind(still);
	for (int i = 0; i < 6; i++) {
		field.set_page_near(0, i % 2 == 0);
		step(field, 6.0f);
	}
	for (int i = 0; i < PAGE; i++) {
		CHECK(glm::distance(field.state(0, i).direction, field.rest(0, i)) < 1e-3f);
	}
}

TEST_CASE("an impulse moves a stem of one stepped mode like a stem of two") {
	FieldSimulation field = reeds();
	FieldSimulation awake = reeds();
	awake.set_page_near(0, true);
	for (FieldSimulation *one : { &field, &awake }) {
		FieldWind still;
		still.wind.strength = 0.0f;
		one->set_wind(still);
		one->settle();
		step(*one, 1.0f);
		one->apply_impulse(0, 3, { 0.002f, 0.0f, 0.001f });
		step(*one, 0.3f);
	}
	const StemState a = field.page(0).stem(3);
	const StemState b = awake.page(0).stem(3);
	CHECK(glm::length(a.place[1]) > 1e-4f);
	for (int k = 0; k < 2; k++) {
		CHECK(glm::distance(a.place[k], b.place[k]) < 1e-5f);
	}
}

TEST_CASE("changes of modes allocate nothing in steps and do not depend on threads") {
	FieldSimulation field = reeds();
	FieldSimulation other = reeds();
	const MovingBody body = body_at(field, 1);
	field.set_bodies(&body, 1);
	field.step();
	other.set_bodies(&body, 1);
	other.step();
	const long before = allocation_count();
	for (int i = 0; i < 400; i++) {
		field.set_bodies(&body, i < 30 ? 1 : 0);
		field.step();
	}
	CHECK(allocation_count() == before);
	for (int i = 0; i < 400; i++) {
		other.set_bodies(&body, i < 30 ? 1 : 0);
		other.begin_step();
		for (int page = other.page_count() - 1; page >= 0; page--) {
			other.step_pages(page, page + 1);
		}
	}
	CHECK(hash_field(field) == hash_field(other));
}

TEST_CASE("in a steady wind stems of two modes that follow prototypes have the pose of both modes") {
	FieldSettings settings;
	settings.prototypes = 8;
	MotionSpecies species = reed();
	species.shortest = species.longest = species.stem.length;
	FieldSimulation field(settings);
	add_plants(field, field.add_species(species), PLANTS, PAGE);
	FieldWind steady;
	steady.wind.kind = WindKind::constant;
	steady.wind.strength = 2.0f;
	field.set_wind(steady);
	step(field, 60.0f);
	const double slope = static_cast<double>(2.0f * species.stem.dead_slope);
	CHECK(first_share(species.stem) > 1.01f);
	CHECK(glm::length(field.shown_bend(0, 0, 1.0f)) ==
			doctest::Approx(slope / (1.0 + std::sqrt(1.0 + slope * slope))).epsilon(0.005));
}
