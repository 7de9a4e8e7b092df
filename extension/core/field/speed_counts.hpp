#pragma once

#include <array>

namespace undergrowth {

/// How many plants are stirred how strongly, so that the strongest are known without sorting.
class SpeedCounts {
public:
	/// m/s: what less than that adds to a plant's wind, nobody sees.
	static constexpr float LEAST = 0.5f;

	/// Forgets who was added, not what was chosen.
	void clear() { counts.fill(0); }
	/// A plant at which sources move the air by `speed` (m/s), LEAST or more.
	void add(float speed);
	/// Chooses the strongest, at most `room` of them, where the fastest class alone is not more.
	void choose(int room);
	/// m/s: who is stirred so fast was chosen.
	float chosen() const { return least; }

private:
	static constexpr int CLASSES = 16; ///< From each to the next a factor of √2: to 90 m/s.

	std::array<int, CLASSES> counts = {};
	float least = LEAST;
};

} // namespace undergrowth
