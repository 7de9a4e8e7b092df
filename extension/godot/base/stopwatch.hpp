#pragma once

#include <chrono>

namespace undergrowth {

/// Measures the time since its construction.
class Stopwatch {
	std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();

public:
	/// Returns µs.
	double usec() const {
		return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
	}
};

} // namespace undergrowth
