#include "../stem/stems.hpp"
#include "reference_chain.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

using namespace undergrowth;

namespace {

constexpr double FREQUENCY_TOLERANCE = 0.002; // Relative; 64 lumped links.
constexpr double PLACE_TOLERANCE = 0.005; // Of the length.

} // namespace

TEST_CASE("the reference chain swings like the beam of Euler and Bernoulli") {
	struct Known {
		double head, rate; // √(EI/(m·L³)).
	};
	for (const Known known : { Known{ 0.0, 3.5160 }, Known{ 0.5, 2.016 }, Known{ 2.0, 1.158 } }) {
		const StemBeam beam = stiff_stem(0.0, known.head);
		const ReferenceChain chain(beam, beam.youngs_modulus, 0.05);
		const double rate = chain.frequency() / beam_rate(beam, beam.youngs_modulus);
		CAPTURE(known.head);
		CHECK(rate == doctest::Approx(known.rate).epsilon(FREQUENCY_TOLERANCE));
	}
}

TEST_CASE("a load on its tip bends the reference chain like an elastica") {
	struct Known {
		double load, x, y; // Load over EI/L².
	};
	for (const Known known : { Known{ 1.0, 0.302, 0.944 }, Known{ 2.0, 0.494, 0.839 }, Known{ 5.0, 0.714, 0.612 } }) {
		const StemBeam beam = stiff_stem();
		ReferenceChain chain(beam, beam.youngs_modulus, 0.05);
		chain.set_tip_force(known.load * static_cast<double>(beam.youngs_modulus) * root_bending(beam));
		chain.settle();
		CAPTURE(known.load);
		CHECK(std::fabs(chain.place(1.0).x - known.x) < PLACE_TOLERANCE);
		CHECK(std::fabs(chain.place(1.0).y - known.y) < PLACE_TOLERANCE);
	}
}

TEST_CASE("the swinging reference chain has its frequency and its damping") {
	StemBeam beam = stem_of(0.6, 0.5);
	const double modulus = solve_stem(beam).youngs_modulus;
	ReferenceChain chain(beam, modulus, 0.06);
	const double period = 2.0 * PI / chain.frequency();
	chain.set_force(0.001);
	chain.settle();
	chain.set_force(0.0);
	const double first = chain.place(1.0).x;
	for (int i = 0; i < 300; i++) {
		chain.step(period / 100.0);
	}
	const double shrunk = std::exp(-0.06 * 2.0 * PI * 3.0);
	CHECK(chain.place(1.0).x / first == doctest::Approx(shrunk).epsilon(0.03));
	CHECK(chain.frequency() == doctest::Approx(2.0 * PI * 1.5).epsilon(0.005));
}
