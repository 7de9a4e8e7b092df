#include "plant/base_shape.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"

#include <algorithm>

namespace undergrowth {

namespace {

glm::vec2 polar_point(double angle, double radius) {
	return { static_cast<float>(-portable_cos(angle) * radius), static_cast<float>(portable_sin(angle) * radius) };
}

} // namespace

std::vector<glm::vec2> circle_ring(int lod, double radius) {
	return lobed_ring(lod, radius, 1, 0.0);
}

std::vector<glm::vec2> parallelogram_ring(float width, float depth, float skew) {
	const float near_x = -0.5f * skew;
	const float far_x = 0.5f * skew;
	const float half = 0.5f * width;
	return { { near_x - half, 0.5f * depth }, { near_x + half, 0.5f * depth }, { far_x + half, -0.5f * depth },
		{ far_x - half, -0.5f * depth } };
}

std::vector<glm::vec2> lobed_ring(int lod, double radius, int lobes, double bulge) {
	// A whole number of points per half lobe puts a point at each crest and in each notch.
	const int half_lobes = bulge == 0.0 ? 1 : 2 * lobes;
	const int min = bulge == 0.0 ? 4 : 2 * half_lobes;
	const int wanted = std::clamp(lod, min, MAX_RING_POINTS - half_lobes + 1);
	const int count = (wanted + half_lobes - 1) / half_lobes * half_lobes;

	std::vector<glm::vec2> points;
	points.reserve(count);
	for (int i = 0; i < count; i++) {
		const double angle = static_cast<double>(i) / count * 2.0 * PI;
		points.push_back(polar_point(angle, radius * (1.0 + bulge * portable_cos(lobes * angle))));
	}
	return points;
}

} // namespace undergrowth
