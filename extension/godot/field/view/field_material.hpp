#pragma once

#include "motion/motion_species.hpp"

#include <godot_cpp/classes/material.hpp>
#include <godot_cpp/classes/shader_material.hpp>

namespace undergrowth {

// Materials of a field's plants, made from the material of a species. Main thread.

/// What a material of plants of parts draws.
enum class DrawnParts {
	solid,
	orders, ///< Solid, with a swing of each order of branches.
	with_cards,
	orders_with_cards,
	shadows,
};

/// Returns a new material that bends plants. A ShaderMaterial as `source` is copied. A BaseMaterial3D gives a material
/// with the add-on's shader and the source's colours, textures and roughness; null gives that shader with its defaults.
/// `of_parts`: uses the shader for plants of parts, in the version for what it draws. `is_packed`: its meshes have
/// packed vertices.
godot::Ref<godot::ShaderMaterial> make_field_material(
		const godot::Ref<godot::Material> &source, bool of_parts, DrawnParts drawn, bool is_packed);

/// Copies the parameters of `source` to `made` after the user changed them: colours, textures and roughness of a
/// BaseMaterial3D, or all shader parameters of a ShaderMaterial.
void follow_material(const godot::Ref<godot::Material> &source, const godot::Ref<godot::ShaderMaterial> &made,
		DrawnParts drawn, bool is_packed);

/// Sets a shader if it differs.
void set_shader(const godot::Ref<godot::ShaderMaterial> &material, const godot::Ref<godot::Shader> &shader);
/// Sets the shader of `made` and copies its parameters from `source`, except those that the field sets.
void take_over(const godot::Ref<godot::ShaderMaterial> &source, const godot::Ref<godot::Shader> &shader,
		const godot::Ref<godot::ShaderMaterial> &made);
/// Sets a shader parameter if its value differs, because writing a parameter costs more than reading it.
void set_parameter(
		const godot::Ref<godot::ShaderMaterial> &material, const godot::StringName &name, const godot::Variant &value);

/// Sets the shape of the stems of a species (undergrowth_stem.gdshaderinc).
void set_stem_parameters(const godot::Ref<godot::ShaderMaterial> &material, const MotionSpecies &species);

/// True if a field can draw cards with a function's material: none, one with the add-on's shader of plants of parts, or
/// one whose shader includes undergrowth_card.gdshaderinc.
bool draws_cards(const godot::Ref<godot::Material> &source);

/// True if a field's material made of this one reads packed vertices (mesh/packed_vertex.hpp): with the add-on's shader
/// of plants of parts, or with a shader that defines UNDERGROWTH_PACKED.
bool reads_packed_vertices(const godot::Ref<godot::Material> &source);

/// True if the material's shader includes undergrowth_bend.gdshaderinc, without which plants do not move.
bool bends_in_shader(const godot::Ref<godot::ShaderMaterial> &material);

} // namespace undergrowth
