#include "placement/habitat.hpp"

#include <algorithm>

namespace undergrowth {

double Habitat::suitability(const HabitatPlace &place) const {
	double product = 1.0;
	for (std::size_t i = 0; i < HABITAT_FACTORS; i++) {
		product *= curves[i].is_set() ? static_cast<double>(curves[i].at(place.factors[i])) : 1.0;
	}
	return std::clamp(product, 0.0, 1.0);
}

} // namespace undergrowth
