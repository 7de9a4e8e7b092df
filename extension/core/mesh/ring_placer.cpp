#include "mesh/ring_placer.hpp"

#include <algorithm>
#include <limits>

namespace undergrowth {

RingPlacer::RingPlacer(const PlantSample &p_sample, const MeshOptions &options) :
		sample(p_sample),
		count(static_cast<int>(p_sample.cross_section->points.size())),
		bends(options.shape_deviation > 0.0f),
		tints(options.color_deviation > 0.0f),
		deviation(options.shape_deviation, options.color_deviation, options.seed) {
	if (bends || tints) {
		const glm::vec2 *ring = sample.cross_section->points.data();
		std::transform(ring, ring + count, bearings, make_bearing);
	}
}

float RingPlacer::level_height(int level) const {
	return static_cast<float>(static_cast<double>(sample.height) * level / sample.lod);
}

float RingPlacer::rise_between(int below, int above) const {
	return std::max(level_height(above) - level_height(below), std::numeric_limits<float>::min());
}

float RingPlacer::width_slope(int level) const {
	const int below = std::max(level - 1, 0);
	const int above = std::min(level + 1, sample.lod);
	return (sample.widths[above] - sample.widths[below]) / rise_between(below, above);
}

Deviation::Ring RingPlacer::ring_deviation(int level) const {
	return deviation.at(static_cast<float>(level) / static_cast<float>(sample.lod));
}

void RingPlacer::place(int level, glm::vec3 *out) const {
	const glm::vec2 *__restrict ring = sample.cross_section->points.data();
	const float width = sample.widths[level];
	const float y = level_height(level);
	if (!bends) {
		for (int i = 0; i < count; i++) {
			out[i] = { ring[i].x * width, y, ring[i].y * width };
		}
		return;
	}
	const Deviation::Ring change = ring_deviation(level);
	const glm::vec2 center = change.center * sample.height;
	for (int i = 0; i < count; i++) {
		const float factor = width * change.stretch(bearings[i]);
		out[i] = { center.x + ring[i].x * factor, y, center.y + ring[i].y * factor };
	}
}

void RingPlacer::paint(int level, glm::vec4 *out) const {
	const glm::vec4 color = sample.colors[level];
	if (!tints) {
		std::fill_n(out, count, color);
		return;
	}
	const Deviation::Ring change = ring_deviation(level);
	for (int i = 0; i < count; i++) {
		out[i] = change.tint(color, bearings[i]);
	}
}

void RingPlacer::level_normals(int level, glm::vec2 *out) const {
	const CrossSection &section = *sample.cross_section;
	if (!bends) {
		std::copy_n(section.normals.data(), count, out);
		return;
	}
	const Deviation::Ring change = ring_deviation(level);
	glm::vec2 stretched[MAX_RING_POINTS];
	for (int i = 0; i < count; i++) {
		stretched[i] = section.points[i] * change.stretch(bearings[i]);
	}
	ring_normals(stretched, count, out);
}

} // namespace undergrowth
