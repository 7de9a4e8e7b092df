#include "field/speed_counts.hpp"

#include <cstddef>

namespace undergrowth {

namespace {

constexpr float STEP = 1.41421356f;

} // namespace

void SpeedCounts::add(float speed) {
	std::size_t number = 0;
	for (float bound = LEAST * STEP; number + 1 < counts.size() && speed >= bound; bound *= STEP) {
		number++;
	}
	counts[number]++;
}

void SpeedCounts::choose(int room) {
	std::size_t number = counts.size() - 1;
	for (int all = counts[number]; number > 0 && all + counts[number - 1] <= room; number--) {
		all += counts[number - 1];
	}
	least = LEAST;
	for (; number > 0; number--) {
		least *= STEP;
	}
}

} // namespace undergrowth
