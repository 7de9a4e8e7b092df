#include "../stem/stems.hpp"
#include "motion/motion_page.hpp"
#include "motion/part_bend.hpp"
#include "motion/stem_impulses.hpp"
#include "stem/stem_bones.hpp"
#include "stem/stem_ground.hpp"
#include "stem/stem_shape.hpp"
#include "stem_plants.hpp"
#include "swing.hpp"
#include "varied.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>

using namespace undergrowth;
using doctest::Approx;

namespace {

constexpr int PLANTS = 96;
/// Of the length: if a second mode is far off, its part of the motion is approximate. One mode alone does not reach the
/// ground.
constexpr float MAX_DEPTH_BELOW = 0.03f;

/// Stems that lean up to 45°, every third one upright.
StemPlants meadow(const StemConstants &stem) {
	StemPlants plants(stem, PLANTS, FRAME_STEP);
	for (int i = 0; i < PLANTS; i++) {
		if (i % 3 != 0) {
			plants.set_rest(i, { 0.29f * noise(i, 1), 0.29f * noise(i, 2) });
		}
	}
	return plants;
}

/// Relative to the length.
float tip_height(StemPlants &plants, int index) {
	const StemPage page = plants.page();
	const glm::vec2 amplitudes[] = { plants.place(index), plants.place(index, 1) };
	return turned(stem_place(plants.constants(), amplitudes, 1.0f).centre, { page.rest_x[index], page.rest_z[index] })
			.y;
}

float lowest_tip(StemPlants &plants) {
	float lowest = 1.0f;
	for (int i = 0; i < PLANTS; i++) {
		lowest = std::min(lowest, tip_height(plants, i));
	}
	return lowest;
}

void push_over(StemPlants &plants, float strength) {
	for (int i = 0; i < PLANTS; i++) {
		StemState state;
		const float impulse = strength * plants.constants().mode[0].mass * plants.constants().mode[0].frequency;
		apply_stem_impulse(plants.constants(), state, 1.0f,
				{ impulse * noise(i, 3), impulse * noise(i, 4), impulse * noise(i, 5) }, 1.0f);
		for (int k = 0; k < plants.constants().modes; k++) {
			plants.set_rate(i, state.rate[k], k);
		}
	}
}

} // namespace

TEST_CASE("no impulse moves the tip of a stem below the ground") {
	for (const int modes : { 1, 2 }) {
		for (const double taper : { 0.0, 0.5, 0.8 }) {
			for (const double head : { 0.0, 1.0 }) {
				StemPlants plants = meadow(jointed(4, taper, head, modes));
				float lowest = 1.0f;
				for (const float strength : { 3.0f, 30.0f, 1000.0f }) {
					push_over(plants, strength);
					for (int n = 0; n < 60; n++) {
						plants.step();
						lowest = std::min(lowest, lowest_tip(plants));
					}
				}
				CAPTURE(modes);
				CAPTURE(taper);
				CAPTURE(head);
				CHECK(lowest >= (modes == 1 ? 0.0f : -MAX_DEPTH_BELOW));
			}
		}
	}
}

TEST_CASE("no gale moves the tip of a stem below the ground") {
	for (const int modes : { 1, 2 }) {
		for (const float speed : { 20.0f, 60.0f, 150.0f }) {
			StemPlants plants = meadow(jointed(4, 0.5, 0.5, modes));
			float lowest = 1.0f;
			for (int n = 0; n < 200; n++) {
				const float angle = 0.05f * static_cast<float>(n);
				const glm::vec2 air = { speed * std::cos(angle), (n % 40 < 20 ? speed : 0.0f) * std::sin(angle) };
				plants.apply_wind(0.0f, &air);
				plants.step();
				lowest = std::min(lowest, lowest_tip(plants));
			}
			CAPTURE(modes);
			CAPTURE(speed);
			CHECK(lowest >= (modes == 1 ? 0.0f : -MAX_DEPTH_BELOW));
		}
	}
}

TEST_CASE("the ground stops an upright stem in the shape of a steady wind") {
	const StemConstants stem = jointed(4, 0.5, 0.5, 1);
	StemPlants plants(stem, 1, FRAME_STEP);
	plants.set_place(0, glm::vec2(0.8f, 0.6f) * (MAX_STEM_AMPLITUDE / stem.mode[0].tip_slope));
	const StemPage page = plants.page();
	kernels(best_simd_level()).lift_stems(page, 1);
	CHECK(plants.tip(0).x / plants.tip(0).y == Approx(4.0f / 3.0f));
	// The other wind's shape reaches the ground slightly earlier or later.
	CHECK(tip_height(plants, 0) >= GROUND_HEIGHT - 1e-4f);
	CHECK(tip_height(plants, 0) <= GROUND_HEIGHT + 0.06f);
}

TEST_CASE("a tip at the ground loses its downward motion and continues along the ground") {
	const StemConstants stem = jointed(4, 0.0, 0.0, 1);
	StemPlants plants(stem, 1, FRAME_STEP);
	plants.set_place(0, { 1.4f, 0.0f });
	plants.set_rate(0, { 5.0f, 2.0f });
	kernels(best_simd_level()).lift_stems(plants.page(), 1);
	CHECK(plants.rate(0).x == Approx(0.0f).scale(1.0f));
	CHECK(plants.rate(0).y == Approx(2.0f));
	plants.set_place(0, { 1.4f, 0.0f });
	plants.set_rate(0, { -5.0f, 2.0f });
	kernels(best_simd_level()).lift_stems(plants.page(), 1);
	CHECK(plants.rate(0).x == -5.0f);
}

TEST_CASE("the ground limits a second mode equally along both axes") {
	const StemConstants stem = jointed(4, 0.5, 0.5, 2);
	StemPlants plants(stem, 2, FRAME_STEP);
	const glm::vec2 along[] = { { 1.0f, 0.25f }, { 0.25f, 1.0f } };
	for (int i = 0; i < 2; i++) {
		plants.set_place(i, 0.3f * along[i]);
		plants.set_place(i, -2.0f * along[i], 1);
		plants.set_rate(i, 0.5f * along[i]);
		plants.set_rate(i, -20.0f * along[i], 1);
	}
	kernels(best_simd_level()).lift_stems(plants.page(), 2);
	for (int k = 0; k < 2; k++) {
		CAPTURE(k);
		const glm::vec2 place = plants.place(1, k);
		const glm::vec2 rate = plants.rate(1, k);
		CHECK(plants.place(0, k).x == Approx(place.y));
		CHECK(plants.place(0, k).y == Approx(place.x));
		CHECK(plants.rate(0, k).x == Approx(rate.y));
		CHECK(plants.rate(0, k).y == Approx(rate.x));
	}
	CHECK(std::abs(plants.rate(1, 1).y) < 15.0f); // It loses rate along both.
	CHECK(std::abs(plants.rate(1, 1).x) < 3.75f);
}

TEST_CASE("no steady wind bends a stem to the ground") {
	for (const double taper : { 0.0, 0.5, 0.8 }) {
		for (const double head : { 0.0, 1.0, 2.0 }) {
			for (const bool is_in_air : { false, true }) {
				const StemConstants stem = jointed(4, taper, head, 2);
				const SteadyStem steady = is_in_air ? in_wind(stem, 1e4) : in_newtons(stem, 1e4);
				StemPlants plants(stem, 1, FRAME_STEP);
				plants.set_place(0, steady.amplitudes[0]);
				plants.set_place(0, steady.amplitudes[1], 1);
				kernels(best_simd_level()).lift_stems(plants.page(), 1);
				CAPTURE(taper);
				CAPTURE(head);
				CHECK(plants.place(0) == steady.amplitudes[0]);
				CHECK(plants.place(0, 1) == steady.amplitudes[1]);
				const StemConstants one = in_one_mode(stem);
				CHECK(one.mode[0].chord < 1.0f);
			}
		}
	}
}

TEST_CASE("the ground gives no stem energy") {
	for (const int modes : { 1, 2 }) {
		StemPlants plants = meadow(jointed(4, 0.5, 0.5, modes));
		for (int i = 0; i < PLANTS; i++) {
			for (int k = 0; k < modes; k++) {
				plants.set_place(i, { 1.5f * noise(i, 10 + k), 1.5f * noise(i, 12 + k) }, k);
				plants.set_rate(i, { 20.0f * noise(i, 14 + k), 20.0f * noise(i, 16 + k) }, k);
			}
		}
		bool grows = false;
		int lifted = 0;
		for (int i = 0; i < PLANTS; i++) {
			const double before = plants.energy(i);
			StemPage page = plants.page(i);
			const glm::vec2 place = plants.place(i);
			kernels(best_simd_level()).lift_stems(page, 1);
			lifted += plants.place(i) != place ? 1 : 0;
			grows = grows || plants.energy(i) > before * (1.0 + 1e-5);
		}
		CHECK(lifted > PLANTS / 4);
		CHECK_FALSE(grows);
	}
}

TEST_CASE("stems on the ground have the same bits at every level, for any division") {
	for (const int modes : { 1, 2 }) {
		StemPlants whole = meadow(jointed(4, 0.5, 0.5, modes));
		StemPlants parts = whole;
		push_over(whole, 100.0f);
		push_over(parts, 100.0f);
		for (int n = 0; n < 60; n++) {
			whole.step(SimdLevel::baseline);
			parts.step(n % 2 == 0 ? SimdLevel::avx2 : SimdLevel::baseline, { 1.0f, 0.0f }, 1 + n % 17);
		}
		CHECK(whole.hash() == parts.hash());
	}
}

TEST_CASE("without ground the tips of stems may be below it, and with ground every motion stops there") {
	MotionSpecies species;
	species.law = Law::stem;
	species.stem = jointed(4, 0.5, 0.5, 1);
	const MotionPlant plant = { { 0.0f, 0.0f, 0.0f }, species.stem.length };
	for (const bool above_ground : { true, false }) {
		species.joint.above_ground = above_ground;
		MotionPage page(0, species, &plant, 1, FRAME_STEP, true);
		StemState bent;
		bent.place[0] = { MAX_STEM_AMPLITUDE, 0.0f };
		page.set_stem(0, bent);
		CHECK((page.tip(0).y < 0.0f) == !above_ground);
		page.set_state(0, { glm::normalize(glm::vec3(1.0f, -0.7f, 0.0f)), {} });
		CHECK((page.tip(0).y < 0.0f) == !above_ground);
	}
}
