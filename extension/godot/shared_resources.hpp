#pragma once

#include <godot_cpp/classes/shader.hpp>
#include <godot_cpp/classes/shader_material.hpp>
#include <godot_cpp/classes/skin.hpp>
#include <godot_cpp/classes/standard_material3d.hpp>

namespace undergrowth {

/// What plants wear that have no material of their own: vertex colours, Lambert light, a little light through the
/// leaf (thesis, section 2.4). One for all plants; made at first use.
godot::Ref<godot::StandardMaterial3D> default_material();

/// The same for plants of parts: open sheets, lit from both sides and from behind, dark at their base. Made of the
/// shader that fields of such plants wear. On any thread: the first one that another thread than the main one takes
/// has no shader before the end of the frame.
godot::Ref<godot::ShaderMaterial> parts_material();

/// Gives parts_material() its shader. The simulation calls it at the end of a frame, for threads.
void load_parts_shader();

/// The add-on's shaders of plants of parts and of others, kept from their first use on: whoever lets the last material
/// of one go and makes another would read, and compile, it anew.
godot::Ref<godot::Shader> plant_shader(bool of_parts);

/// The binding of the two bones, root and tip, that all plants share.
godot::Ref<godot::Skin> plant_skin();

/// Lets them go. The library calls it before it is unloaded.
void free_shared_resources();

} // namespace undergrowth
