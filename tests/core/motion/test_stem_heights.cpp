#include "../stem/stems.hpp"
#include "motion/motion_page.hpp"
#include "wind/field_wind.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <cmath>
#include <vector>

using namespace undergrowth;

namespace {

constexpr float STEP = 1.0f / 60.0f; // s.
constexpr double WITHIN = 0.01; // Of the values of a stem solved for the height.
constexpr double ROUNDED = 0.004; // Of frequencies.
constexpr double BY_PARABOLA = 0.05; // The same for bends between the solved heights.

StemBeam straw(double head) {
	StemBeam beam = stem_of(0.4, head, 0.0);
	beam.youngs_modulus = 4e9f;
	beam.head_drag_area = 0.001f;
	return beam;
}

StemConstants solved_at(const StemBeam &beam, float ratio) {
	StemBeam other = beam;
	other.length *= ratio;
	return solve_stem(other).constants;
}

MotionSpecies in_canopy(const StemBeam &beam) {
	MotionSpecies species;
	species.law = Law::stem;
	species.stem = solve_stem(beam).constants;
	species.canopy_height = beam.length;
	return species;
}

MotionPage page_of(const StemBeam &beam, const std::vector<float> &ratios, float step = STEP) {
	MotionSpecies species;
	species.law = Law::stem;
	species.stem = solve_stem(beam).constants;
	std::vector<MotionPlant> plants(ratios.size());
	for (std::size_t i = 0; i < ratios.size(); i++) {
		plants[i].length = ratios[i] * beam.length;
	}
	return MotionPage(0, species, plants.data(), static_cast<int>(plants.size()), step, true);
}

void apply_wind(MotionPage &page, const FieldWind &wind, int steps, SimdLevel level = best_simd_level()) {
	for (int i = 0; i < steps; i++) {
		page.step(wind_at_time(wind, i * static_cast<double>(page.step_length())), winds_along(wind), level);
	}
}

FieldWind still() {
	FieldWind wind;
	wind.wind.strength = 0.0f;
	return wind;
}

/// rad/s: from the time of whole swings of a released tip.
double frequency_of(MotionPage &page, int index) {
	page.set_state(index, { glm::normalize(glm::vec3(0.02f, 1.0f, 0.0f)), {} });
	double first = 0.0, last = 0.0;
	int falls = 0;
	float before = page.direction(index).x;
	for (int i = 1; i < 1200; i++) {
		apply_wind(page, still(), 1);
		const float now = page.direction(index).x;
		if (before > 0.0f && now <= 0.0f) {
			last = (i - static_cast<double>(now / (now - before))) * static_cast<double>(page.step_length());
			first = falls == 0 ? last : first;
			falls++;
		}
		before = now;
	}
	return 2.0 * PI * (falls - 1) / (last - first);
}

} // namespace

TEST_CASE("stems with a given stiffness swing by their own height") {
	const std::vector<float> ratios = { 0.7f, 0.85f, 1.0f, 1.15f, 1.3f };
	for (const double head : { 0.0, 0.5 }) {
		StemBeam beam = straw(head);
		beam.damping_ratio = 0.01f;
		MotionPage page = page_of(beam, ratios);
		for (int i = 0; i < page.size(); i++) {
			CAPTURE(head);
			CAPTURE(ratios[i]);
			const double expected = static_cast<double>(solved_at(beam, ratios[i]).mode[0].frequency);
			CHECK(frequency_of(page, i) == doctest::Approx(expected).epsilon(WITHIN));
		}
	}
}

TEST_CASE("stems with a given stiffness bend by their own height in both winds") {
	const std::vector<float> ratios = { 0.7f, 1.0f, 1.3f };
	const StemBeam beam = straw(0.5);
	for (const WindKind kind : { WindKind::constant, WindKind::air }) {
		FieldWind wind;
		wind.wind.kind = kind;
		wind.wind.strength = 0.3f / solve_stem(beam).constants.dead_slope;
		wind.air.speed = 6.0f;
		MotionPage page = page_of(beam, ratios);
		apply_wind(page, wind, 3000);
		for (int i = 0; i < page.size(); i++) {
			CAPTURE(ratios[i]);
			StemBeam own = beam;
			own.length *= ratios[i];
			MotionPage alone = page_of(own, { 1.0f });
			apply_wind(alone, wind, 3000);
			const glm::vec3 is = page.direction(i);
			const glm::vec3 expected = alone.direction(0);
			const auto slope = [](const glm::vec3 &tip) { return glm::length(glm::vec2(tip.x, tip.z)) / tip.y; };
			CHECK(slope(expected) > 0.01f);
			CHECK(slope(is) == doctest::Approx(slope(expected)).epsilon(WITHIN));
		}
	}
}

TEST_CASE("stems with a given stiffness have the same frequency at other steps, and when plants are added or removed") {
	StemBeam beam = straw(0.0);
	beam.youngs_modulus = 1e9f;
	MotionPage page = page_of(beam, { 1.0f, 1.3f });
	MotionPlant low;
	low.length = 0.7f * beam.length;
	page.add(&low, 1);
	page.remove(0); // The low one gets its row.
	page.set_step_length(2.0f * STEP);
	for (const int index : { 0, 1 }) {
		const float ratio = index == 0 ? 0.7f : 1.3f;
		CAPTURE(ratio);
		const double expected = static_cast<double>(solved_at(beam, ratio).mode[0].frequency);
		CHECK(frequency_of(page, index) == doctest::Approx(expected).epsilon(WITHIN));
	}
}

TEST_CASE("a declared frequency by length is that of stems of this length, with one stiffness for all") {
	StemBeam beam = stem_of(0.4, 0.5, 2.5);
	beam.damping_ratio = 0.01f;
	beam.frequency_by_length = true;
	StemBeam stiff = beam;
	stiff.natural_frequency = 0.0f;
	stiff.youngs_modulus = static_cast<float>(solve_stem(beam).youngs_modulus);
	const std::vector<float> ratios = { 0.8f, 1.0f, 1.2f };
	MotionPage page = page_of(beam, ratios);
	CHECK(frequency_of(page, 1) == doctest::Approx(2.0 * PI * 2.5).epsilon(WITHIN));
	for (const int index : { 0, 2 }) {
		const float ratio = ratios[static_cast<std::size_t>(index)];
		CAPTURE(ratio);
		const double expected = static_cast<double>(solved_at(stiff, ratio).mode[0].frequency);
		CHECK(frequency_of(page, index) == doctest::Approx(expected).epsilon(WITHIN));
	}
}

TEST_CASE("a scaled plant swings slower by its scale, bends less by a force, and as far in the air") {
	StemBeam beam = stem_of(0.4, 0.5, 1.2);
	beam.frequency_by_length = true;
	beam.head_drag_area = 0.001f;
	constexpr float SCALE = 1.3f;
	MotionPlant usual, scaled;
	usual.length = beam.length;
	scaled.length = SCALE * beam.length;
	scaled.scale = SCALE;
	MotionPage page = page_of(beam, {});
	page.set_species(in_canopy(beam)); // All plants have the wind of its top.
	page.add(&usual, 1);
	page.add(&scaled, 1);
	CHECK(frequency_of(page, 1) ==
			doctest::Approx(frequency_of(page, 0) / static_cast<double>(SCALE)).epsilon(ROUNDED).scale(0.0));
	const auto slope = [&page](int index) { return page.direction(index).x / page.direction(index).y; };
	for (const WindKind kind : { WindKind::constant, WindKind::air }) {
		FieldWind wind;
		wind.wind.kind = kind;
		wind.wind.direction = static_cast<float>(0.5 * PI);
		wind.wind.strength = 0.02f / solve_stem(beam).constants.dead_slope;
		wind.air.speed = 1.5f;
		page.settle();
		apply_wind(page, wind, 6000);
		const float expected = kind == WindKind::air ? 1.0f : 1.0f / (SCALE * SCALE);
		CAPTURE(slope(0));
		CHECK(std::fabs(slope(0)) > 1e-3f);
		CHECK(slope(1) == doctest::Approx(expected * slope(0)).epsilon(0.02).scale(0.0));
	}
}

TEST_CASE("own frequencies spread by their deviation, and follow a plant when rows change") {
	StemBeam beam = stem_of(0.4, 0.5, 1.2);
	beam.damping_ratio = 0.01f;
	beam.frequency_deviation = 0.1f;
	std::vector<MotionPlant> plants(3);
	for (std::size_t i = 0; i < plants.size(); i++) {
		plants[i].length = 0.4f + 0.1f * static_cast<float>(i); // No effect without frequency_by_length.
		plants[i].own = static_cast<float>(i) - 1.0f;
	}
	MotionPage page = page_of(beam, {});
	page.add(plants.data(), 3);
	const double edge = std::sqrt(3.0) * 0.1;
	const auto is_at = [&page](int index, double factor) {
		CHECK(frequency_of(page, index) == doctest::Approx(2.0 * PI * 1.2 * factor).epsilon(WITHIN).scale(0.0));
	};
	is_at(0, 1.0 - edge);
	is_at(1, 1.0);
	is_at(2, 1.0 + edge);
	page.remove(0); // The last one gets its row.
	page.set_step_length(0.5f * STEP);
	is_at(0, 1.0 + edge);
	plants[1].own = -1.0f;
	page.set_plant(1, plants[1]);
	is_at(1, 1.0 - edge);
	plants[0].own = 0.5f;
	page.set_owns(1, plants.data(), 1);
	is_at(1, 1.0 + 0.5 * edge);
}

TEST_CASE("own places of roots are uniform and independent of neighbours") {
	double sum = 0.0, square = 0.0, product = 0.0, before = 0.0;
	constexpr int COUNT = 10000;
	for (int i = 0; i < COUNT; i++) {
		const glm::vec3 root(0.13f * static_cast<float>(i % 100), 5.0f, 0.17f * static_cast<float>(i / 100));
		const double own = static_cast<double>(own_of_root(root));
		CHECK(std::fabs(own) <= 1.0);
		sum += own / COUNT;
		square += own * own / COUNT;
		product += own * before / COUNT;
		before = own;
	}
	CHECK(std::fabs(sum) < 0.03);
	CHECK(square == doctest::Approx(1.0 / 3.0).epsilon(0.03).scale(0.0));
	CHECK(std::fabs(product) < 0.02);
}

TEST_CASE("heights have no effect with a declared frequency") {
	const StemBeam beam = stem_of(0.4, 0.5, 1.2);
	CHECK(!solve_stem(beam).constants.has_grades());
	MotionPage page = page_of(beam, { 0.7f, 1.3f });
	CHECK(frequency_of(page, 0) == doctest::Approx(frequency_of(page, 1)).epsilon(1e-4));
}

TEST_CASE("stems of any height stay finite and calm down") {
	StemBeam beam = straw(2.0);
	beam.youngs_modulus = 3e8f; // It is close to buckling.
	beam.modes = 2;
	MotionPage page = page_of(beam, { 0.01f, 0.3f, 1.0f, 1.3f, 2.0f, 50.0f }, 1.0f / 15.0f);
	FieldWind wind;
	wind.wind.strength = 1e6f;
	apply_wind(page, wind, 300);
	apply_wind(page, still(), 6000);
	for (int i = 0; i < page.size(); i++) {
		CAPTURE(i);
		CHECK(page.direction(i).y > 0.999f);
	}
}

TEST_CASE("loads on a stem of another height bend it like a stem solved for that height") {
	StemBeam beam = straw(0.0);
	beam.head_drag_area = 0.0f; // The area that meets the air grows with the height; a force in newtons does not.
	const StemConstants own = solve_stem(beam).constants;
	for (const float ratio : { 0.7f, 0.85f, 1.15f, 1.3f }) {
		CAPTURE(ratio);
		const StemConstants other = solved_at(beam, ratio);
		const float dead = other.dead_slope / own.dead_slope;
		const float air = other.air_slope / own.air_slope;
		CHECK(own.dead_grade.at(ratio) == doctest::Approx(dead).epsilon(BY_PARABOLA));
		CHECK(own.air_grade.at(ratio) == doctest::Approx(air).epsilon(BY_PARABOLA));
	}
}

TEST_CASE("graded stems have the same bits at every level of SIMD") {
	StemBeam beam = straw(0.5);
	beam.modes = 2;
	std::vector<float> ratios;
	for (int i = 0; i < 37; i++) {
		ratios.push_back(0.7f + 0.017f * static_cast<float>(i));
	}
	MotionPage one = page_of(beam, ratios);
	MotionPage other = page_of(beam, ratios);
	FieldWind wind;
	wind.wind.kind = WindKind::waves;
	wind.wind.strength = 0.1f;
	wind.wind.direction = 0.7f;
	apply_wind(one, wind, 200, SimdLevel::baseline);
	apply_wind(other, wind, 200);
	for (int i = 0; i < one.size(); i++) {
		CHECK(one.direction(i) == other.direction(i));
	}
}
