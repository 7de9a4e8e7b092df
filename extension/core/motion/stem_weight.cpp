#include "motion/stem_weight.hpp"

#include <cmath>

namespace undergrowth {

namespace {

constexpr float MAX_HALF_ANGLE = 1.0f; // rad, of a bend by weight.
constexpr float MIN_SQUARE = 1e-12f;
constexpr float UNEVEN = 0.15f; // rad.
// Periods per metre, so different that neighbours lean in different directions.
constexpr float PERIODS[2][2] = { { 7.31f, 3.77f }, { -4.19f, 8.63f } };

/// From -1 to 1 by the place, 0 at the origin; like a triangle wave.
float unevenness(float x, float z, const float (&periods)[2]) {
	const float at = periods[0] * x + periods[1] * z + 0.25f;
	const float part = at - static_cast<float>(static_cast<int>(at)); // Vectorised, other than a floor.
	const float share = part < 0.0f ? part + 1.0f : part;
	return 1.0f - 4.0f * std::fabs(share - 0.5f);
}

} // namespace

void weigh_stems(const StemPage &page, const float *root_x, const float *root_z, int count, const StemWeight &weight,
		float *x, float *z) {
	const float of_place = weight.along * page.step.dead_tip.of_place;
	const float of_rate = weight.along * page.step.dead_tip.of_rate;
	for (int i = 0; i < count; i++) {
		// The direction of a place about halfway, and the vertical, both as unit vectors in the frame of the rest.
		const float bend_x = of_place * page.x[0][i] + of_rate * page.rate_x[0][i];
		const float bend_z = of_place * page.z[0][i] + of_rate * page.rate_z[0][i];
		const float over = 1.0f / (1.0f + bend_x * bend_x + bend_z * bend_z);
		const float rest_x = page.rest_x[i];
		const float rest_z = page.rest_z[i];
		const float under = 1.0f / (1.0f + rest_x * rest_x + rest_z * rest_z);
		const float up_x = -2.0f * rest_x * under - UNEVEN * unevenness(root_x[i], root_z[i], PERIODS[0]);
		const float up_z = -2.0f * rest_z * under - UNEVEN * unevenness(root_x[i], root_z[i], PERIODS[1]);
		const float up_y = 2.0f * under - 1.0f;
		const float half = bend_x * up_x + bend_z * up_z + up_y; // Of the vertical along the axis, plus a constant.
		// The vertical across that direction, turned about it into the plane of bends.
		const float across_x = 2.0f * over * bend_x * half - up_x;
		const float across_z = 2.0f * over * bend_z * half - up_z;
		const float cosine = 2.0f * over * half - up_y;
		const float square = across_x * across_x + across_z * across_z;
		const float beyond = cosine < 0.0f ? 1.0f / std::sqrt(square > MIN_SQUARE ? square : MIN_SQUARE) : 1.0f;
		const float ease = page.air_ease ? page.air_ease[i] : 1.0f;
		const float slope = 0.5f * weight.slope * page.scale[i] * ease * beyond;
		const float angle = slope * slope * square;
		const float max = angle > MAX_HALF_ANGLE ? 1.0f / std::sqrt(angle) : 1.0f;
		const float bounded = angle * max * max;
		const float tangent = slope * max / (1.0f - bounded * (1.0f / 3.0f)); // Of half the angle, to 4 %.
		x[i] = across_x * tangent;
		z[i] = across_z * tangent;
	}
}

} // namespace undergrowth
