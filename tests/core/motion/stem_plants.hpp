#pragma once

#include "../golden.hpp"
#include "conventions.hpp"
#include "motion/bend_encoding.hpp"
#include "motion/kernel_tables.hpp"
#include "motion/stem_step.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

/// Plants of one species under the stem law's kernel alone, for its tests.
namespace undergrowth {

/// A stem of one mode with the shape under the wind, as for a species without a second mode. Half its deflection is
/// q·x²/2, so its bend is q·x.
inline StemConstants simple_stem(double frequency, double damping) {
	StemConstants stem;
	stem.modes = 1;
	StemMode &mode = stem.mode[0];
	mode.frequency = static_cast<float>(2.0 * PI * frequency);
	mode.damping = static_cast<float>(damping);
	mode.mass = 0.004f;
	mode.stiffness = mode.mass * mode.frequency * mode.frequency;
	stem.dead_slope = 0.5f / mode.stiffness; // A force on the tip: φ(L)/κ.
	const double area = 0.002; // kg/m: half of air's density times drag coefficient and area, all at the tip.
	mode.air_drag = static_cast<float>(area * 0.25);
	mode.air_lag = 0.5f;
	stem.air_slope = static_cast<float>(area * 0.5 / static_cast<double>(mode.stiffness));
	stem.axial_share = 0.75f;
	stem.dead_along = { 0.75f, 0.02f };
	stem.air_along = { 0.85f, 0.02f };
	stem.shape[0][0] = 1.0f;
	for (int j = 0; j <= stem.joints; j++) {
		const float x = static_cast<float>(std::min(j + 1, stem.joints)) / static_cast<float>(stem.joints);
		stem.deflection[j][0] = 0.5f * x * x;
	}
	return stem;
}

/// The same with a second mode that moves in the opposite direction in the middle and takes a small part of each load.
inline StemConstants stem_of_two_modes(double frequency, double damping) {
	StemConstants stem = simple_stem(frequency, damping);
	stem.modes = 2;
	StemMode &second = stem.mode[1];
	second = stem.mode[0];
	second.frequency *= 6.2f;
	second.mass = 0.001f;
	second.stiffness = second.mass * second.frequency * second.frequency;
	stem.mode[0].dead_share = 1.06f;
	second.dead_share = -0.06f;
	stem.mode[0].air_share = 1.02f;
	second.air_share = -0.02f;
	second.air_drag = 0.0002f;
	second.air_lag = -0.05f;
	stem.shape[0][1] = -2.0f;
	stem.shape[1][1] = 3.0f;
	for (int j = 0; j <= stem.joints; j++) {
		const float x = static_cast<float>(std::min(j + 1, stem.joints)) / static_cast<float>(stem.joints);
		stem.deflection[j][1] = x * x * (x - 1.0f) + 0.1f * x * x;
	}
	return stem;
}

class StemPlants {
public:
	StemPlants(const StemConstants &constants, int plants, float step_length) :
			stem(constants),
			count(plants),
			step_time(step_length),
			made(stem_step_constants(constants, step_length)),
			values(static_cast<std::size_t>(COLUMNS * plants)) {
		std::fill(column(SCALE), column(SCALE) + count, 1.0f);
		std::fill(column(STRENGTH), column(STRENGTH) + count, 0.0f);
	}

	const StemConstants &constants() const { return stem; }
	int size() const { return count; }
	double time_step() const { return static_cast<double>(step_time); }
	glm::vec2 place(int index, int mode = 0) const { return pair(4 * mode, index); }
	glm::vec2 rate(int index, int mode = 0) const { return pair(4 * mode + 2, index); }
	/// Sum of all modes.
	glm::vec2 tip(int index) const {
		glm::vec2 sum = { 0.0f, 0.0f };
		for (int k = 0; k < stem.modes; k++) {
			sum += place(index, k) * stem.mode[k].tip_slope;
		}
		return sum;
	}
	/// rad, from the rest direction.
	double tip_angle(int index) const {
		const glm::vec2 u = tip(index);
		return 2.0 * std::atan(std::sqrt(static_cast<double>(u.x * u.x + u.y * u.y)));
	}
	void set_place(int index, const glm::vec2 &value, int mode = 0) { put(4 * mode, index, value); }
	void set_rate(int index, const glm::vec2 &value, int mode = 0) { put(4 * mode + 2, index, value); }
	void set_rest(int index, const glm::vec2 &bend) { put(REST, index, bend); }
	void set_scale(int index, float value) { column(SCALE)[index] = value; }
	void set_strength(int index, float newtons) { column(STRENGTH)[index] = newtons; }
	void set_air(int index, const glm::vec2 &speed) {
		put(AIR, index, speed);
		has_air = true;
	}
	/// The same wind for all plants. Both are null for a field without wind.
	void apply_wind(float newtons, const glm::vec2 *air = nullptr) {
		for (int i = 0; i < count; i++) {
			set_strength(i, newtons);
			if (air) {
				set_air(i, *air);
			}
		}
		has_air = air != nullptr;
	}

	void step(SimdLevel level = best_simd_level(), const glm::vec2 &along = { 1.0f, 0.0f }, int at_once = 512) {
		for (int begin = 0; begin < count; begin += at_once) {
			const PlantWinds winds = { has_newtons ? column(STRENGTH) + begin : nullptr, along.x, along.y };
			PlantAir air;
			air.x = column(AIR) + begin;
			air.y = is_pressed ? column(AIR + 2) + begin : nullptr;
			air.z = column(AIR + 1) + begin;
			kernels(level).step_stem(page(begin), std::min(at_once, count - begin), winds, has_air ? air : PlantAir{});
		}
	}
	/// Runs steps for `seconds`.
	void run(double seconds) {
		for (int i = 0; i < static_cast<int>(std::lround(seconds / time_step())); i++) {
			step();
		}
	}
	void use_newtons(bool used) { has_newtons = used; }
	void use_air(bool used) { has_air = used; }
	/// Air that also moves up (m/s).
	void press(int index, float up) {
		column(AIR + 2)[index] = up;
		is_pressed = true;
	}
	StemPage page(int begin = 0) {
		StemPage made_page = {};
		for (int k = 0; k < stem.modes; k++) {
			made_page.x[k] = column(4 * k) + begin;
			made_page.z[k] = column(4 * k + 1) + begin;
			made_page.rate_x[k] = column(4 * k + 2) + begin;
			made_page.rate_z[k] = column(4 * k + 3) + begin;
		}
		made_page.rest_x = column(REST) + begin;
		made_page.rest_z = column(REST + 1) + begin;
		made_page.scale = column(SCALE) + begin;
		made_page.max_scale = *std::max_element(column(SCALE), column(SCALE) + count);
		for (int i = 0; i < count; i++) {
			made_page.max_lean = std::max(made_page.max_lean, glm::length(pair(REST, i)));
		}
		made_page.step = made;
		return made_page;
	}

	/// 2·mass·|v|² + 2·stiffness·|q|² of all modes.
	double energy(int index) const {
		double sum = 0.0;
		for (int k = 0; k < stem.modes; k++) {
			const glm::vec2 q = place(index, k);
			const glm::vec2 v = rate(index, k);
			sum += 2.0 * static_cast<double>(stem.mode[k].mass) * static_cast<double>(v.x * v.x + v.y * v.y) +
					2.0 * static_cast<double>(stem.mode[k].stiffness) * static_cast<double>(q.x * q.x + q.y * q.y);
		}
		return sum;
	}
	uint64_t hash() const {
		return GoldenHash().add(values.data(), static_cast<std::size_t>(4 * stem.modes * count)).value();
	}

private:
	enum Column : int { REST = 8, SCALE = 10, STRENGTH, AIR, COLUMNS = AIR + 3 };

	StemConstants stem;
	int count;
	float step_time;
	StemStep made;
	std::vector<float> values;
	bool has_newtons = true;
	bool has_air = false;
	bool is_pressed = false;

	float *column(int which) { return values.data() + static_cast<std::size_t>(which * count); }
	const float *column(int which) const { return values.data() + static_cast<std::size_t>(which * count); }
	glm::vec2 pair(int which, int index) const { return { column(which)[index], column(which + 1)[index] }; }
	void put(int which, int index, const glm::vec2 &value) {
		column(which)[index] = value.x;
		column(which + 1)[index] = value.y;
	}
};

} // namespace undergrowth
