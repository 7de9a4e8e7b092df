// How a MotionPage moves: constants for its step's length, and steps.

#include "motion/motion_page.hpp"
#include "motion/motion_page_columns.hpp"

#include <algorithm>

namespace undergrowth {

using namespace motion_page_columns;

namespace {

/// Plants whose winds are sampled together: the strengths stay in the first-level cache.
constexpr int BLOCK = 512;
constexpr float SHORTEST = 1e-4f; // m; as safe_joint().

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

void MotionPage::update_constants(int begin) {
	Joint joint = kind.joint;
	if (kind.law == Law::elasticity) {
		elasticity = elasticity_constants(joint, step_time);
		elasticity_weights(joint, step_time, lengths() + begin, size() - begin, column(WEIGHT) + begin);
		return;
	}
	joint.length = 1.0f;
	spring = spring_constants(joint, step_time);
	for (int i = begin; i < size(); i++) {
		column(WIND_GAIN)[i] = spring.wind_gain / std::max(length(i), SHORTEST);
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
	page.lift_share = 1.0f + kind.joint.elasticity;
	page.wind_share = kind.joint.wind_weight / (kind.joint.mass * STANDARD_GRAVITY);
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

void MotionPage::step(const TravellingWind &wind, const PlantWinds &along) {
	const KernelSet &set = kernels(best_simd_level());
	const WindKernels &air = wind_kernels(best_simd_level());
	float strengths[BLOCK];
	for (int begin = 0; begin < size(); begin += BLOCK) {
		const int count = std::min(BLOCK, size() - begin);
		air.sample(wind, column(ROOT_X) + begin, column(ROOT_Z) + begin, count, strengths);
		const PlantWinds winds = { strengths, along.x, along.z };
		Bend *block_pairs = pairs.data() + 2 * static_cast<std::size_t>(begin);
		if (kind.law == Law::elasticity) {
			const ElasticityPage block = elasticity_page(begin);
			set.step_elasticity_page(block, count, winds);
			set.encode_elasticity(block.x, block.y, block.z, count, block_pairs);
		} else {
			const SpringPage block = spring_page(begin);
			set.step_spring_page(block, count, winds);
			set.encode_spring(block.x, block.z, count, block_pairs);
		}
	}
}

} // namespace undergrowth
