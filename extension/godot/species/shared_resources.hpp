#pragma once

#include <godot_cpp/classes/shader.hpp>
#include <godot_cpp/classes/shader_material.hpp>
#include <godot_cpp/classes/skin.hpp>
#include <godot_cpp/classes/standard_material3d.hpp>

namespace undergrowth {

/// Returns the material of plants without one: vertex colors, Lambert light and some light through the leaf (thesis,
/// section 2.4). All plants share it. Created at first use.
godot::Ref<godot::StandardMaterial3D> default_material();

/// Returns the material of plants of parts without one: open sheets, lit from both sides and from behind, dark at their
/// base. Uses the shader of fields with such plants. Any thread. If a worker thread creates it, it has no shader before
/// the end of the frame.
godot::Ref<godot::ShaderMaterial> parts_material();

/// Sets the shader of parts_material(). The simulation calls it at the end of a frame, after a request of a worker
/// thread.
void load_parts_shader();

/// Returns the add-on's shader of plants of parts or of other plants. It stays loaded after its first use. So a
/// new material after the last one was freed does not read and compile it again.
godot::Ref<godot::Shader> plant_shader(bool of_parts);

/// Loads one of the shaders of a field's plants that is not loaded yet, which takes about 20 ms. False if there is
/// none.
bool load_next_field_shader(bool of_parts, bool with_cards, bool with_orders);

/// Returns the add-on's shader of levels of a field without cards. Stays loaded as plant_shader() does.
godot::Ref<godot::Shader> solids_shader();
/// Returns the add-on's shader of plants of parts with cards. Stays loaded as plant_shader() does.
godot::Ref<godot::Shader> cards_shader();
/// Returns the add-on's shader of plants of parts that only cast shadows. Stays loaded as plant_shader() does.
godot::Ref<godot::Shader> shadows_shader();
/// Returns the add-on's shader of levels without cards of plants with branched branches. Stays loaded as plant_shader()
/// does.
godot::Ref<godot::Shader> orders_shader();
/// The same for levels with cards.
godot::Ref<godot::Shader> orders_with_cards_shader();
/// Returns the add-on's shader of the leaves of climbers. Stays loaded as plant_shader() does.
godot::Ref<godot::Shader> climber_shader();

/// Returns the skin of the two bones, root and tip. All plants share it.
godot::Ref<godot::Skin> plant_skin();

/// Frees these resources. The library calls it before it is unloaded.
void free_shared_resources();

} // namespace undergrowth
