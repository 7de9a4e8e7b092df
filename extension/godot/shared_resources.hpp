#pragma once

#include <godot_cpp/classes/skin.hpp>
#include <godot_cpp/classes/standard_material3d.hpp>

namespace undergrowth {

/// What plants wear that have no material of their own: vertex colours, Lambert light, a little light through the
/// leaf (thesis, section 2.4). One for all plants; made at first use.
godot::Ref<godot::StandardMaterial3D> default_material();

/// The binding of the two bones, root and tip, that all plants share.
godot::Ref<godot::Skin> plant_skin();

/// Lets both go. The library calls it before it is unloaded.
void free_shared_resources();

} // namespace undergrowth
