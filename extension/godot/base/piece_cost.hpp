#pragma once

#include <algorithm>

namespace undergrowth {

/// Expected main-thread time of a piece of work, from the times of earlier pieces.
class PieceCost {
public:
	/// Returns µs for a piece of `plants` plants; 0 before the first call of note().
	double expected_usec(int plants) const { return usec_per_plant * units(plants); }
	/// Adds the time of a piece that ended.
	void note(int plants, double usec) {
		static constexpr double WEIGHT = 0.2;
		static constexpr double MAX_RATIO = 4.0; // To the mean: other programs may have had the processor.
		const double own = usec / units(plants);
		const double limited = usec_per_plant > 0.0 ? std::min(own, MAX_RATIO * usec_per_plant) : own;
		usec_per_plant += (usec_per_plant > 0.0 ? WEIGHT : 1.0) * (limited - usec_per_plant);
	}

private:
	double usec_per_plant = 0.0;

	// Each piece costs as much as some plants, in addition to its own.
	static double units(int plants) { return 64.0 + plants; }
};

} // namespace undergrowth
