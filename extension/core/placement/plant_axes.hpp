#pragma once

#include "placement/plants.hpp"

#include <glm/vec3.hpp>

namespace undergrowth {

/// Converts a transform to a plant at `root` (m): `up` (its y axis) is along the stem and has the length of the scale;
/// `front` is the direction of +z. A tilt becomes a lean to that side. The plant is invalid if a number is not finite
/// or `up` has no length.
PlacedPlant plant_of_axes(const glm::vec3 &root, const glm::vec3 &up, const glm::vec3 &front);

/// Rest directions of plants (unit, field axes): `species_lean` (rad) towards their own +z, then the placed lean. At
/// most 1.4 rad from upright, since the spring law rests above the ground.
class RestDirections {
public:
	explicit RestDirections(float species_lean);
	glm::vec3 of(const PlacedPlant &plant) const;

private:
	glm::dvec3 own; ///< Of a plant that was placed upright without a turn.
};

/// The same for one plant.
glm::vec3 rest_direction(const PlacedPlant &plant, float species_lean);

} // namespace undergrowth
