#pragma once

#include <godot_cpp/classes/material.hpp>
#include <godot_cpp/classes/shader_material.hpp>

namespace undergrowth {

/// Creates a bending material from a function's material. A ShaderMaterial is copied. A BaseMaterial3D, or none, gives
/// the add-on's own shader, with colours, textures and shine of the BaseMaterial3D. `of_parts`: uses the shader for
/// plants of parts, or for those with cards.
godot::Ref<godot::ShaderMaterial> make_field_material(
		const godot::Ref<godot::Material> &source, bool of_parts, bool has_cards = false);

/// Copies the user's changes of `source` to `made`: colours, textures and shine, or the parameters of a shader.
void follow_material(
		const godot::Ref<godot::Material> &source, const godot::Ref<godot::ShaderMaterial> &made, bool has_cards);

/// Sets a parameter if its value differs: setting one costs more than reading it.
void set_parameter(
		const godot::Ref<godot::ShaderMaterial> &material, const godot::StringName &name, const godot::Variant &value);

/// True if a field can draw cards with a function's material: none, one with the add-on's shader of plants of parts, or
/// one whose shader includes undergrowth_card.gdshaderinc. Main thread.
bool draws_cards(const godot::Ref<godot::Material> &source);

/// True if its shader includes undergrowth_bend.gdshaderinc.
bool bends_in_shader(const godot::Ref<godot::ShaderMaterial> &material);

} // namespace undergrowth
