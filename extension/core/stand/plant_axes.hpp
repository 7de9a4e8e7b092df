#pragma once

#include "stand/plants.hpp"

#include <glm/vec3.hpp>

namespace undergrowth {

/// The plant that a transform stands for: at `root` (m), with `up` (its y axis) along the stem and as long as its
/// scale, and turned so that +z goes towards `front`. A tilt becomes a lean to that side. Not valid where a number is
/// not finite or `up` is of no length.
PlacedPlant plant_of_axes(const glm::vec3 &root, const glm::vec3 &up, const glm::vec3 &front);

/// Where a plant points in calm air (unit, field axes): `species_lean` (rad) towards its own +z, and from there as it
/// was placed. Never more than 1.4 rad from upright, since the spring law rests above the ground.
glm::vec3 rest_direction(const PlacedPlant &plant, float species_lean);

} // namespace undergrowth
