#include "field/field_material.hpp"

#include "new_object.hpp"

#include <godot_cpp/classes/base_material3d.hpp>
#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/classes/shader.hpp>
#include <godot_cpp/classes/texture2d.hpp>

using namespace godot;

namespace undergrowth {

static const char *const SHADER_PATH = "res://addons/undergrowth/shaders/plant_field.gdshader";
static const char *const INCLUDE_NAME = "undergrowth_bend.gdshaderinc";

static void take_over(const Ref<BaseMaterial3D> &worn, const Ref<ShaderMaterial> &made) {
	made->set_shader_parameter("albedo", worn->get_albedo());
	made->set_shader_parameter("albedo_texture", worn->get_texture(BaseMaterial3D::TEXTURE_ALBEDO));
	made->set_shader_parameter("vertex_colors", worn->get_flag(BaseMaterial3D::FLAG_ALBEDO_FROM_VERTEX_COLOR));
	made->set_shader_parameter("vertex_colors_are_srgb", worn->get_flag(BaseMaterial3D::FLAG_SRGB_VERTEX_COLOR));
	made->set_shader_parameter("roughness", worn->get_roughness());
	made->set_shader_parameter("metallic", worn->get_metallic());
	made->set_shader_parameter("specular", worn->get_specular());
	const bool has_backlight = worn->get_feature(BaseMaterial3D::FEATURE_BACKLIGHT);
	made->set_shader_parameter("backlight", has_backlight ? worn->get_backlight() : Color(0.0f, 0.0f, 0.0f));
}

Ref<ShaderMaterial> make_field_material(const Ref<Material> &worn) {
	const Ref<ShaderMaterial> own = worn;
	if (own.is_valid()) {
		return own->duplicate();
	}
	Ref<ShaderMaterial> made = new_counted<ShaderMaterial>();
	made->set_shader(ResourceLoader::get_singleton()->load(SHADER_PATH, "Shader"));
	const Ref<BaseMaterial3D> plain = worn;
	if (plain.is_valid()) {
		take_over(plain, made);
	}
	return made;
}

bool bends_in_shader(const Ref<ShaderMaterial> &material) {
	const Ref<Shader> shader = material->get_shader();
	return shader.is_valid() && shader->get_code().contains(INCLUDE_NAME);
}

} // namespace undergrowth
