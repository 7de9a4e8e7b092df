#pragma once

#include "../golden.hpp"
#include "motion/batch.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

/// What the pendulum tests share: how a swing is recorded and measured, and a hash of a batch.
namespace undergrowth {

inline constexpr float FRAME_STEP = 1.0f / 60.0f; // s, the add-on's usual step.
inline constexpr float LONG_STEP = 0.032f; // s, of plants stepped at a reduced rate.

/// At rest, `angle` from upright towards +x.
inline TipState leaning(double angle) {
	return { { static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle)), 0.0f }, {} };
}

inline double deflection(const TipState &state) {
	const double x = static_cast<double>(state.direction.x);
	const double z = static_cast<double>(state.direction.z);
	return std::atan2(std::sqrt(x * x + z * z), static_cast<double>(state.direction.y));
}

/// The direction's x after each of `steps` steps without wind.
inline std::vector<double> record_x(PendulumBatch &batch, int steps) {
	std::vector<double> places;
	for (int i = 0; i < steps; i++) {
		batch.step({ 0.0f, 0.0f, 0.0f });
		places.push_back(static_cast<double>(batch.state(0).direction.x));
	}
	return places;
}

/// Places between two samples where the series crosses 0, in samples.
inline std::vector<double> zero_crossings(const std::vector<double> &series) {
	std::vector<double> crossings;
	for (std::size_t i = 1; i < series.size(); i++) {
		if ((series[i - 1] < 0.0) != (series[i] < 0.0)) {
			crossings.push_back(static_cast<double>(i) - series[i] / (series[i] - series[i - 1]));
		}
	}
	return crossings;
}

/// Cycles per second, from the first zero crossing to the last.
inline double frequency_of(const std::vector<double> &series, double sample_time) {
	const std::vector<double> crossings = zero_crossings(series);
	const double half_swings = static_cast<double>(crossings.size()) - 1.0;
	return 0.5 * half_swings / ((crossings.back() - crossings.front()) * sample_time);
}

/// Sizes of the extremes, each the top of a parabola through three samples.
inline std::vector<double> peaks_of(const std::vector<double> &series) {
	std::vector<double> peaks;
	for (std::size_t i = 1; i + 1 < series.size(); i++) {
		const double a = std::fabs(series[i - 1]);
		const double b = std::fabs(series[i]);
		const double c = std::fabs(series[i + 1]);
		if (b >= a && b > c) {
			peaks.push_back(b + (a - c) * (a - c) / (8.0 * (2.0 * b - a - c)));
		}
	}
	return peaks;
}

/// 1/s, of the amplitude, from the first peak to the last.
inline double decay_rate_of(const std::vector<double> &series, double sample_time) {
	const std::vector<double> peaks = peaks_of(series);
	const double half_swings = static_cast<double>(peaks.size()) - 1.0;
	const double time = 0.5 * half_swings / frequency_of(series, sample_time);
	return std::log(peaks.front() / peaks.back()) / time;
}

/// Of the bits of all states.
inline uint64_t hash_states(const PendulumBatch &batch) {
	GoldenHash hash;
	for (int i = 0; i < batch.size(); i++) {
		const TipState state = batch.state(i);
		hash.add(&state, 1);
	}
	return hash.value();
}

} // namespace undergrowth
