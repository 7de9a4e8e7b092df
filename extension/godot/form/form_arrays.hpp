#pragma once

#include "form/grown_plant.hpp"
#include "sampled_plant.hpp"

namespace undergrowth {

/// The engine's mesh of a plant of parts at the level, the height and with the options that were sampled, in the format
/// of mesh/vertex_format.hpp.
godot::Ref<godot::ArrayMesh> build_form_mesh(const GrownPlant &grown, const SampledPlant &sampled);
/// The same, and tells what the plant (x) and this mesh of it (y) show from straight above, in shares of what they show
/// from the side.
godot::Ref<godot::ArrayMesh> build_form_mesh(
		const GrownPlant &grown, const SampledPlant &sampled, godot::Vector2 &from_above);

} // namespace undergrowth
