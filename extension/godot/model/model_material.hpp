#pragma once

#include <godot_cpp/classes/material.hpp>
#include <godot_cpp/classes/shader.hpp>
#include <godot_cpp/classes/shader_material.hpp>

namespace undergrowth {

// Materials of a field's models: those of the file, with the bend added. Main thread.

/// Returns a new material that looks like `source` and bends. A ShaderMaterial gets its own shader with
/// UNDERGROWTH_BEND at the start of vertex(), if it has none. A BaseMaterial3D gets undergrowth_model.gdshaderinc.
/// Null: white.
godot::Ref<godot::ShaderMaterial> make_model_material(const godot::Ref<godot::Material> &source);

/// Returns the shader of such a material, shared by all that have the same code.
godot::Ref<godot::Shader> model_shader(const godot::Ref<godot::Material> &source);
/// Copies the user's changes of `source` to `made`. `shader`: model_shader(source).
void follow_model_material(const godot::Ref<godot::Material> &source, const godot::Ref<godot::Shader> &shader,
		const godot::Ref<godot::ShaderMaterial> &made);

/// Frees the shaders that all models share. When the library ends.
void free_model_shaders();

} // namespace undergrowth
