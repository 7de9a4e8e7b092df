#pragma once

#include "form/grown_plant.hpp"
#include "species/sampled_plant.hpp"

namespace undergrowth {

/// Builds the arrays of a plant of parts at the sampled level and height and with the sampled options. The format is
/// that of mesh/vertex_format.hpp. `from_above`: as SampledPlant::build_arrays().
MeshArrays build_form_arrays(const GrownPlant &grown, const SampledPlant &sampled, godot::Vector2 *from_above);

} // namespace undergrowth
