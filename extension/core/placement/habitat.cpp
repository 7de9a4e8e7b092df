#include "placement/habitat.hpp"

#include <algorithm>

namespace undergrowth {

double Habitat::suitability(const HabitatPlace &place) const {
	double product = 1.0;
	for (std::size_t i = 0; i < HABITAT_FACTORS; i++) {
		const bool is_value = i == static_cast<std::size_t>(HabitatFactor::value);
		const float own = is_value ? place.factors[i] : curves[i].at(place.factors[i]);
		product *= curves[i].is_set() ? static_cast<double>(own) : 1.0;
	}
	return std::clamp(product, 0.0, 1.0);
}

} // namespace undergrowth
