#pragma once

#include "form/grown_plant.hpp"
#include "sampled_plant.hpp"

namespace undergrowth {

/// The arrays of a plant of parts at the level, the height and with the options that were sampled, in the format of
/// mesh/vertex_format.hpp. `from_above`: as SampledPlant::build_arrays().
MeshArrays build_form_arrays(const GrownPlant &grown, const SampledPlant &sampled, godot::Vector2 *from_above);

} // namespace undergrowth
