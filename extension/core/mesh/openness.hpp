#pragma once

#include "form/plant_form.hpp"

namespace undergrowth {

/// Visible fraction of the sky at points in and on a plant.
class Openness {
public:
	explicit Openness(const PlantForm &form);

	/// 0 to 1: less at the base and inside a tuft.
	float at(const glm::vec3 &point) const;

private:
	static constexpr int HEIGHTS = 32;

	float light[HEIGHTS + 2]; ///< Light at each height of the plant.
	float height; ///< m.
	float reach; ///< m.
};

} // namespace undergrowth
