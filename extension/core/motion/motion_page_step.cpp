// How a MotionPage moves: constants for its step's length, and steps.

#include "motion/motion_page.hpp"
#include "motion/motion_page_columns.hpp"
#include "wind/air.hpp"
#include "wind/air_sources.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

using namespace motion_page_columns;

namespace {

/// Plants whose winds are sampled together: the strengths stay in the first-level cache.
constexpr int BLOCK = 512;

/// A wind of newtons as the air that pushes as hard: strengths in, velocities out along both axes.
void make_air(const PlantWinds &along, float drag, int count, float *strengths, float *side) {
	const float over_drag = drag > 0.0f ? 1.0f / drag : 0.0f;
	for (int i = 0; i < count; i++) {
		const float speed = std::sqrt(strengths[i] * over_drag);
		strengths[i] = speed * along.x;
		side[i] = speed * along.z;
	}
}

} // namespace

void MotionPage::set_step_length(float step) {
	if (is_swinging && kind.law == Law::elasticity) {
		const float ratio = step / step_time;
		for (int i = 0; i < size(); i++) {
			column(TURN_X)[i] *= ratio;
			column(TURN_Y)[i] *= ratio;
			column(TURN_Z)[i] *= ratio;
		}
	}
	step_time = step;
	if (is_swinging) {
		update_constants(0);
	}
}

void MotionPage::update_constants(int begin, int end) {
	if (kind.law == Law::elasticity) {
		elasticity = elasticity_constants(kind.joint, step_time);
		elasticity_weights(kind.joint, step_time, lengths() + begin, end - begin, column(WEIGHT) + begin);
	} else {
		spring = spring_constants(kind.joint, step_time);
		spring_gains(spring, lengths() + begin, end - begin, column(WIND_GAIN) + begin);
	}
}

ElasticityPage MotionPage::elasticity_page(int begin) {
	ElasticityPage page;
	page.x = column(X) + begin;
	page.y = column(Y) + begin;
	page.z = column(Z) + begin;
	page.turn_x = column(TURN_X) + begin;
	page.turn_y = column(TURN_Y) + begin;
	page.turn_z = column(TURN_Z) + begin;
	page.weight = column(WEIGHT) + begin;
	page.lift_share = elasticity.lift_share;
	page.wind_share = elasticity.wind_share;
	page.keep = elasticity.keep;
	page.lowest_y = elasticity.lowest_y;
	return page;
}

SpringPage MotionPage::spring_page(int begin) {
	SpringPage page;
	page.x = column(FLAT_X) + begin;
	page.z = column(FLAT_Z) + begin;
	page.rate_x = column(FLAT_RATE_X) + begin;
	page.rate_z = column(FLAT_RATE_Z) + begin;
	page.rest_x = column(REST_X) + begin;
	page.rest_z = column(REST_Z) + begin;
	page.wind_gain = column(WIND_GAIN) + begin;
	page.place_from_place = spring.place_from_place;
	page.place_from_rate = spring.place_from_rate;
	page.rate_from_place = spring.rate_from_place;
	page.rate_from_rate = spring.rate_from_rate;
	page.most = MAX_GNOMONIC;
	return page;
}

void MotionPage::prefetch() const {
#if defined(__GNUC__)
	constexpr int FLOATS = 64; // Of each column: what the processor's own prefetching needs to take over.
	for (int i = ROOT_X; is_swinging && i < SWINGING_COLUMNS; i++) {
		for (int j = 0; j < FLOATS; j += 16) {
			__builtin_prefetch(column(i) + j);
		}
	}
#endif
}

/// What is drawn as the last direction, before a step.
void MotionPage::remember() {
	const auto copy = [this](int from, int to) { std::copy(column(from), column(from) + size(), column(to)); };
	if (kind.law == Law::elasticity) {
		copy(X, LAST_X);
		copy(Y, LAST_Y);
		copy(Z, LAST_Z);
	} else {
		copy(FLAT_X, FLAT_LAST_X);
		copy(FLAT_Z, FLAT_LAST_Z);
	}
}

/// What sources do to a block, on top of air, or of newtons, which become air.
void MotionPage::stir(const TravellingWind &wind, const PlantWinds &along, int begin, int count, float *x, float *z) {
	if (!wind.is_air) {
		make_air(along, air_drag(kind.joint), count, x, z);
	}
	add_sources(wind.sources, box_low, box_high, column(ROOT_X) + begin, column(ROOT_Y) + begin, column(ROOT_Z) + begin,
			count, x, z);
}

void MotionPage::step(const TravellingWind &wind, const PlantWinds &along, SimdLevel level) {
	const KernelSet &set = kernels(level);
	const WindKernels &air = wind_kernels(level);
	if (keeps_directions) {
		remember();
	}
	const AirBlow blow = blow_over(wind.air, kind.stand_height, along);
	const float *alone = kind.stand_height > 0.0f ? nullptr : lengths();
	const float drag = air_drag(kind.joint);
	const float slowing = step_time * drag * kind.joint.wind_weight / kind.joint.mass;
	const bool is_stirred = any_reaches(wind.sources, box_low, box_high);
	const bool is_air = wind.is_air || is_stirred;
	float strengths[BLOCK]; // Of newtons; of air the velocities along x.
	float side[BLOCK];
	for (int begin = 0; begin < size(); begin += BLOCK) {
		const int count = std::min(BLOCK, size() - begin);
		const float *x = column(ROOT_X) + begin;
		const float *z = column(ROOT_Z) + begin;
		if (wind.is_air) {
			sample_air(wind, blow, x, z, alone ? alone + begin : nullptr, count, strengths, side, level);
		} else {
			air.sample(wind, x, z, count, strengths);
		}
		if (is_stirred) {
			stir(wind, along, begin, count, strengths, side);
		}
		const PlantAir breeze = { strengths, side, lengths() + begin, drag, slowing, 1.0f / step_time };
		const PlantWinds winds = { strengths, along.x, along.z };
		Bend *block_pairs = keeps_directions ? nullptr : pairs.data() + 2 * static_cast<std::size_t>(begin);
		if (kind.law == Law::elasticity) {
			const ElasticityPage block = elasticity_page(begin);
			if (is_air) {
				set.step_elasticity_in_air(block, count, breeze);
			} else {
				set.step_elasticity(block, count, winds);
			}
			if (block_pairs) {
				set.encode_elasticity(block.x, block.y, block.z, count, block_pairs);
			}
		} else {
			const SpringPage block = spring_page(begin);
			if (is_air) {
				set.step_spring_in_air(block, count, breeze);
			} else {
				set.step_spring(block, count, winds);
			}
			if (block_pairs) {
				set.encode_spring(block.x, block.z, count, block_pairs);
			}
		}
	}
}

void MotionPage::interpolate(float alpha, glm::vec3 *out) const {
	static_assert(sizeof(glm::vec3) == 3 * sizeof(float), "the kernels write three floats for each plant");
	if (size() == 0 || !keeps_directions) {
		return;
	}
	const auto at = [this](int which) { return column(which); };
	const KernelSet &set = kernels(best_simd_level());
	if (kind.law == Law::elasticity) {
		const DirectionView view = { at(X), at(Y), at(Z), at(LAST_X), at(LAST_Y), at(LAST_Z) };
		set.interpolate_elasticity(view, size(), alpha, &out->x);
	} else {
		const GnomonicView view = { at(FLAT_X), at(FLAT_Z), at(FLAT_LAST_X), at(FLAT_LAST_Z) };
		set.interpolate_spring(view, size(), alpha, &out->x);
	}
}

} // namespace undergrowth
