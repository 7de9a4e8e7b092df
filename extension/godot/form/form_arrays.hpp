#pragma once

#include "form/grown_plant.hpp"
#include "sampled_plant.hpp"

namespace undergrowth {

/// The engine's mesh of a plant of parts at the level, the height and with the options that were sampled, in the format
/// of mesh/vertex_format.hpp.
godot::Ref<godot::ArrayMesh> build_form_mesh(const GrownPlant &grown, const SampledPlant &sampled);

} // namespace undergrowth
