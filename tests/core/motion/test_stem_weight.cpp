#include "../field/field_fixture.hpp"
#include "../figures.hpp"
#include "../stem/steady_chain.hpp"
#include "../stem/stems.hpp"
#include "stem_plants.hpp"
#include "swing.hpp"

#include "stem/loaded_stem.hpp"
#include "stem/stem_shape.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace undergrowth;

namespace {

// Of the length, between a tip and a chain of links.
constexpr double TIP_TOLERANCE = 0.01;
constexpr double MAX_LOAD_TOLERANCE = 0.05; // Under 2.4 kg/m² on a lean of 0.6, where tips come near to level.
constexpr double PERIOD_TOLERANCE = 0.02; // Relative.
constexpr float BEND_TOLERANCE = 1e-3f;

/// A stem with leaves all along and some drag on its head.
StemBeam leafy_stem(double head) {
	StemBeam beam = stem_of(0.3, 0.0, 2.0);
	beam.leaf_mass = 0.002f;
	beam.leaf_drag_area = 0.004f;
	beam.head_mass = static_cast<float>(head) * beam.leaf_mass;
	beam.head_drag_area = static_cast<float>(head) * beam.leaf_drag_area;
	beam.nods = true;
	return beam;
}

FieldSimulation still_field(const StemConstants &stem, const std::vector<MotionPlant> &plants,
		const Precipitation &precipitation, float step = FIELD_STEP) {
	FieldSettings settings;
	settings.step = step;
	FieldSimulation field(settings);
	MotionSpecies species = species_of(Law::stem);
	species.stem = stem;
	species.joint.above_ground = false;
	field.add_page(field.add_species(species), plants.data(), static_cast<int>(plants.size()));
	FieldWind wind;
	wind.wind = { WindKind::constant, 0.0f };
	wind.precipitation = precipitation;
	field.set_wind(wind);
	return field;
}

void rain(FieldSimulation &field, const Precipitation &precipitation) {
	FieldWind wind = field.wind();
	wind.precipitation = precipitation;
	field.set_wind(wind);
}

void run(FieldSimulation &field, double seconds) {
	const auto count = static_cast<int>(std::lround(seconds / static_cast<double>(field.settings().step)));
	for (int i = 0; i < count; i++) {
		field.step();
	}
}

MotionPlant leaning(float length, double lean) {
	MotionPlant plant;
	plant.length = length;
	plant.rest = { static_cast<float>(std::sin(lean)), static_cast<float>(std::cos(lean)), 0.0f };
	return plant;
}

/// rad from upright, of a plant's tip towards x.
double lean_of(const FieldSimulation &field, int index = 0) {
	const glm::vec3 tip = field.page(0).direction(index);
	return std::atan2(static_cast<double>(tip.x), static_cast<double>(tip.y));
}

} // namespace

TEST_CASE("water and snow bend leaning stems as they bend a chain of links") {
	for (const double head : { 0.0, 1.0 }) {
		const StemBeam beam = leafy_stem(head);
		const StemSolution solution = solve_stem(beam);
		double worst[2] = {}; // Under the greatest load, and under the others.
		for (const double lean : { 0.1, 0.3, 0.6 }) {
			for (const Precipitation load : { Precipitation{ 1.0f, 0.0f }, { 0.0f, 0.5f }, { 1.0f, 1.0f } }) {
				FieldSimulation field = still_field(solution.constants, { leaning(beam.length, lean) }, load);
				run(field, 20.0);
				SteadyChain chain(beam, solution.youngs_modulus);
				chain.lean(lean, true);
				const double mass =
						static_cast<double>(WATER_PER_DRAG_AREA * load.wetness + SNOW_PER_DRAG_AREA * load.snow);
				for (const double share : { 0.25, 0.5, 0.75, 1.0 }) {
					chain.settle_load(share * mass, lean);
				}
				const glm::dvec2 at_rest = chain.place(1.0);
				const glm::dvec2 expected(at_rest.x * std::cos(lean) + at_rest.y * std::sin(lean),
						at_rest.y * std::cos(lean) - at_rest.x * std::sin(lean));
				const glm::vec3 arm = field.page(0).arm(0, 1.0f) / beam.length;
				const double error = glm::length(glm::dvec2(arm.x, arm.y) - expected);
				double &so_far = worst[mass > 2.0 ? 0 : 1];
				so_far = std::max(so_far, error);
			}
		}
		CHECK(worst[0] < MAX_LOAD_TOLERANCE);
		CHECK(worst[1] < TIP_TOLERANCE);
		figures::record_error(figures::STEMS, "tip of a leaning stem under all water and snow, of its length",
				MAX_LOAD_TOLERANCE, worst[0]);
		figures::record_error(figures::STEMS, "tip of a leaning stem under water or half the snow, of its length",
				TIP_TOLERANCE, worst[1]);
	}
}

TEST_CASE("a wet stem swings as slowly as one whose leaves have the mass of the water") {
	StemBeam beam = leafy_stem(0.0);
	beam.taper = 0.0f;
	const StemSolution dry = solve_stem(beam);
	StemBeam heavy = beam;
	heavy.leaf_mass += WATER_PER_DRAG_AREA * dry.constants.drag_area;
	heavy.natural_frequency = 0.0f;
	heavy.youngs_modulus = static_cast<float>(dry.youngs_modulus);
	const double expected = solve_stem(heavy).frequencies[0] / (2.0 * PI);
	StemConstants stem = dry.constants;
	stem.mode[0].damping = 0.0f;
	FieldSimulation field = still_field(stem, { leaning(beam.length, 0.0) }, { 1.0f, 0.0f });
	field.step();
	StemState pushed;
	pushed.place[0].x = 0.02f;
	field.page(0).set_stem(0, pushed);
	int crossings = 0;
	int first = 0;
	int last = 0;
	float before = 0.02f;
	for (int i = 0; i < 1200; i++) {
		field.step();
		const float now = field.page(0).stem(0).place[0].x;
		if (before < 0.0f && now >= 0.0f) {
			first = crossings++ == 0 ? i : first;
			last = i;
		}
		before = now;
	}
	const double measured = (crossings - 1) / (static_cast<double>(last - first) * static_cast<double>(FIELD_STEP));
	figures::record(figures::SWINGS, "wet stem that has 2 Hz when dry", expected, measured, 2, " Hz");
	CHECK(measured == doctest::Approx(expected).epsilon(PERIOD_TOLERANCE));
}

TEST_CASE("stems of a wet meadow bend in all directions, and straight ones stay upright") {
	const StemConstants stem = solve_stem(leafy_stem(0.5)).constants;
	std::vector<MotionPlant> plants(1, leaning(0.6f, 0.0));
	for (int i = 0; i < 400; i++) {
		plants.push_back(leaning(0.6f, 0.0));
		plants.back().root = { 0.31f * static_cast<float>(i % 20) - 3.0f, 0.0f,
			0.29f * static_cast<float>(i / 20) - 3.0f };
	}
	FieldSimulation field = still_field(stem, plants, { 0.0f, 1.0f });
	run(field, 2.0);
	CHECK(lean_of(field, 0) == doctest::Approx(0.0));
	glm::vec2 sum(0.0f);
	float bent = 0.0f;
	for (int i = 1; i <= 400; i++) {
		const glm::vec3 tip = field.page(0).direction(i);
		sum += glm::vec2(tip.x, tip.z) / 400.0f;
		bent += glm::length(glm::vec2(tip.x, tip.z)) / 400.0f;
	}
	CHECK(bent > 0.03f);
	CHECK(bent < 0.2f);
	CHECK(glm::length(sum) < 0.2f * bent);
}

TEST_CASE("leaning stems rise when they dry") {
	const StemConstants stem = solve_stem(leafy_stem(0.5)).constants;
	FieldSimulation field = still_field(stem, { leaning(0.6f, 0.0), leaning(0.6f, 0.3) }, {});
	run(field, 1.0);
	const double dry = lean_of(field, 1);
	rain(field, { 1.0f, 0.0f });
	run(field, 20.0);
	CHECK(lean_of(field, 0) == doctest::Approx(0.0));
	CHECK(lean_of(field, 1) > dry + 0.01);
	rain(field, {});
	run(field, 20.0);
	CHECK(lean_of(field, 1) == doctest::Approx(dry).epsilon(BEND_TOLERANCE));
}

TEST_CASE("more snow bends stems further, and less wind is needed to bend them") {
	const StemConstants stem = in_air(solve_stem(leafy_stem(0.5)).constants);
	double before = 0.3;
	for (const float snow : { 0.1f, 0.3f, 0.6f, 1.0f }) {
		FieldSimulation field = still_field(stem, { leaning(0.6f, 0.3) }, { 0.0f, snow });
		run(field, 20.0);
		CHECK(lean_of(field) > before + 0.01);
		before = lean_of(field);
	}
	const auto in_wind = [&](float snow) {
		FieldSimulation field = still_field(stem, { leaning(0.6f, 0.0) }, { 0.0f, snow });
		FieldWind wind = field.wind();
		wind.wind.kind = WindKind::air;
		wind.wind.direction = static_cast<float>(0.5 * PI);
		wind.air.speed = 3.0f;
		wind.air.turbulence = -1.0f;
		field.set_wind(wind);
		run(field, 20.0);
		return lean_of(field);
	};
	CHECK(in_wind(0.2f) > 1.2 * in_wind(0.0f));
}

TEST_CASE("plants that come while it rains have the bend of their water at once") {
	const StemConstants stem = solve_stem(leafy_stem(0.5)).constants;
	FieldSimulation field = still_field(stem, { leaning(0.6f, 0.3) }, { 1.0f, 0.0f });
	field.step();
	const double at_once = lean_of(field);
	run(field, 20.0);
	CHECK(at_once == doctest::Approx(lean_of(field)).epsilon(BEND_TOLERANCE));
	const MotionPlant later = leaning(0.6f, 0.3);
	REQUIRE(field.add_to_page(0, &later, 1));
	CHECK(lean_of(field, 1) == doctest::Approx(lean_of(field)).epsilon(BEND_TOLERANCE));
	CHECK(field.shown_direction(0, 1, 0.0f).x ==
			doctest::Approx(field.shown_direction(0, 0, 0.0f).x).epsilon(BEND_TOLERANCE));
	field.settle();
	CHECK(lean_of(field) == doctest::Approx(at_once).epsilon(BEND_TOLERANCE));
}

TEST_CASE("steps of any length bring loaded stems to the same rest") {
	for (const float drag_area : { 0.004f, 0.3f }) { // The second one hangs down.
		StemBeam beam = leafy_stem(1.0);
		beam.modes = 2;
		beam.leaf_drag_area = drag_area;
		const StemConstants stem = solve_stem(beam).constants;
		for (const Precipitation load : { Precipitation{ 1.0f, 0.0f, 0.0f }, { 0.0f, 1.0f, 0.0f } }) {
			double expected = 0.0;
			for (const float step : { 1.0f / 144.0f, 1.0f / 60.0f, 1.0f / 20.0f, 0.25f, 1.0f }) {
				FieldSimulation field = still_field(stem, { leaning(0.6f, 0.3) }, {}, step);
				run(field, 2.0);
				rain(field, load);
				run(field, 200.0);
				expected = expected == 0.0 ? lean_of(field) : expected;
				CHECK(lean_of(field) == doctest::Approx(expected).epsilon(BEND_TOLERANCE));
				const double before = lean_of(field);
				field.step();
				CHECK(lean_of(field) == doctest::Approx(before).epsilon(BEND_TOLERANCE));
			}
		}
	}
}

TEST_CASE("stems with own frequencies and the rest of their species bend under water alike") {
	StemBeam beam = leafy_stem(0.5);
	FieldSimulation alike = still_field(solve_stem(beam).constants, { leaning(0.6f, 0.3) }, { 1.0f, 0.0f });
	beam.frequency_by_length = true;
	const StemConstants graded = solve_stem(beam).constants;
	REQUIRE(graded.has_grades());
	FieldSimulation own = still_field(graded, { leaning(0.6f, 0.3), leaning(0.75f, 0.3) }, { 1.0f, 0.0f });
	run(alike, 20.0);
	run(own, 20.0);
	CHECK(lean_of(own, 0) == doctest::Approx(lean_of(alike)).epsilon(BEND_TOLERANCE));
	CHECK(lean_of(own, 1) > lean_of(own, 0) + 0.005); // Longer stems of the same diameter are softer.
}

TEST_CASE("numbers of water and snow are clamped and rounded") {
	CHECK(rounded({ 2.0f, -1.0f }) == Precipitation{ 1.0f, 0.0f });
	CHECK(rounded({ std::nanf(""), 0.5f }) == Precipitation{ 0.0f, 0.5f });
	CHECK(rounded({ 0.5f, 0.501f }) == Precipitation{ 0.5f, 0.5f });
}

TEST_CASE("loaded stems have the same bits at each level and for each division into pages") {
	StemBeam beam = leafy_stem(0.5);
	beam.modes = 2;
	beam.frequency_by_length = true;
	MotionSpecies species = species_of(Law::stem);
	species.stem = solve_stem(beam).constants;
	std::vector<MotionPlant> plants;
	for (int i = 0; i < 700; i++) {
		plants.push_back(chance_plant(i));
		plants.back().length *= 0.6f;
	}
	FieldWind wind = wave_wind();
	wind.wind.strength = 0.02f;
	wind.precipitation = { 1.0f, 0.3f, 0.0f };
	const PlantWinds along = winds_along(wind);
	const auto hash_of = [&](int first, int count, SimdLevel level) {
		MotionPage page(0, species, plants.data() + first, count, FIELD_STEP, true);
		GoldenHash hash;
		for (int n = 0; n < 60; n++) {
			page.step(wind_at_time(wind, along, n * static_cast<double>(FIELD_STEP)), along, level);
		}
		for (int i = first == 0 ? 100 : 0; i < count; i++) {
			const StemState state = page.stem(i);
			hash.add(&state, 1);
		}
		return hash.value();
	};
	const uint64_t whole = hash_of(0, 700, SimdLevel::baseline);
	CHECK(hash_of(0, 700, best_simd_level()) == whole);
	CHECK(hash_of(100, 600, best_simd_level()) == whole);
}

TEST_CASE("plants begin with the bend of their own weight, taller ones with their own") {
	StemBeam beam = leafy_stem(0.5);
	beam.natural_frequency = 0.0f;
	beam.youngs_modulus = static_cast<float>(solve_stem(leafy_stem(0.5)).youngs_modulus);
	const StemConstants stem = solve_stem(beam).constants;
	FieldSimulation field = still_field(stem, { leaning(0.6f, 0.3), leaning(0.48f, 0.3), leaning(0.6f, 0.0) }, {});
	const double calm[3] = { lean_of(field, 0), lean_of(field, 1), lean_of(field, 2) };
	CHECK(calm[0] > 0.33);
	CHECK(calm[1] > 0.31);
	CHECK(calm[1] < 0.3 + 0.7 * (calm[0] - 0.3));
	CHECK(calm[2] == doctest::Approx(0.0));
	run(field, 20.0);
	for (int i = 0; i < 3; i++) {
		CHECK(lean_of(field, i) == doctest::Approx(calm[i]).epsilon(BEND_TOLERANCE));
	}
	field.settle();
	CHECK(lean_of(field, 0) == doctest::Approx(calm[0]).epsilon(BEND_TOLERANCE));
}

TEST_CASE("a page of another species: plants at rest get the bend of its weight, others keep theirs") {
	MotionSpecies heavy = species_of(Law::stem);
	heavy.stem = solve_stem(leafy_stem(0.5)).constants;
	MotionSpecies rigid = heavy;
	StemBeam straight = leafy_stem(0.5);
	straight.nods = false;
	rigid.stem = solve_stem(straight).constants;
	const MotionPlant plants[2] = { leaning(0.6f, 0.3), leaning(0.6f, 0.3) };
	MotionPage page(0, heavy, plants, 2, FIELD_STEP, true, MotionPage::Keeps::directions);
	const auto bend_of = [&](int row) {
		return std::acos(std::min(glm::dot(page.rest(row), page.state(row).direction), 1.0f));
	};
	const float nod = bend_of(0);
	CHECK(nod > 0.02f);
	CHECK(page.is_at_rest(0));
	page.apply_impulse(1, { 0.001f, 0.0f, 0.0f });
	CHECK_FALSE(page.is_at_rest(1));
	page.set_species(rigid);
	CHECK(bend_of(0) == doctest::Approx(0.0f).epsilon(BEND_TOLERANCE));
	CHECK(page.is_at_rest(0));
	CHECK(bend_of(1) == doctest::Approx(nod).epsilon(BEND_TOLERANCE));
	page.set_species(heavy);
	CHECK(bend_of(0) == doctest::Approx(nod).epsilon(BEND_TOLERANCE));
}

TEST_CASE("followers of prototypes nod like them") {
	FieldSettings settings;
	settings.prototypes = 8;
	FieldSimulation field(settings);
	MotionSpecies species = species_of(Law::stem);
	species.stem = solve_stem(leafy_stem(0.5)).constants;
	species.lean = 0.3f;
	const MotionPlant plant = leaning(0.6f, 0.3);
	field.add_page(field.add_species(species), &plant, 1);
	FieldWind still;
	still.wind = { WindKind::constant, 0.0f };
	field.set_wind(still);
	const auto lean_of_chord = [&] {
		const glm::vec3 tip = field.shown_point(0, 0, 1.0f, 1.0f);
		return std::atan2(glm::length(glm::vec2(tip.x, tip.z)), tip.y);
	};
	const float calm = lean_of_chord();
	CHECK(calm > 0.31f);
	run(field, 10.0);
	CHECK(lean_of_chord() == doctest::Approx(calm).epsilon(BEND_TOLERANCE));
	StemBeam straight = leafy_stem(0.5);
	straight.nods = false;
	const StemConstants nodding = species.stem;
	species.stem = solve_stem(straight).constants;
	field.set_species(0, species);
	CHECK(lean_of_chord() == doctest::Approx(0.3).epsilon(BEND_TOLERANCE));
	species.stem = nodding;
	species.lean = 0.2f;
	field.set_species(0, species);
	species.lean = 0.3f;
	field.set_species(0, species);
	CHECK(lean_of_chord() == doctest::Approx(calm).epsilon(BEND_TOLERANCE));
}
