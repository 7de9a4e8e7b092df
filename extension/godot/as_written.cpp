#include "as_written.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace undergrowth {

static constexpr int FEWEST_DIGITS = 6; // All decimals of six digits survive a float,
static constexpr int MOST_DIGITS = 9; // and all floats survive nine.

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

} // namespace undergrowth
