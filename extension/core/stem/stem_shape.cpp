#include "stem/stem_shape.hpp"

namespace undergrowth {

namespace {

constexpr int TERMS = STEM_SHAPE_TERMS;
/// Products of two terms, summed over all samples; the right column has the products of a term with the fitted values.
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

/// Gaussian elimination. The matrix is positive definite, so it needs no pivoting.
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

float first_share(const StemConstants &stem) {
	return stem.modes == 1 ? 1.0f : stem.mode[0].dead_share * stem.mode[0].tip_slope;
}

/// For a mode that is a mix of two, which share no stiffness. The products of both with the air follow from the lags,
/// ∫c φ_1 φ_k = air_lag_k·∫c φ_1. ∫c φ_2 follows from the force on that mode.
static StemMode mixed_mode(const StemConstants &stem, float a, float b) {
	const StemMode &first = stem.mode[0];
	const StemMode &second = stem.mode[1];
	StemMode mode = first;
	mode.stiffness = a * a * first.stiffness + b * b * second.stiffness;
	mode.mass = mode.stiffness / (mode.frequency * mode.frequency);
	mode.tip_slope = mode.dead_share = mode.air_share = 1.0f;
	mode.chord = a * first.chord;
	if (first.air_lag > 0.0f) {
		const float first_push = first.air_drag / first.air_lag;
		const float push = a * first_push + b * second.air_share * stem.air_slope * second.stiffness;
		mode.air_drag = a * a * first.air_drag + 2.0f * a * b * second.air_lag * first_push + b * b * second.air_drag;
		mode.air_lag = push > 0.0f ? mode.air_drag / push : first.air_lag;
	}
	return mode;
}

StemConstants in_one_mode(const StemConstants &stem) {
	if (stem.modes == 1) {
		return stem;
	}
	const float a = stem.mode[0].dead_share;
	const float b = stem.mode[1].dead_share;
	StemConstants one = stem;
	one.modes = 1;
	one.mode[0] = mixed_mode(stem, a, b);
	one.mode[1] = StemMode();
	for (float (&shape)[4] : one.shape) {
		shape[0] = a * shape[0] + b * shape[1];
		shape[1] = 0.0f;
	}
	for (float (&deflection)[MAX_STEM_MODES] : one.deflection) {
		deflection[0] = a * deflection[0] + b * deflection[1];
		deflection[1] = 0.0f;
	}
	return one;
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
