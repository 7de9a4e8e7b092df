#pragma once

#include <cstddef>
#include <vector>

namespace undergrowth {

class FieldSimulation;

/// Mean lean of the plants of each species in a field: the displacement of their tips from calm air, divided by their
/// height, over all plants and the last seconds. Estimated from a few plants in each step. Not thread-safe.
class MeanLean {
public:
	static constexpr double MEMORY = 8.0; ///< s: time constant of the mean.
	/// Plants per call of follow(): one of PLANTS_PER_SAMPLE, so that many small fields cost as much as a large one.
	static constexpr int PLANTS_PER_SAMPLE = 1024;
	static constexpr int MIN_SAMPLES = 4;
	static constexpr int MAX_SAMPLES = 32;

	/// Measures some plants. Call it between two steps. It does nothing if no time has passed since the last call.
	void follow(const FieldSimulation &simulation);
	/// 0 for unknown species and before the first call.
	float of(int species) const;

private:
	struct Species {
		double mean = 0.0;
		double measured_at = 0.0; ///< s of the simulation's time.
		int calls = 0;
		double sum = 0.0; ///< Of the present call.
		int count = 0;
	};
	std::vector<Species> species;
	double last_time = -1.0; ///< s.
	std::size_t page = 0;
	unsigned turn = 0;
};

} // namespace undergrowth
