#include "stem/stem_shape.hpp"

namespace undergrowth {

namespace {

constexpr int TERMS = STEM_SHAPE_TERMS;
/// Of two terms, summed over all samples, and on the right what a term has in common with what is fitted.
using Normal = std::array<std::array<double, TERMS + 1>, TERMS>;

StemTerms powers_of(double x) {
	StemTerms powers;
	double power = x;
	for (double &entry : powers) {
		entry = power;
		power *= x;
	}
	return powers;
}

/// Gauss; the matrix is positive definite, so no rows change places.
StemTerms solved(Normal normal) {
	for (int i = 0; i < TERMS; i++) {
		for (int row = i + 1; row < TERMS; row++) {
			const double factor = normal[row][i] / normal[i][i];
			for (int j = i; j <= TERMS; j++) {
				normal[row][j] -= factor * normal[i][j];
			}
		}
	}
	StemTerms terms;
	for (int i = TERMS - 1; i >= 0; i--) {
		double sum = normal[i][TERMS];
		for (int j = i + 1; j < TERMS; j++) {
			sum -= normal[i][j] * terms[j];
		}
		terms[i] = sum / normal[i][i];
	}
	return terms;
}

} // namespace

StemTerms fit_shape(const StemSamples &samples) {
	Normal normal = {};
	for (int n = 0; n < STEM_SAMPLES; n++) {
		const StemTerms powers = powers_of(static_cast<double>(n) / (STEM_SAMPLES - 1));
		for (int i = 0; i < TERMS; i++) {
			for (int j = 0; j < TERMS; j++) {
				normal[i][j] += powers[i] * powers[j];
			}
			normal[i][TERMS] += powers[i] * samples[n];
		}
	}
	return solved(normal);
}

StemConstants in_air(const StemConstants &stem) {
	StemConstants result = stem;
	for (int j = 0; j < STEM_SHAPE_TERMS; j++) {
		result.shape[j][2] = stem.air_shape[j][0];
		result.shape[j][3] = stem.air_shape[j][1];
	}
	return result;
}

} // namespace undergrowth
