#include "field_fixture.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

using namespace undergrowth;

namespace {

constexpr Law BOTH_LAWS[] = { Law::elasticity, Law::spring };
/// For directions at interval 4 compared with interval 1, under waves of 0.5 Hz on plants of about 1 Hz: the wind is
/// constant for 1/15 s instead of 1/60 s.
constexpr float INTERVAL_TOLERANCE = 0.01f;
/// While they still swing from the start. The rate is that of the middle of a step, so a start from rest differs
/// between steps of different lengths.
constexpr float START_TOLERANCE = 0.04f;
constexpr int SETTLED = 900; // Steps.
constexpr float BEND_TOLERANCE = 1.1e-3f;
constexpr double MAX_BYTES = 96.0;

bool is_whole(const TipState &state) {
	return std::isfinite(glm::dot(state.direction, state.rate)) &&
			std::fabs(glm::length(state.direction) - 1.0f) < 1e-5f;
}

} // namespace

TEST_CASE("a plant of a field moves like the same plant with a skeleton, to the bit") {
	for (const Law law : BOTH_LAWS) {
		MotionPlant plant = chance_plant(3);
		FieldSimulation field = single_plant(law, plant);
		const FieldWind wind = wave_wind();
		field.set_wind(wind);
		MotionPage page(0, species_of(law), &plant, 1, FIELD_STEP, true, MotionPage::Keeps::directions);
		for (int i = 0; i < 600; i++) {
			field.step();
			const double moment = (i + page.wind_moment()) * static_cast<double>(FIELD_STEP);
			page.step(wind_at_time(wind, moment), winds_along(wind));
			REQUIRE(field.state(0, 0).direction == page.state(0).direction);
		}
	}
}

TEST_CASE("bends match the states before and after the last step") {
	for (const Law law : BOTH_LAWS) {
		FieldSimulation field((FieldSettings()));
		add_plants(field, field.add_species(species_of(law)), 700);
		field.set_wind(wave_wind());
		for (int i = 0; i < 40; i++) {
			std::vector<glm::vec3> before;
			for (int k = 0; k < 700; k++) {
				before.push_back(field.state(0, k).direction);
			}
			field.step();
			for (int k = 0; k < 700; k++) {
				const Bend *pair = field.page(0).bends() + 2 * k;
				REQUIRE(glm::distance(decode_bend(pair[0]), before[static_cast<size_t>(k)]) < BEND_TOLERANCE);
				REQUIRE(glm::distance(decode_bend(pair[1]), field.state(0, k).direction) < BEND_TOLERANCE);
			}
		}
	}
}

TEST_CASE("pages stepped in any order and split give the same bits") {
	FieldSettings settings;
	settings.update_interval = 2;
	FieldSimulation whole = mixed_field(settings, 1500);
	FieldSimulation split = mixed_field(settings, 1500);
	for (int i = 0; i < 120; i++) {
		whole.step();
		split.begin_step();
		const int cut = i % (split.page_count() + 1);
		split.step_pages(cut, 99);
		split.step_pages(-3, cut);
	}
	CHECK(hash_field(whole) == hash_field(split));
}

TEST_CASE("a field's motion has the same bits on every platform") {
	constexpr uint64_t GOLDEN = 0x65e2e829376ea73aull;
	FieldSimulation field = mixed_field({}, 300);
	for (int i = 0; i < 300; i++) {
		field.step();
	}
	CHECK(hash_field(field) == GOLDEN);
}

TEST_CASE("at interval 4 a plant moves as at the full rate, within the tolerance") {
	FieldSettings slow;
	slow.update_interval = 4;
	FieldSimulation full = mixed_field({}, 400);
	FieldSimulation reduced = mixed_field(slow, 400);
	for (int i = 0; i < 1200; i++) {
		full.step();
		reduced.step();
		for (int page = 0; page < full.page_count(); page++) {
			// A page that steps at n shows the state of n + 4 when the full rate reaches it, at n + 3. Pages with a
			// later turn start later; by SETTLED damping has removed that.
			if (reduced.alpha(page, 1.0f) != 1.0f || (i < SETTLED && page % 4 != 0)) {
				continue;
			}
			for (int k = 0; k < full.page(page).size(); k += 7) {
				const float apart = glm::distance(full.state(page, k).direction, reduced.state(page, k).direction);
				REQUIRE(apart < (i < SETTLED ? START_TOLERANCE : INTERVAL_TOLERANCE));
			}
		}
	}
}

TEST_CASE("pages step in turns, never all in one step") {
	FieldSettings settings;
	settings.update_interval = 4;
	FieldSimulation field = mixed_field(settings, 1024);
	REQUIRE(field.page_count() == 8);
	for (int i = 0; i < 16; i++) {
		field.step();
		int stepped = 0;
		for (int page = 0; page < 8; page++) {
			stepped += field.has_stepped(page) ? 1 : 0;
		}
		CHECK(stepped == 2);
	}
}

TEST_CASE("alpha runs from one bend to the next over the page's interval") {
	FieldSettings settings;
	settings.update_interval = 2;
	FieldSimulation field = mixed_field(settings, 256);
	field.set_page_multiple(0, 2);
	CHECK(field.page_interval(0) == 4);
	CHECK(field.page_interval(1) == 2);
	for (int i = 0; i < 9; i++) {
		field.step();
	}
	CHECK(field.has_stepped(0));
	CHECK(field.alpha(0, 0.0f) == 0.0f);
	CHECK(field.alpha(0, 0.5f) == doctest::Approx(0.125));
	CHECK(field.alpha(1, 0.5f) == doctest::Approx(0.75));
	field.step();
	CHECK(field.alpha(0, 0.0f) == doctest::Approx(0.25));
}

TEST_CASE("a page with a newly shorter interval first shows its finished step") {
	FieldSettings settings;
	FieldSimulation field = mixed_field(settings, 256);
	field.set_page_multiple(0, 32);
	for (int i = 0; i < 33; i++) {
		field.step();
	}
	REQUIRE(field.has_stepped(0));
	field.set_page_multiple(0, 1);
	float before = 0.0f;
	for (int i = 1; i < 32; i++) {
		field.step();
		REQUIRE(!field.has_stepped(0));
		REQUIRE(field.alpha(0, 0.0f) == doctest::Approx(static_cast<float>(i) / 32.0f));
		REQUIRE(field.alpha(0, 0.0f) > before);
		before = field.alpha(0, 0.0f);
	}
	field.step();
	CHECK(field.has_stepped(0));
	field.step();
	CHECK(field.has_stepped(0));
}

TEST_CASE("an hour of wind causes no drift and no invalid number") {
	constexpr float SAME_PHASE_TOLERANCE = 2e-3f;
	for (const Law law : BOTH_LAWS) {
		FieldSettings settings;
		// A whole number of steps per period of the wind, so the same phase recurs exactly.
		settings.step = 1.0f / 64.0f;
		FieldSimulation field(settings);
		add_plants(field, field.add_species(species_of(law)), 16);
		field.set_wind(wave_wind());
		std::vector<glm::vec3> early;
		constexpr int HOUR = 3600 * 64;
		for (int i = 0; i <= HOUR; i++) {
			field.step();
			for (int k = 0; (i == 120 * 64 || i == HOUR) && k < 16; k++) {
				if (i == HOUR) {
					CHECK(glm::distance(early[static_cast<size_t>(k)], field.state(0, k).direction) <
							SAME_PHASE_TOLERANCE);
				} else {
					early.push_back(field.state(0, k).direction);
				}
			}
		}
	}
}

TEST_CASE("an impulse moves one plant of the field") {
	for (const Law law : BOTH_LAWS) {
		FieldSimulation field = single_plant(law, {});
		field.apply_impulse(0, 0, { 0.2f, 0.0f, 0.0f });
		CHECK(field.state(0, 0).rate.x == doctest::Approx(0.5));
	}
}

TEST_CASE("fields of 0, 1 and a million plants") {
	FieldSimulation empty((FieldSettings()));
	empty.step();
	CHECK(empty.plant_count() == 0);
	CHECK(empty.bytes_per_plant() == 0.0);
	CHECK(empty.add_page(empty.add_species({}), nullptr, 0) == 0);
	empty.step();

	FieldSimulation one = single_plant(Law::elasticity, {});
	one.step();
	CHECK(one.plant_count() == 1);

	FieldSimulation many((FieldSettings()));
	add_plants(many, many.add_species(species_of(Law::elasticity)), 1000000);
	many.set_wind(wave_wind());
	many.step();
	many.step();
	CHECK(many.plant_count() == 1000000);
	CHECK(is_whole(many.state(many.page_count() - 1, 3)));
	CHECK(many.bytes_per_plant() <= MAX_BYTES);
}

TEST_CASE("a field stays within its memory limit, also with prototypes") {
	for (const int prototypes : { 0, 64 }) {
		FieldSettings settings;
		settings.prototypes = prototypes;
		FieldSimulation field(settings);
		add_plants(field, field.add_species(species_of(Law::spring)), 100000);
		CHECK(field.bytes_per_plant() <= MAX_BYTES);
		const double before = field.bytes_per_plant();
		for (int i = 0; i < 10; i++) {
			field.step();
		}
		CHECK(field.bytes_per_plant() == before);
	}
}

TEST_CASE("plants with invalid numbers are rejected, and the field does not change") {
	FieldSimulation field((FieldSettings()));
	const int species = field.add_species({});
	const float bad[] = { std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity() };
	for (const float value : bad) {
		MotionPlant plants[3];
		plants[1].root.z = value;
		CHECK(field.add_page(species, plants, 3) == -1);
		plants[1] = {};
		plants[1].length = value;
		CHECK(field.add_page(species, plants, 3) == -1);
		plants[1] = {};
		plants[1].rest = { value, 1.0f, 0.0f };
		CHECK(field.add_page(species, plants, 3) == -1);
	}
	MotionPlant flat;
	flat.length = 0.0f;
	CHECK(field.add_page(species, &flat, 1) == -1);
	const MotionPlant good;
	CHECK(field.add_page(species + 1, &good, 1) == -1);
	CHECK(field.page_count() == 0);
}

TEST_CASE("no species, wind, impulse or step, however extreme, causes an invalid number") {
	constexpr float NONE = std::numeric_limits<float>::quiet_NaN();
	for (const Law law : BOTH_LAWS) {
		for (const float extreme : { NONE, 0.0f, -1.0f, 1e-30f, 1e30f }) {
			FieldSettings settings;
			settings.step = extreme;
			settings.step = settings.step < 1.0f ? settings.step : FIELD_STEP;
			settings.update_interval = -4;
			FieldSimulation field(settings);
			MotionSpecies species = species_of(law);
			species.joint.mass = extreme;
			species.joint.elasticity = extreme;
			species.joint.wind_weight = extreme;
			species.joint.natural_frequency = extreme;
			add_plants(field, field.add_species(species), 50);
			FieldWind wind = wave_wind();
			wind.wind.strength = extreme;
			field.set_wind(wind);
			field.apply_impulse(0, 3, { extreme, extreme, 0.0f });
			for (int i = 0; i < 300; i++) {
				field.step();
			}
			for (int i = 0; i < 50; i++) {
				REQUIRE(is_whole(field.state(0, i)));
			}
		}
	}
}
