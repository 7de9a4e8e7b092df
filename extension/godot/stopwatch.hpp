#pragma once

#include <chrono>

namespace undergrowth {

/// Runs from when it is made.
class Stopwatch {
	std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();

public:
	/// µs.
	double usec() const {
		return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
	}
};

} // namespace undergrowth
