#include "base/shortest_decimal.hpp"

#include "conventions.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace undergrowth {

static constexpr int FEWEST_DIGITS = 6; // A float preserves all decimals of six digits,
static constexpr int MAX_DIGITS = 9; // and nine digits preserve all floats.
static constexpr double LOST_BY_FILES = 1e-14; // Relative error: a resource file stores 16 digits.

double shortest_decimal(float value) {
	if (!std::isfinite(value)) {
		return value;
	}
	char text[32];
	for (int digits = FEWEST_DIGITS; digits < MAX_DIGITS; digits++) {
		std::snprintf(text, sizeof(text), "%.*g", digits, double(value));
		if (std::strtof(text, nullptr) == value) {
			return std::strtod(text, nullptr);
		}
	}
	return value;
}

double exact_angle(double radians) {
	// The same product as in the engine's deg_to_rad().
	const double written = shortest_decimal(float(radians * (180.0 / PI))) * (PI / 180.0);
	return std::fabs(written - radians) <= LOST_BY_FILES * std::fabs(radians) ? written : radians;
}

} // namespace undergrowth
