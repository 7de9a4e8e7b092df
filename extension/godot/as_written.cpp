#include "as_written.hpp"

#include "conventions.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace undergrowth {

static constexpr int FEWEST_DIGITS = 6; // All decimals of six digits survive a float,
static constexpr int MOST_DIGITS = 9; // and all floats survive nine.
static constexpr double LOST_BY_FILES = 1e-14; // Of a number: a resource's text has 16 digits.

double as_written(float value) {
	if (!std::isfinite(value)) {
		return value;
	}
	char text[32];
	for (int digits = FEWEST_DIGITS; digits < MOST_DIGITS; digits++) {
		std::snprintf(text, sizeof(text), "%.*g", digits, double(value));
		if (std::strtof(text, nullptr) == value) {
			return std::strtod(text, nullptr);
		}
	}
	return value;
}

double angle_as_written(double radians) {
	// As the engine's deg_to_rad() multiplies.
	const double written = as_written(float(radians * (180.0 / PI))) * (PI / 180.0);
	return std::fabs(written - radians) <= LOST_BY_FILES * std::fabs(radians) ? written : radians;
}

} // namespace undergrowth
