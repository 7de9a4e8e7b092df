#include "../field/field_fixture.hpp"
#include "../figures.hpp"
#include "../stem/stems.hpp"
#include "stem_plants.hpp"

#include "motion/part_bend.hpp"
#include "stem/stem_bones.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <vector>

using namespace undergrowth;

namespace {

constexpr float BEND_TOLERANCE = 2e-3f; // Of a tip: a quarter of a degree.
constexpr float CALM_TOLERANCE = 5e-4f; // The bend falls on meanwhile.
constexpr float RATE_TOLERANCE = 0.05f; // Relative, between step lengths, of a bend that a moving body left.
constexpr float GROUND_TOLERANCE = 1e-3f; // m.
constexpr float RECOVERY = 40.0f; // s.

MotionSpecies trodden_species(float share, bool is_graded = false) {
	MotionSpecies species = species_of(Law::stem);
	species.stem = stem_of_two_modes(1.5, 0.15);
	species.stem.spread = is_graded ? 0.2f : 0.0f;
	species.trampling = { share, RECOVERY };
	return species;
}

FieldSimulation calm_field(
		const MotionSpecies &species, const std::vector<MotionPlant> &plants, float step = FIELD_STEP) {
	FieldSettings settings;
	settings.step = step;
	FieldSimulation field(settings);
	field.add_page(field.add_species(species), plants.data(), static_cast<int>(plants.size()));
	field.set_wind({ { WindKind::constant, 0.0f }, 0.0f });
	return field;
}

void run(FieldSimulation &field, double seconds) {
	const auto count = static_cast<int>(std::lround(seconds / static_cast<double>(field.settings().step)));
	for (int i = 0; i < count; i++) {
		field.step();
	}
}

glm::vec2 tip_of(const FieldSimulation &field, int index = 0) {
	const MotionPage &page = field.page(0);
	return tip_bend(page.stem_constants(), page.stem(index));
}

/// A ball that holds the upper half of a plant at the origin aside.
MovingBody holding_ball() {
	MovingBody ball;
	ball.from = ball.to = { -0.1f, 0.75f, 0.0f };
	ball.radius = 0.3f;
	return ball;
}

/// Bend that lasts after a ball passed over a plant at 1 m/s, one second later.
float left_by_pass(FieldSimulation &field, float speed = 1.0f) {
	const float step = field.settings().step;
	const auto count = static_cast<int>(std::lround(2.0f / (speed * step)));
	for (int i = 0; i <= count; i++) {
		MovingBody ball = holding_ball();
		ball.from = ball.to = { -1.0f + static_cast<float>(i) * speed * step, 0.5f, 0.0f };
		ball.velocity = { speed, 0.0f, 0.0f };
		field.set_bodies(&ball, 1);
		field.step();
	}
	field.set_bodies(nullptr, 0);
	return field.lasting_bend(0, 0).x;
}

} // namespace

TEST_CASE("a species' share of a bend that a body held for the time of a contact lasts") {
	for (const float share : { 0.25f, 0.6f, 1.0f }) {
		FieldSimulation field = calm_field(trodden_species(share), { MotionPlant() });
		const MovingBody ball = holding_ball();
		field.set_bodies(&ball, 1);
		field.step(); // The ball moves the plant aside.
		run(field, 5.0);
		const float held = tip_of(field).x;
		CHECK(held > 0.2f);
		FieldSimulation other = calm_field(trodden_species(share), { MotionPlant() });
		other.set_bodies(&ball, 1);
		run(other, static_cast<double>(Trampling::CONTACT));
		CHECK(other.lasting_bend(0, 0).x == doctest::Approx(share * held).epsilon(0.06));
		CHECK(field.lasting_bend(0, 0).x == doctest::Approx(held).epsilon(share < 0.5f ? 0.1 : 0.05));
	}
}

TEST_CASE("a trodden plant comes to rest at its lasting bend, which falls to 37 % in the recovery time") {
	for (const bool is_graded : { false, true }) {
		MotionPlant plant;
		plant.rest = glm::normalize(glm::vec3(0.1f, 1.0f, -0.2f));
		plant.own = 0.7f;
		FieldSimulation field = calm_field(trodden_species(0.5f, is_graded), { plant });
		field.set_lasting_bend(0, 0, { 0.5f, -0.2f });
		run(field, static_cast<double>(RECOVERY));
		const glm::vec2 left = field.lasting_bend(0, 0);
		CHECK(left.x == doctest::Approx(0.5 * std::exp(-1.0)).epsilon(1e-3));
		CHECK(left.y == doctest::Approx(-0.2 * std::exp(-1.0)).epsilon(1e-3));
		figures::record(figures::SWINGS, "bend of a trodden plant after its recovery time, of that before",
				std::exp(-1.0), static_cast<double>(glm::length(tip_of(field))) / std::hypot(0.5, 0.2), 3);
		CHECK(glm::length(tip_of(field) - left) < CALM_TOLERANCE);
		CHECK(glm::length(field.rest(0, 0) - plant.rest) < 1e-3f);
		run(field, 8.0 * static_cast<double>(RECOVERY));
		CHECK(field.lasting_bend(0, 0) == glm::vec2(0.0f));
		CHECK(glm::length(tip_of(field)) < BEND_TOLERANCE);
	}
}

TEST_CASE("wind bends a trodden plant about its lasting bend") {
	FieldSimulation field = calm_field(trodden_species(0.5f), { MotionPlant(), MotionPlant() });
	field.set_lasting_bend(0, 0, { 0.2f, 0.0f });
	field.set_wind({ { WindKind::constant, 0.1f }, 0.0f });
	run(field, 12.0);
	CHECK(glm::length(tip_of(field, 1)) > 0.05f);
	const glm::vec2 by_wind = tip_of(field, 0) - field.lasting_bend(0, 0);
	CHECK(glm::length(by_wind - tip_of(field, 1)) < 0.2f * glm::length(tip_of(field, 1)));
}

TEST_CASE("a passing body leaves the same bend at every step length, and repeated passes make it deeper") {
	float by_step[3] = {};
	int i = 0;
	for (const float step : { 1.0f / 30.0f, 1.0f / 60.0f, 1.0f / 144.0f }) {
		FieldSimulation field = calm_field(trodden_species(0.5f), { MotionPlant() }, step);
		by_step[i++] = left_by_pass(field);
	}
	CHECK(by_step[1] > 0.1f);
	CHECK(by_step[0] == doctest::Approx(by_step[1]).epsilon(RATE_TOLERANCE));
	CHECK(by_step[2] == doctest::Approx(by_step[1]).epsilon(RATE_TOLERANCE));

	FieldSimulation field = calm_field(trodden_species(0.2f), { MotionPlant() });
	const float once = left_by_pass(field);
	const float twice = left_by_pass(field);
	CHECK(twice > 1.3f * once);
	CHECK(left_by_pass(field) > twice);
}

TEST_CASE("a body that bends a trodden plant less than it is bent leaves it as it is") {
	const MotionPlant plant;
	MotionPage page(0, trodden_species(0.5f), &plant, 1, FIELD_STEP, true);
	page.set_lasting_bend(0, { 0.5f, 0.0f });
	page.let_last(0, { 0.0f, 0.4f }, 0.5f);
	CHECK(page.lasting_bend(0) == glm::vec2(0.5f, 0.0f));
	page.let_last(0, { 0.9f, 0.0f }, 0.5f);
	CHECK(page.lasting_bend(0).x == doctest::Approx(0.7));
}

TEST_CASE("without trampling, and in the other laws, no bend lasts and no memory is used") {
	for (const bool is_stem : { true, false }) {
		MotionSpecies species = trodden_species(is_stem ? 0.0f : 0.5f);
		species.law = is_stem ? Law::stem : Law::spring;
		FieldSimulation field = calm_field(species, { MotionPlant() });
		const double bytes = field.bytes_per_plant();
		CHECK(left_by_pass(field) == 0.0f);
		CHECK(field.bytes_per_plant() == bytes);
	}
}

TEST_CASE("a page frees its lasting bends when all plants have recovered") {
	std::vector<MotionPlant> plants(500);
	FieldSimulation field = calm_field(trodden_species(0.5f), plants);
	const double bytes = field.bytes_per_plant();
	left_by_pass(field);
	CHECK(field.bytes_per_plant() > bytes);
	run(field, 8.0 * static_cast<double>(RECOVERY));
	CHECK(field.bytes_per_plant() == bytes);
}

TEST_CASE("lasting bends follow their plants through additions, removals and transfers, and end at a reset") {
	std::vector<MotionPlant> plants(200);
	MotionPage page(0, trodden_species(0.5f), plants.data(), 200, FIELD_STEP, true);
	page.set_lasting_bend(3, { 0.1f, 0.0f });
	page.set_lasting_bend(199, { 0.2f, 0.0f });
	page.add(plants.data(), 100);
	CHECK(page.lasting_bend(299) == glm::vec2(0.0f));
	page.set_lasting_bend(299, { 0.3f, 0.0f });
	page.remove(3);
	CHECK(page.lasting_bend(3).x == 0.3f);
	page.drop(3);
	CHECK(page.lasting_bend(3).x == 0.0f);
	MotionPage other(0, trodden_species(0.5f), plants.data(), 200, FIELD_STEP, true);
	other.transfer_motion(7, page, 199);
	CHECK(other.lasting_bend(7).x == 0.2f);
	other.transfer_motion(7, page, 5);
	CHECK(other.lasting_bend(7).x == 0.0f);
	page.settle();
	CHECK(page.lasting_bend(199).x == 0.0f);
}

TEST_CASE("lasting bends are valid: not below the ground, and numbers") {
	constexpr float NONE = std::numeric_limits<float>::quiet_NaN();
	std::vector<MotionPlant> plants(64);
	for (int i = 0; i < 64; i++) {
		plants[static_cast<std::size_t>(i)].rest = glm::normalize(
				glm::vec3(std::cos(0.1f * static_cast<float>(i)), 1.0f, std::sin(0.1f * static_cast<float>(i))));
	}
	MotionSpecies species = trodden_species(1.0f);
	species.stem = jointed(4, 0.5, 0.5);
	for (const int interval : { 1, 16 }) { // Modes that are too fast take their equilibrium.
		FieldSimulation field = calm_field(species, plants);
		field.set_update_interval(interval);
		for (int i = 0; i < 64; i++) {
			field.set_lasting_bend(0, i, { 5.0f, i % 2 == 0 ? 0.0f : 1e30f });
		}
		field.set_lasting_bend(0, 9, { NONE, 1.0f });
		CHECK(field.lasting_bend(0, 9) == glm::vec2(0.0f));
		run(field, 3.0);
		for (int i = 0; i < 64; i++) {
			const float height = field.page(0).tip(i).y;
			CHECK(height > -GROUND_TOLERANCE);
			CHECK(height <= 1.0f);
		}
	}
}

TEST_CASE("trodden stems have the same bits at every SIMD level") {
	std::vector<MotionPlant> plants;
	for (int i = 0; i < 300; i++) {
		plants.push_back(chance_plant(i));
	}
	std::vector<glm::vec2> first;
	for (const SimdLevel level : { SimdLevel::baseline, best_simd_level() }) {
		MotionPage page(0, trodden_species(0.5f, true), plants.data(), 300, FIELD_STEP, true);
		for (int i = 0; i < 300; i += 7) {
			page.set_lasting_bend(i, { 0.3f * signed_noise(1, static_cast<uint64_t>(i)), 0.5f });
		}
		std::vector<glm::vec2> places;
		for (int n = 0; n < 50; n++) {
			const FieldWind wind = wave_wind();
			page.step(wind_at_time(wind, static_cast<double>(n) / 60.0), winds_along(wind), level);
		}
		for (int i = 0; i < 300; i++) {
			places.push_back(page.stem(i).place[0]);
		}
		CHECK((first.empty() || first == places));
		first = places;
	}
}

TEST_CASE("a wind that bends a stem beyond its yield lodges it by the rest, and a weaker one does not") {
	MotionSpecies species = trodden_species(0.0f);
	species.trampling.recovery = 1e6f;
	const auto blown = [&](float yield) {
		species.trampling.yield = yield;
		FieldSimulation field = calm_field(species, { MotionPlant() });
		field.set_wind({ { WindKind::constant, 0.4f }, 0.0f });
		run(field, 20.0);
		return field;
	};
	const float elastic = glm::length(tip_of(blown(0.0f)));
	CHECK(elastic > 0.2f);
	CHECK(blown(0.0f).lasting_bend(0, 0) == glm::vec2(0.0f));
	CHECK(blown(2.0f * elastic).lasting_bend(0, 0) == glm::vec2(0.0f)); // It overshoots at first.
	const float yield = 0.5f * elastic;
	FieldSimulation field = blown(yield);
	const glm::vec2 lodged = field.lasting_bend(0, 0);
	CHECK(glm::length(lodged) > 0.4f * elastic);
	CHECK(glm::length(tip_of(field) - lodged) < yield + BEND_TOLERANCE);
	field.set_wind({ { WindKind::constant, 0.0f }, 0.0f });
	run(field, 20.0);
	CHECK(glm::length(tip_of(field) - lodged) < BEND_TOLERANCE);
}
