#include "stem/stem_large.hpp"

#include "base/portable_math.hpp"

#include <cmath>

namespace undergrowth {

namespace {

static_assert(STEM_SAMPLES == StemChain::LINKS + 1, "a sample at the ends of each link");

// Of a linear beam's tip. The more a stem is bent, the less air bends it.
constexpr double SLOPES[] = { 0.5, 1.0, 2.0, 4.0, 7.0, 12.0 };
constexpr double AIR_SLOPES[] = { 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 30.0 };

/// The bend at the ends of the links: between the bends at their middles.
StemSamples bends_of(const StemChain::Angles &angles) {
	constexpr int LAST = StemChain::LINKS - 1;
	StemChain::Angles bends;
	for (int i = 0; i <= LAST; i++) {
		bends[i] = portable_tan(0.5 * angles[i]);
	}
	StemSamples samples = {};
	for (int i = 1; i <= LAST; i++) {
		samples[i] = 0.5 * (bends[i - 1] + bends[i]);
	}
	samples[LAST + 1] = 1.5 * bends[LAST] - 0.5 * bends[LAST - 1];
	return samples;
}

/// Bend of the tip by the laws of the two winds.
double dead_tip(double slope) {
	return slope / (1.0 + std::sqrt(1.0 + slope * slope));
}

double air_tip(double slope) {
	const double sine = 2.0 * slope / (1.0 + std::sqrt(1.0 + 4.0 * slope * slope));
	return sine / (1.0 + std::sqrt(1.0 - sine * sine));
}

/// Least squares of two unknowns for each sample.
class LargeFit {
public:
	explicit LargeFit(const StemSamples &linear) : shape(linear) {}

	/// Adds bends for which the law gives the bend `tip`.
	void add(const StemSamples &bends, double tip) {
		const double square = tip * tip;
		const double third = square * tip;
		const double fifth = square * third;
		const double weight =
				1.0 / ((1.0 + square) * (1.0 + square)); // Directions turn by 2/(1 + u²) of a change of the bend.
		three += weight * third * third;
		mixed += weight * third * fifth;
		five += weight * fifth * fifth;
		for (int i = 0; i < STEM_SAMPLES; i++) {
			const double rest = weight * (bends[i] - tip * shape[i]);
			right.x3[i] += third * rest;
			right.x5[i] += fifth * rest;
		}
	}

	LargeBends solve() const {
		const double determinant = three * five - mixed * mixed;
		LargeBends bends;
		for (int i = 0; i < STEM_SAMPLES; i++) {
			bends.x3[i] = (five * right.x3[i] - mixed * right.x5[i]) / determinant;
			bends.x5[i] = (three * right.x5[i] - mixed * right.x3[i]) / determinant;
		}
		return bends;
	}

private:
	const StemSamples &shape;
	double three = 0.0;
	double mixed = 0.0;
	double five = 0.0;
	LargeBends right = {};
};

} // namespace

LargeBends large_bends_of_newtons(const StemChain &chain, const StemSamples &shape, double newtons) {
	LargeFit fit(shape);
	StemChain::Angles angles = {};
	for (const double slope : SLOPES) {
		chain.settle_dead(slope * newtons, angles);
		fit.add(bends_of(angles), dead_tip(slope));
	}
	return fit.solve();
}

LargeBends large_bends_of_air(const StemChain &chain, const StemSamples &shape, double speed_squared) {
	LargeFit fit(shape);
	StemChain::Angles angles = {};
	for (const double slope : AIR_SLOPES) {
		chain.settle_air(slope * speed_squared, angles);
		fit.add(bends_of(angles), air_tip(slope));
	}
	return fit.solve();
}

} // namespace undergrowth
