#pragma once

#include "form/growth.hpp"

/// Six plants of parts for tests: a tuft of grass, a tulip, a daisy, a fern, a cereal and a shrub, grown as by a
/// script.

inline constexpr float DEGREE = 0.01745329f;

undergrowth::PlantForm grow_grass(uint64_t seed);
undergrowth::PlantForm grow_tulip(uint64_t seed);
undergrowth::PlantForm grow_daisy(uint64_t seed);
undergrowth::PlantForm grow_fern(uint64_t seed);
undergrowth::PlantForm grow_cereal(uint64_t seed);
/// With branches of branches: two stems, branches, twigs on these, and leaves on both.
undergrowth::PlantForm grow_shrub(uint64_t seed);

/// A form with a single upright part on the ground.
undergrowth::PlantForm grow_alone(const undergrowth::Part &part, uint64_t seed = 1);
