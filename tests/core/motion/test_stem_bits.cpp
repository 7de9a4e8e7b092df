#include "../base/sanitized.hpp"
#include "../field/allocations.hpp"
#include "../stem/stems.hpp"
#include "stem_plants.hpp"
#include "swing.hpp"
#include "varied.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <vector>

using namespace undergrowth;

namespace {

constexpr float NONE = std::numeric_limits<float>::quiet_NaN();
constexpr float INF = std::numeric_limits<float>::infinity();

enum class Blowing { newtons, air, both, downward };
constexpr Blowing WINDS[] = { Blowing::newtons, Blowing::air, Blowing::both, Blowing::downward };

/// Stems that are all different. If `leans` is false, all are upright.
StemPlants meadow(int modes, int count, bool leans, double frequency = 1.5) {
	const StemConstants stem = modes == 1 ? simple_stem(frequency, 0.08) : stem_of_two_modes(frequency, 0.08);
	StemPlants plants(stem, count, FRAME_STEP);
	for (int i = 0; i < count; i++) {
		plants.set_scale(i, 1.0f + 0.5f * noise(i, 1));
		if (leans) {
			plants.set_rest(i, { 0.3f * noise(i, 2), 0.3f * noise(i, 3) });
		}
		for (int k = 0; k < modes; k++) {
			plants.set_place(i, { 0.4f * noise(i, 4 + k), 0.4f * noise(i, 6 + k) }, k);
			plants.set_rate(i, { 3.0f * noise(i, 8 + k), 3.0f * noise(i, 10 + k) }, k);
		}
	}
	return plants;
}

/// Loads from none to 40 times the slope that lays a stem half down.
void apply_wind(StemPlants &plants, int step, Blowing wind) {
	const float swell = step % 200 < 100 ? 1.0f : 30.0f;
	for (int i = 0; i < plants.size(); i++) {
		plants.set_strength(i, swell * (1.0f + noise(i, 100 + step)) / plants.constants().dead_slope);
		plants.set_air(i, { 2.0f * swell * noise(i, 1000 + step), 2.0f * noise(i, 2000 + step) });
	}
	plants.use_newtons(wind != Blowing::air);
	plants.use_air(wind != Blowing::newtons);
	for (int i = 0; i < plants.size() && wind == Blowing::downward; i++) {
		plants.press(i, i % 3 == 0 ? 0.0f : -swell * (1.0f + noise(i, 3000 + step)));
	}
}

bool is_fine(const StemPlants &plants) {
	bool fine = true;
	for (int i = 0; i < plants.size(); i++) {
		for (int k = 0; k < plants.constants().modes; k++) {
			const glm::vec2 q = plants.place(i, k);
			const glm::vec2 v = plants.rate(i, k);
			fine = fine && std::isfinite(v.x + v.y) && std::fabs(q.x) <= 1.5f && std::fabs(q.y) <= 1.5f;
		}
	}
	return fine;
}

} // namespace

TEST_CASE("any division of stems, at every level, gives the same bits") {
	for (const int modes : { 1, 2 }) {
		for (const bool leans : { false, true }) {
			for (const Blowing wind : WINDS) {
				StemPlants whole = meadow(modes, 601, leans);
				StemPlants best = meadow(modes, 601, leans);
				StemPlants parts = meadow(modes, 601, leans);
				for (int n = 0; n < repetitions(250, 50); n++) {
					apply_wind(whole, n, wind);
					apply_wind(best, n, wind);
					apply_wind(parts, n, wind);
					whole.step(SimdLevel::baseline, { 0.8f, -0.6f });
					best.step(SimdLevel::avx2, { 0.8f, -0.6f });
					parts.step(n % 2 == 0 ? SimdLevel::avx2 : SimdLevel::baseline, { 0.8f, -0.6f }, 1 + n % 37);
				}
				CAPTURE(modes);
				CAPTURE(leans);
				CHECK(whole.hash() == best.hash());
				CHECK(whole.hash() == parts.hash());
			}
		}
	}
}

TEST_CASE("an upright stem among leaning ones has the same bits as among upright ones") {
	for (const Blowing wind : WINDS) {
		StemPlants upright = meadow(1, 40, false);
		StemPlants mixed = meadow(1, 40, false);
		mixed.set_rest(39, { 0.2f, 0.1f });
		for (int n = 0; n < 100; n++) {
			apply_wind(upright, n, wind);
			apply_wind(mixed, n, wind);
			upright.step();
			mixed.step();
		}
		bool same = true;
		for (int i = 0; i < 39; i++) {
			same = same && upright.place(i) == mixed.place(i) && upright.rate(i) == mixed.rate(i);
		}
		CHECK(same);
	}
}

TEST_CASE("a step of stems allocates nothing") {
	StemPlants plants = meadow(2, 1000, true);
	apply_wind(plants, 0, Blowing::both);
	const StemPage page = plants.page();
	std::vector<float> numbers(1000, 1.0f);
	const long before = allocation_count();
	kernels(best_simd_level())
			.step_stem(page, 1000, { numbers.data(), 1.0f, 0.0f }, { numbers.data(), nullptr, numbers.data() });
	CHECK(allocation_count() == before);
}

TEST_CASE("the bends of both modes become pairs of halves, the first one about the rest") {
	for (const SimdLevel level : { SimdLevel::baseline, SimdLevel::avx2 }) {
		for (const int modes : { 1, 2 }) {
			constexpr int COUNT = 515;
			StemPlants plants = meadow(modes, COUNT, false);
			std::vector<uint32_t> first(2 * COUNT, 7u), second(2 * COUNT, 7u);
			StemPage page = plants.page();
			kernels(level).encode_stem(page, COUNT, first.data(), second.data());
			for (int i = 0; i < COUNT; i++) {
				StemState state;
				StemConstants stem;
				stem.modes = modes;
				for (int k = 0; k < modes; k++) {
					state.place[k] = plants.place(i, k);
					stem.mode[k].tip_slope = page.step.tip_slope[k];
				}
				const StemBends wanted = bends_of(stem, state, { page.rest_x[i], page.rest_z[i] });
				const auto pair = static_cast<std::size_t>(2 * i);
				REQUIRE(first[pair] == 7u);
				REQUIRE(first[pair + 1] == wanted.first);
				REQUIRE((modes == 1 || second[pair + 1] == wanted.second));
			}
		}
	}
}

TEST_CASE("no wind, however strong or wrong, moves a stem beyond the limits, and it recovers in calm air") {
	const float strengths[] = { 1e6f, 0.0f, NONE, 1e30f, INF, -INF, 1e4f };
	for (const int modes : { 1, 2 }) {
		for (const double frequency : { 0.1, 0.7, 1.5, 4.0, 15.0, 300.0 }) {
			for (const float step : { 1.0f / 15.0f, FRAME_STEP, 1.0f / 144.0f }) {
				for (const float lean : { 0.0f, 0.41f }) {
					const StemConstants stem =
							modes == 1 ? simple_stem(frequency, 0.05) : stem_of_two_modes(frequency, 0.05);
					StemPlants plants(stem, 7, step);
					for (int i = 0; i < 7; i++) {
						plants.set_rest(i, { lean, 0.0f });
						plants.set_place(i, { 1.5f, -1.5f });
						plants.set_rate(i, { 6.0f * stem.mode[0].frequency, 0.0f });
					}
					bool fine = true;
					for (int n = 0; n < 210; n++) {
						for (int i = 0; i < 7; i++) {
							plants.set_strength(i, strengths[(n / 10 + i) % 7]);
							plants.set_air(i, { strengths[(n / 7 + i) % 7], strengths[(n / 5 + i) % 7] });
						}
						plants.use_newtons(n % 3 != 0);
						plants.use_air(n % 3 != 1);
						plants.step(best_simd_level(), n % 30 == 29 ? glm::vec2(NONE, INF) : glm::vec2(-0.6f, 0.8f));
						fine = fine && is_fine(plants);
					}
					plants.apply_wind(0.0f);
					plants.run(40.0 / frequency + 60.0 * static_cast<double>(step));
					CAPTURE(frequency);
					CAPTURE(step);
					CHECK(fine);
					CHECK(glm::length(plants.place(0)) < 1e-3f);
				}
			}
		}
	}
}

TEST_CASE("stems settle in steady winds of any strength, at any step, leaning or not") {
	constexpr float STILL = 2e-4f; // Of an amplitude, per step, after 60 swings.
	for (const int modes : { 1, 2 }) {
		for (const double frequency : { 0.7, 1.5, 5.0, 15.0 }) {
			for (const float step : { 1.0f / 15.0f, 1.0f / 30.0f, FRAME_STEP }) {
				for (const float lean : { -0.41f, 0.0f, 0.41f }) {
					for (const double load : { 0.3, 2.0, 10.0, 100.0, 1e4 }) {
						for (const Blowing wind : WINDS) {
							const StemConstants stem =
									modes == 1 ? simple_stem(frequency, 0.05) : stem_of_two_modes(frequency, 0.05);
							StemPlants plants(stem, 1, step);
							plants.set_rest(0, { lean, 0.3f * lean });
							const glm::vec2 speed = { 0.0f, std::sqrt(static_cast<float>(load) / stem.air_slope) };
							plants.apply_wind(static_cast<float>(load) / stem.dead_slope, &speed);
							plants.use_newtons(wind != Blowing::air);
							plants.use_air(wind != Blowing::newtons);
							plants.run(60.0 / frequency + 100.0 * static_cast<double>(step));
							const glm::vec2 before = plants.place(0);
							plants.step();
							CAPTURE(modes);
							CAPTURE(frequency);
							CAPTURE(step);
							CAPTURE(lean);
							CAPTURE(load);
							CAPTURE(static_cast<int>(wind));
							CHECK(glm::length(plants.place(0) - before) < STILL);
						}
					}
				}
			}
		}
	}
}

TEST_CASE("a thousand steps of stems have the same bits on every platform") {
	constexpr uint64_t GOLDEN[] = { 0x259d10a98e77f896ull, 0x477ea4d529d555aeull };
	for (const int modes : { 1, 2 }) {
		StemPlants plants = meadow(modes, 50, true);
		for (int n = 0; n < 1000; n++) {
			apply_wind(plants, n, WINDS[n / 50 % 3]);
			plants.step(best_simd_level(), { 0.6f, 0.8f });
		}
		CHECK(plants.hash() == GOLDEN[modes - 1]);
	}
}
