#include "motion/page_wind.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

/// Converts a wind in newtons to the air with the same force: strengths in, velocities out along both axes.
void make_air(const PlantWinds &along, float drag, int count, float *strengths, float *side) {
	const float over_drag = drag > 0.0f ? 1.0f / drag : 0.0f;
	for (int i = 0; i < count; i++) {
		const float speed = std::sqrt(strengths[i] * over_drag);
		strengths[i] = speed * along.x;
		side[i] = speed * along.z;
	}
}

} // namespace

void PageWind::sample(int begin, int count, BlockWind &block) const {
	const float *root_x = x + begin;
	const float *root_z = z + begin;
	block.is_pressed = false;
	block.has_air = wind.is_air || is_stirred;
	block.has_newtons = !wind.is_air && (has_stems || !is_stirred);
	if (wind.is_air) {
		const float *alone = canopy_height > 0.0f ? nullptr : lengths + begin;
		if (ahead.is_ready()) {
			ahead.interpolate(moments, begin, count, block.x, block.z, level);
			add_gust(wind, moments, root_x, root_z, count, block.x, block.z, level);
		} else {
			sample_air(wind, moments, root_x, root_z, alone, count, block.x, block.z, level);
		}
	} else {
		wind_kernels(level).sample(wind, root_x, root_z, count, block.strengths);
	}
	if (!is_stirred) {
		return;
	}
	if (block.has_newtons) {
		std::fill(block.x, block.x + count, 0.0f);
		std::fill(block.z, block.z + count, 0.0f);
	} else if (!wind.is_air) {
		std::copy(block.strengths, block.strengths + count, block.x);
		make_air(along, drag, count, block.x, block.z);
	}
	std::fill(block.y, block.y + count, 0.0f);
	add_sources(wind.sources, low, high, root_x, y + begin, root_z, lengths + begin, count, block.x, block.y, block.z);
	block.is_pressed = std::any_of(block.y, block.y + count, [](float up) { return up != 0.0f; });
	if (is_carried) {
		subtract_drift(begin, count, block);
	}
}

void PageWind::subtract_drift(int begin, int count, BlockWind &block) const {
	const AirSources &axes = wind.sources;
	for (int i = 0; i < count; i++) {
		const int row = begin + i;
		const glm::vec3 own = wind.drift->velocity(row, { x[row], y[row], z[row] });
		block.x[i] -= axes.x_x * own.x + axes.z_x * own.z;
		block.z[i] -= axes.x_z * own.x + axes.z_z * own.z;
	}
}

} // namespace undergrowth
