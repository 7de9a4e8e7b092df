// Converts many colours of light at once. A kernel file, because only there compilers vectorize roots.

#include "mesh/silhouette.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr int LANES = 16;
constexpr int STEPS = 4; // Steps of Newton's method.

void from_lanes(float *lights) {
	float component[LANES];
	for (int k = 0; k < LANES; k++) {
		component[k] = std::sqrt(std::max(lights[k], 0.0f));
	}
	for (int step = 0; step < STEPS; step++) {
		for (int k = 0; k < LANES; k++) {
			const float c = component[k];
			const float slope = c * (c * 0.915918033f + 1.364342222f) + 0.012522878f;
			component[k] = std::max(c - (to_light(c) - lights[k]) / slope, 0.0f);
		}
	}
	std::copy(component, component + LANES, lights);
}

} // namespace

float from_light(float light) {
	from_light(&light, 1);
	return light;
}

void from_light(float *lights, int count) {
	int done = 0;
	for (; done + LANES <= count; done += LANES) {
		from_lanes(lights + done);
	}
	float last[LANES] = {};
	std::copy(lights + done, lights + count, last);
	from_lanes(last);
	std::copy(last, last + count - done, lights + done);
}

} // namespace undergrowth
