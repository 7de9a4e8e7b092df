#pragma once

#include "../golden.hpp"
#include "motion/motion_page.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Fixture of the motion tests: pages, recording and measuring of swings, and a hash of states.
namespace undergrowth {

inline constexpr float FRAME_STEP = 1.0f / 60.0f; // s, the add-on's usual step.
inline constexpr float LONG_STEP = 0.032f; // s, for plants at a reduced rate.

/// At rest, `angle` from upright towards +x.
inline TipState leaning(double angle) {
	return { { static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle)), 0.0f }, {} };
}

inline double deflection(const TipState &state) {
	const double x = static_cast<double>(state.direction.x);
	const double z = static_cast<double>(state.direction.z);
	return std::atan2(std::sqrt(x * x + z * z), static_cast<double>(state.direction.y));
}

inline MotionSpecies species_with(Law law, const Joint &joint) {
	MotionSpecies species;
	species.law = law;
	species.joint = joint;
	return species;
}

inline MotionPlant plant_with(const Joint &joint) {
	MotionPlant plant;
	plant.length = joint.length;
	plant.rest = joint.rest;
	return plant;
}

/// A page of one plant with directions in floats, in `state`.
inline MotionPage plant_page(Law law, const Joint &joint, const TipState &state, float step = FRAME_STEP) {
	const MotionPlant plant = plant_with(joint);
	MotionPage page(0, species_with(law, joint), &plant, 1, step, true, MotionPage::Keeps::directions);
	page.set_state(0, state);
	page.set_before(0, state.direction);
	return page;
}

/// One step under the same horizontal force (N) everywhere.
inline void step_in(MotionPage &page, const glm::vec3 &force, SimdLevel level = best_simd_level()) {
	WindSnapshot wind = {};
	wind.steady = std::sqrt(force.x * force.x + force.z * force.z);
	const float share = wind.steady > 0.0f ? 1.0f / wind.steady : 0.0f;
	page.step(wind, { nullptr, force.x * share, force.z * share }, level);
}

/// The direction's x after each of `steps` steps without wind.
inline std::vector<double> record_x(MotionPage &page, int steps) {
	std::vector<double> places;
	for (int i = 0; i < steps; i++) {
		step_in(page, { 0.0f, 0.0f, 0.0f });
		places.push_back(static_cast<double>(page.state(0).direction.x));
	}
	return places;
}

/// Positions between two samples where the series crosses 0, in samples.
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

/// Hash of the bits of all states.
inline uint64_t hash_states(const MotionPage &page) {
	GoldenHash hash;
	for (int i = 0; i < page.size(); i++) {
		const TipState state = page.state(i);
		hash.add(&state, 1);
	}
	return hash.value();
}

} // namespace undergrowth
