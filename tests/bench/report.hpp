#pragma once

#include "base/simd.hpp"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

/// What all measurements of the core share: the clock and the rows.
namespace undergrowth {

inline constexpr int RUNS = 101;
inline constexpr int FEW_RUNS = 31;
inline constexpr int PLANTS_PER_RUN = 200000; // At least, so that the clock's own time does not count.

/// The median time of `runs` runs (ms), after some that warm up.
template <class Work> double median_ms(const Work &work, int runs = RUNS) {
	constexpr int WARM_UP = 3;
	std::vector<double> times;
	for (int i = -WARM_UP; i < runs; i++) {
		const auto start = std::chrono::steady_clock::now();
		work();
		const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
		if (i >= 0) {
			times.push_back(spent.count());
		}
	}
	std::nth_element(times.begin(), times.begin() + runs / 2, times.end());
	return times[static_cast<std::size_t>(runs / 2)];
}

/// All rows, with commas between them.
class Report {
public:
	/// `more`: further members, each with a comma before it.
	void row(const char *name, int plants, int threads, double milliseconds, SimdLevel level,
			const std::string &more = "") {
		std::printf("%s  {\"name\": \"%s\", \"plants\": %d, \"threads\": %d, \"median_ms\": %.6f, "
					"\"us_per_plant\": %.6f, \"level\": \"%s\"%s}",
				started ? ",\n" : "[\n", name, plants, threads, milliseconds, 1000.0 * milliseconds / plants,
				level == SimdLevel::avx2 ? "avx2" : "baseline", more.c_str());
		started = true;
	}
	void end() const { std::printf("\n]\n"); }

private:
	bool started = false;
};

inline std::string member(const char *name, double value) {
	char text[80];
	std::snprintf(text, sizeof text, ", \"%s\": %.4f", name, value);
	return text;
}

// Each prints its rows.
void time_air(Report &report);
void time_kernels(Report &report);
void time_fields(Report &report);
void time_meshes(Report &report);

} // namespace undergrowth
