#include "../stem/stems.hpp"
#include "reference_chain.hpp"
#include "stem/stem_bones.hpp"
#include "stem/stem_shape.hpp"
#include "stem_plants.hpp"
#include "swing.hpp"

#include "figures.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <initializer_list>

using namespace undergrowth;

namespace {

enum class Wind { newtons, air };

constexpr double GUST_TOLERANCE = 0.035; // Of the length, the tip's whole path, up to a tip angle of 45°.
constexpr double STEADY_TOLERANCE = 0.0075; // Of a dead load.
constexpr double RELEASE_TOLERANCE = 0.03; // From 45°.
constexpr double STEP_TOLERANCE = 0.04; // A sudden load, tip to 45°.
constexpr double LEAN_TOLERANCE = 0.007; // Of a steady load.
constexpr double FAST_TOLERANCE = 0.03; // The same for stems that swing too fast for the steps.

/// A stem of the law and the chain, in the same wind, given as the linear slope of the tip.
class Rivals {
public:
	Rivals(const StemBeam &beam, Wind wind_kind, double lean = 0.0, float step = FRAME_STEP) :
			solution(solve_stem(beam)),
			kind(wind_kind),
			turn(lean),
			stem(kind == Wind::air ? in_air(solution.constants) : solution.constants),
			plants(stem, 1, step),
			chain(beam, solution.youngs_modulus, static_cast<double>(beam.damping_ratio), lean) {
		plants.set_rest(0, { static_cast<float>(std::tan(0.5 * lean)), 0.0f });
	}

	double period() const { return 2.0 * PI / chain.frequency(); }
	double angle() const { return chain.tip_angle() - turn; }

	void load(double slope) {
		move_plants(slope);
		move_chain(slope);
	}
	void settle() {
		chain.settle();
		plants.run(100.0 * std::max(period(), plants.time_step()));
	}
	/// Max distance of the tips over a number of periods, in lengths. The load follows `slope`, a function of time in
	/// periods.
	double follow(double periods, const std::function<double(double)> &slope) {
		const int parts = static_cast<int>(std::ceil(plants.time_step() * 100.0 / period()));
		const double part = plants.time_step() / parts;
		double worst = 0.0;
		for (double time = 0.0; time < periods * period(); time += plants.time_step()) {
			move_plants(slope((time + 0.5 * plants.time_step()) / period()));
			plants.step();
			for (int i = 0; i < parts; i++) {
				move_chain(slope((time + (i + 0.5) * part) / period()));
				chain.step(part);
			}
			worst = std::max(worst, apart());
			farthest = std::max(farthest, std::fabs(angle()));
		}
		return worst;
	}
	double apart() const {
		const glm::vec2 places[] = { plants.place(0, 0), stem.modes > 1 ? plants.place(0, 1) : glm::vec2(0.0f) };
		const glm::dvec3 tip = stem_place(stem, places, 1.0f).centre;
		const glm::dvec2 seen = { tip.x * std::cos(turn) + tip.y * std::sin(turn),
			tip.y * std::cos(turn) - tip.x * std::sin(turn) };
		return glm::length(seen - chain.place(1.0));
	}
	double farthest = 0.0; ///< rad, of the chain's tip.

private:
	StemSolution solution;
	Wind kind;
	double turn;
	StemConstants stem;
	StemPlants plants;
	ReferenceChain chain;

	void move_plants(double slope) {
		if (kind == Wind::newtons) {
			plants.apply_wind(static_cast<float>(slope) / stem.dead_slope);
		} else {
			const glm::vec2 air = { static_cast<float>(speed(slope)), 0.0f };
			plants.apply_wind(0.0f, &air);
		}
	}
	void move_chain(double slope) {
		if (kind == Wind::newtons) {
			chain.set_force(slope / static_cast<double>(stem.dead_slope));
		} else {
			chain.set_wind(speed(slope));
		}
	}
	double speed(double slope) const { return std::sqrt(slope / static_cast<double>(stem.air_slope)) + 1e-9; }
};

/// Uniform; tapered; tapered with a head that has drag.
StemBeam sample(int which, int modes) {
	StemBeam beam = stem_of(which == 0 ? 0.0 : 0.6, which == 2 ? 0.5 : 0.0);
	beam.head_drag_area = which == 2 ? 0.0015f : 0.0f;
	beam.damping_ratio = 0.09f;
	beam.modes = modes;
	return beam;
}

/// One gust that rises and falls in two periods.
std::function<double(double)> gust(double slope) {
	return [slope](double periods) { return periods < 2.0 ? slope * 0.5 * (1.0 - std::cos(PI * periods)) : 0.0; };
}

} // namespace

TEST_CASE("a gust moves the tip like that of a chain of 64 links") {
	for (const int which : { 0, 1, 2 }) {
		for (const int modes : { 1, 2 }) {
			for (const Wind kind : { Wind::newtons, Wind::air }) {
				Rivals rivals(sample(which, modes), kind);
				const double worst = rivals.follow(3.0, gust(kind == Wind::newtons ? 0.75 : 1.2));
				CAPTURE(which);
				CAPTURE(modes);
				CHECK(worst < GUST_TOLERANCE);
				figures::record_error(
						figures::SWINGS, "path of the tip in a gust to 45°, of the length", GUST_TOLERANCE, worst);
				CHECK(rivals.farthest * 180.0 / PI == doctest::Approx(45.0).epsilon(0.06));
			}
		}
	}
}

TEST_CASE("a released stem swings like the chain") {
	for (const int which : { 0, 1, 2 }) {
		Rivals rivals(sample(which, 1), Wind::newtons);
		rivals.load(1.0);
		rivals.settle();
		CHECK(rivals.apart() < STEADY_TOLERANCE);
		const double worst = rivals.follow(2.5, [](double) { return 0.0; });
		CAPTURE(which);
		CHECK(worst < RELEASE_TOLERANCE);
		figures::record_error(figures::SWINGS, "the same when let go from 45°", RELEASE_TOLERANCE, worst);
	}
}

TEST_CASE("a sudden load moves the tip like the chain's") {
	for (const int which : { 0, 1, 2 }) {
		for (const Wind kind : { Wind::newtons, Wind::air }) {
			Rivals rivals(sample(which, 1), kind);
			const double worst = rivals.follow(2.5, [](double) { return 0.5; });
			CAPTURE(which);
			CHECK(worst < STEP_TOLERANCE);
		}
	}
}

TEST_CASE("leaning stems come to rest in the wind like the chain, slow ones and ones too fast for the steps") {
	for (const double lean : { -42.0, -20.0, 20.0, 42.0 }) {
		for (const double slope : { 0.25, 0.5, 1.0 }) {
			for (const Wind kind : { Wind::newtons, Wind::air }) {
				for (const float step : { 0.0005f, FRAME_STEP }) {
					StemBeam beam = stiff_stem(0.6);
					beam.youngs_modulus = 1e9f;
					beam.leaf_drag_area = 0.2f;
					Rivals rivals(beam, kind, lean * PI / 180.0, step);
					rivals.load(slope);
					rivals.settle();
					CAPTURE(lean);
					CAPTURE(slope);
					CAPTURE(step);
					CHECK(rivals.apart() < (step == FRAME_STEP ? FAST_TOLERANCE : LEAN_TOLERANCE));
				}
			}
		}
	}
}
