#include "field/speed_histogram.hpp"

#include <cstddef>

namespace undergrowth {

namespace {

constexpr float STEP = 1.41421356f;

} // namespace

void SpeedHistogram::add(float speed) {
	std::size_t number = 0;
	for (float bound = MIN_SPEED * STEP; number + 1 < counts.size() && speed >= bound; bound *= STEP) {
		number++;
	}
	counts[number]++;
}

void SpeedHistogram::choose(int room) {
	std::size_t number = counts.size() - 1;
	for (int all = counts[number]; number > 0 && all + counts[number - 1] <= room; number--) {
		all += counts[number - 1];
	}
	threshold = MIN_SPEED;
	for (; number > 0; number--) {
		threshold *= STEP;
	}
}

} // namespace undergrowth
