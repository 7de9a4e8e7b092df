#include "model/model_material.hpp"

#include "base/new_object.hpp"
#include "field/view/field_material.hpp"

#include <godot_cpp/classes/base_material3d.hpp>
#include <godot_cpp/classes/shader.hpp>
#include <godot_cpp/classes/standard_material3d.hpp>
#include <godot_cpp/classes/texture2d.hpp>

#include <map>
#include <string>

using namespace godot;

namespace undergrowth {

static const char *const FOLDER = "res://addons/undergrowth/shaders/";

// All shaders by their code. A pointer, because references cannot exist before the engine's interface is loaded.
static std::map<std::string, Ref<Shader>> *shaders = nullptr;

static Ref<Shader> shader_of(const String &code) {
	if (!shaders) {
		shaders = new std::map<std::string, Ref<Shader>>;
	}
	Ref<Shader> &known = (*shaders)[code.utf8().get_data()];
	if (known.is_null()) {
		known = new_counted<Shader>();
		known->set_code(code);
	}
	return known;
}

void free_model_shaders() {
	delete shaders;
	shaders = nullptr;
}

static String include(const char *name) {
	return String("#include \"") + FOLDER + name + "\"\n";
}

static String filter_of(const BaseMaterial3D &from) {
	static const char *const names[] = { "filter_nearest", "filter_linear", "filter_nearest_mipmap",
		"filter_linear_mipmap", "filter_nearest_mipmap_anisotropic", "filter_linear_mipmap_anisotropic" };
	const int filter = int(from.get_texture_filter());
	const bool is_known = filter >= 0 && filter < int(std::size(names));
	const bool repeats = from.get_flag(BaseMaterial3D::FLAG_USE_TEXTURE_REPEAT);
	return String(is_known ? names[filter] : "filter_linear_mipmap") +
			(repeats ? ", repeat_enable" : ", repeat_disable");
}

static String render_modes_of(const BaseMaterial3D &from) {
	static const char *const culls[] = { "cull_back", "cull_front", "cull_disabled" };
	static const char *const diffuses[] = { "diffuse_burley", "diffuse_lambert", "diffuse_lambert_wrap",
		"diffuse_toon" };
	static const char *const speculars[] = { "specular_schlick_ggx", "specular_toon", "specular_disabled" };
	const int cull = int(from.get_cull_mode());
	const int diffuse = int(from.get_diffuse_mode());
	const int specular = int(from.get_specular_mode());
	String modes = String("blend_mix, ") + culls[cull >= 0 && cull < 3 ? cull : 0] + ", " +
			diffuses[diffuse >= 0 && diffuse < 4 ? diffuse : 0] + ", " +
			speculars[specular >= 0 && specular < 3 ? specular : 0];
	const BaseMaterial3D::Transparency transparency = from.get_transparency();
	const bool is_blended = transparency == BaseMaterial3D::TRANSPARENCY_ALPHA ||
			transparency == BaseMaterial3D::TRANSPARENCY_ALPHA_DEPTH_PRE_PASS;
	modes += is_blended ? ", depth_prepass_alpha" : ", depth_draw_opaque";
	modes += from.get_shading_mode() == BaseMaterial3D::SHADING_MODE_UNSHADED ? ", unshaded" : "";
	modes += from.get_flag(BaseMaterial3D::FLAG_DONT_RECEIVE_SHADOWS) ? ", shadows_disabled" : "";
	switch (from.get_alpha_antialiasing()) {
		case BaseMaterial3D::ALPHA_ANTIALIASING_ALPHA_TO_COVERAGE:
			return modes + ", alpha_to_coverage";
		case BaseMaterial3D::ALPHA_ANTIALIASING_ALPHA_TO_COVERAGE_AND_TO_ONE:
			return modes + ", alpha_to_coverage_and_one";
		default:
			return modes;
	}
}

static bool is_orm(const BaseMaterial3D &from) {
	return from.is_class("ORMMaterial3D");
}

// The features that the material uses, one definition each.
static String definitions_of(const BaseMaterial3D &from) {
	String all;
	const auto define = [&all](bool is_used, const char *name) {
		all += is_used ? String("#define MODEL_") + name + "\n" : String();
	};
	const BaseMaterial3D::Transparency transparency = from.get_transparency();
	define(transparency != BaseMaterial3D::TRANSPARENCY_DISABLED, "ALPHA");
	define(transparency == BaseMaterial3D::TRANSPARENCY_ALPHA_SCISSOR, "SCISSOR");
	define(transparency == BaseMaterial3D::TRANSPARENCY_ALPHA_HASH, "HASH");
	define(from.get_alpha_antialiasing() != BaseMaterial3D::ALPHA_ANTIALIASING_OFF, "EDGE");
	define(from.get_flag(BaseMaterial3D::FLAG_ALBEDO_FROM_VERTEX_COLOR), "COLORS");
	define(from.get_flag(BaseMaterial3D::FLAG_SRGB_VERTEX_COLOR), "SRGB_COLORS");
	define(from.get_feature(BaseMaterial3D::FEATURE_NORMAL_MAPPING), "NORMAL_MAP");
	define(from.get_feature(BaseMaterial3D::FEATURE_EMISSION), "EMISSION");
	define(from.get_emission_operator() == BaseMaterial3D::EMISSION_OP_MULTIPLY, "EMISSION_MULTIPLIED");
	define(from.get_feature(BaseMaterial3D::FEATURE_AMBIENT_OCCLUSION), "AO");
	define(from.get_flag(BaseMaterial3D::FLAG_AO_ON_UV2), "AO_ON_UV2");
	define(from.get_feature(BaseMaterial3D::FEATURE_BACKLIGHT), "BACKLIGHT");
	define(from.get_feature(BaseMaterial3D::FEATURE_SUBSURFACE_SCATTERING), "SUBSURFACE");
	define(is_orm(from), "ORM");
	return all;
}

static String code_of(const BaseMaterial3D &from) {
	return "shader_type spatial;\nrender_mode " + render_modes_of(from) + ";\n#define MODEL_SAMPLING " +
			filter_of(from) + "\n" + definitions_of(from) + include("undergrowth_bend.gdshaderinc") +
			include("undergrowth_model.gdshaderinc");
}

static Vector4 mask_of(BaseMaterial3D::TextureChannel channel) {
	switch (channel) {
		case BaseMaterial3D::TEXTURE_CHANNEL_GREEN:
			return Vector4(0.0f, 1.0f, 0.0f, 0.0f);
		case BaseMaterial3D::TEXTURE_CHANNEL_BLUE:
			return Vector4(0.0f, 0.0f, 1.0f, 0.0f);
		case BaseMaterial3D::TEXTURE_CHANNEL_ALPHA:
			return Vector4(0.0f, 0.0f, 0.0f, 1.0f);
		case BaseMaterial3D::TEXTURE_CHANNEL_GRAYSCALE:
			return Vector4(0.3333333f, 0.3333333f, 0.3333333f, 0.0f);
		default:
			return Vector4(1.0f, 0.0f, 0.0f, 0.0f);
	}
}

static void copy_textures(const Ref<BaseMaterial3D> &from, const Ref<ShaderMaterial> &made) {
	const auto copy = [&](const char *name, BaseMaterial3D::TextureParam texture) {
		set_parameter(made, name, from->get_texture(texture));
	};
	copy("texture_albedo", BaseMaterial3D::TEXTURE_ALBEDO);
	copy("texture_normal", BaseMaterial3D::TEXTURE_NORMAL);
	copy("texture_emission", BaseMaterial3D::TEXTURE_EMISSION);
	copy("texture_ao", BaseMaterial3D::TEXTURE_AMBIENT_OCCLUSION);
	copy("texture_backlight", BaseMaterial3D::TEXTURE_BACKLIGHT);
	copy("texture_subsurface", BaseMaterial3D::TEXTURE_SUBSURFACE_SCATTERING);
	if (is_orm(*from.ptr())) {
		copy("texture_orm", BaseMaterial3D::TEXTURE_ORM);
	} else {
		copy("texture_metallic", BaseMaterial3D::TEXTURE_METALLIC);
		copy("texture_roughness", BaseMaterial3D::TEXTURE_ROUGHNESS);
	}
}

static void copy_values(const Ref<BaseMaterial3D> &from, const Ref<ShaderMaterial> &made) {
	set_parameter(made, "albedo", from->get_albedo());
	set_parameter(made, "metallic", from->get_metallic());
	set_parameter(made, "roughness", from->get_roughness());
	set_parameter(made, "specular", from->get_specular());
	set_parameter(made, "alpha_scissor_threshold", from->get_alpha_scissor_threshold());
	set_parameter(made, "alpha_hash_scale", from->get_alpha_hash_scale());
	set_parameter(made, "alpha_edge", from->get_alpha_antialiasing_edge());
	set_parameter(made, "normal_scale", from->get_normal_scale());
	set_parameter(made, "emission", from->get_emission());
	set_parameter(made, "emission_energy", from->get_emission_energy_multiplier());
	set_parameter(made, "ao_light_affect", from->get_ao_light_affect());
	set_parameter(made, "ao_channel", mask_of(from->get_ao_texture_channel()));
	set_parameter(made, "metallic_channel", mask_of(from->get_metallic_texture_channel()));
	set_parameter(made, "roughness_channel", mask_of(from->get_roughness_texture_channel()));
	set_parameter(made, "backlight", from->get_backlight());
	set_parameter(made, "subsurface_strength", from->get_subsurface_scattering_strength());
	set_parameter(made, "uv1_scale", from->get_uv1_scale());
	set_parameter(made, "uv1_offset", from->get_uv1_offset());
}

// Adds the bend to a shader of the user that has none.
static String with_bend(const String &code) {
	static const char *const BEND = "UNDERGROWTH_BEND";
	if (code.contains(BEND)) {
		return code;
	}
	const int64_t vertex = code.find("void vertex()");
	const int64_t body = vertex < 0 ? -1 : code.find("{", vertex);
	if (body < 0) {
		return code + String("\n") + include("undergrowth_bend.gdshaderinc") +
				String("void vertex() { UNDERGROWTH_BEND }\n");
	}
	return code.substr(0, vertex) + String("\n") + include("undergrowth_bend.gdshaderinc") +
			code.substr(vertex, body + 1 - vertex) + String(" UNDERGROWTH_BEND\n") + code.substr(body + 1);
}

static Ref<BaseMaterial3D> plain_of(const Ref<Material> &source) {
	const Ref<BaseMaterial3D> plain = source;
	return plain.is_valid() ? plain : Ref<BaseMaterial3D>(new_counted<StandardMaterial3D>());
}

Ref<Shader> model_shader(const Ref<Material> &source) {
	const Ref<ShaderMaterial> own = source;
	if (own.is_null()) {
		return shader_of(code_of(*plain_of(source).ptr()));
	}
	const Ref<Shader> shader = own->get_shader();
	return shader_of(with_bend(shader.is_valid() ? shader->get_code() : "shader_type spatial;"));
}

void follow_model_material(const Ref<Material> &source, const Ref<Shader> &shader, const Ref<ShaderMaterial> &made) {
	const Ref<ShaderMaterial> own = source;
	if (own.is_valid()) {
		take_over(own, shader, made);
		return;
	}
	const Ref<BaseMaterial3D> plain = plain_of(source);
	set_shader(made, shader);
	copy_textures(plain, made);
	copy_values(plain, made);
}

Ref<ShaderMaterial> make_model_material(const Ref<Material> &source) {
	Ref<ShaderMaterial> made = new_counted<ShaderMaterial>();
	if (source.is_valid()) {
		made->set_render_priority(source->get_render_priority());
	}
	follow_model_material(source, model_shader(source), made);
	return made;
}

} // namespace undergrowth
