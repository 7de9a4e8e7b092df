#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace undergrowth {

/// A number from a user, and its valid range.
struct Limit {
	const char *name;
	double value;
	double min;
	double max;
};

/// Error and remedy for the first number that is not finite or out of range; empty if all are valid.
inline std::string find_limit_fault(const std::vector<Limit> &limits) {
	for (const Limit &limit : limits) {
		if (!std::isfinite(limit.value) || limit.value < limit.min || limit.value > limit.max) {
			char text[160];
			std::snprintf(text, sizeof(text), "%s cannot be %g. Use %g to %g.", limit.name, limit.value, limit.min,
					limit.max);
			return text;
		}
	}
	return {};
}

} // namespace undergrowth
