#pragma once

#include <godot_cpp/classes/material.hpp>
#include <godot_cpp/classes/shader_material.hpp>

namespace undergrowth {

/// A material that bends, made from what a function wears: the add-on's own shader where it has none or a
/// BaseMaterial3D, whose colours, textures and shine it takes over; a copy of a ShaderMaterial. `of_parts`: plants are
/// of parts, so the shader is theirs.
godot::Ref<godot::ShaderMaterial> make_field_material(const godot::Ref<godot::Material> &worn, bool of_parts);

/// Brings into `made` what its user changed in `worn` since: colours, textures and shine, or the parameters of a
/// shader.
void follow_material(const godot::Ref<godot::Material> &worn, const godot::Ref<godot::ShaderMaterial> &made);

/// Sets a parameter unless it is that already: one that is set anew costs more than one that is asked for.
void set_parameter(
		const godot::Ref<godot::ShaderMaterial> &material, const godot::StringName &name, const godot::Variant &value);

/// Whether its shader includes undergrowth_bend.gdshaderinc.
bool bends_in_shader(const godot::Ref<godot::ShaderMaterial> &material);

} // namespace undergrowth
