#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace undergrowth {

/// A number that an author wrote, and where it may lie.
struct Limit {
	const char *name;
	double value;
	double least;
	double most;
};

/// What is wrong with the first number that is not finite or not within its limits, and what to do; empty where all
/// are sound.
inline std::string find_limit_fault(const std::vector<Limit> &limits) {
	for (const Limit &limit : limits) {
		if (!std::isfinite(limit.value) || limit.value < limit.least || limit.value > limit.most) {
			char text[160];
			std::snprintf(text, sizeof(text), "%s cannot be %g. Use %g to %g.", limit.name, limit.value, limit.least,
					limit.most);
			return text;
		}
	}
	return {};
}

} // namespace undergrowth
