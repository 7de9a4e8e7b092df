#pragma once

#include "stand/plants.hpp"

#include <glm/vec3.hpp>

namespace undergrowth {

/// The plant that a transform stands for: at `root` (m), with `up` (its y axis) along the stem and as long as its
/// scale, and turned so that +z goes towards `front`. A tilt becomes a lean to that side. Not valid where a number is
/// not finite or `up` is of no length.
PlacedPlant plant_of_axes(const glm::vec3 &root, const glm::vec3 &up, const glm::vec3 &front);

/// Where plants of a species point in calm air (unit, field axes): `species_lean` (rad) towards their own +z, and from
/// there as they were placed. Never more than 1.4 rad from upright, since the spring law rests above the ground.
class RestDirections {
public:
	explicit RestDirections(float species_lean);
	glm::vec3 of(const PlacedPlant &plant) const;

private:
	glm::dvec3 own; ///< Of a plant that was placed upright and not turned.
};

/// Of one plant.
glm::vec3 rest_direction(const PlacedPlant &plant, float species_lean);

} // namespace undergrowth
