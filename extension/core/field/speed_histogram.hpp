#pragma once

#include <array>

namespace undergrowth {

/// Histogram of source speeds at plants; finds the strongest without sorting.
class SpeedHistogram {
public:
	/// m/s: minimum speed; less is not visible.
	static constexpr float MIN_SPEED = 0.5f;

	/// Clears the counts; chosen() does not change.
	void clear() { counts.fill(0); }
	/// Adds a plant with a source speed of `speed` (m/s), at least MIN_SPEED.
	void add(float speed);
	/// Chooses the threshold for the strongest, at most `room` of them unless the fastest class alone has more.
	void choose(int room);
	/// m/s: plants with at least this speed were chosen.
	float chosen() const { return threshold; }

private:
	static constexpr int CLASSES = 16; ///< Each class is faster by √2, up to 90 m/s.

	std::array<int, CLASSES> counts = {};
	float threshold = MIN_SPEED;
};

} // namespace undergrowth
