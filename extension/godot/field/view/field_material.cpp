#include "field/view/field_material.hpp"

#include "base/new_object.hpp"
#include "species/shared_resources.hpp"
#include "stem/stem_shape.hpp"

#include <godot_cpp/classes/base_material3d.hpp>
#include <godot_cpp/classes/shader.hpp>
#include <godot_cpp/classes/texture2d.hpp>

using namespace godot;

namespace undergrowth {

static const char *const OWN_PREFIX = "undergrowth_"; // Prefix of parameters that the field sets.
static const char *const INCLUDE_NAME = "undergrowth_bend.gdshaderinc";
static const char *const CARD_INCLUDE_NAME = "undergrowth_card.gdshaderinc";
static const char *const PACKED_NAME = "#define UNDERGROWTH_PACKED";

void set_parameter(const Ref<ShaderMaterial> &material, const StringName &name, const Variant &value) {
	if (material->get_shader_parameter(name) != value) {
		material->set_shader_parameter(name, value);
	}
}

static void take_over(const Ref<BaseMaterial3D> &source, const Ref<ShaderMaterial> &made) {
	set_parameter(made, "albedo", source->get_albedo());
	set_parameter(made, "albedo_texture", source->get_texture(BaseMaterial3D::TEXTURE_ALBEDO));
	set_parameter(made, "vertex_colors", source->get_flag(BaseMaterial3D::FLAG_ALBEDO_FROM_VERTEX_COLOR));
	set_parameter(made, "vertex_colors_are_srgb", source->get_flag(BaseMaterial3D::FLAG_SRGB_VERTEX_COLOR));
	set_parameter(made, "roughness", source->get_roughness());
	set_parameter(made, "metallic", source->get_metallic());
	set_parameter(made, "specular", source->get_specular());
	const bool has_backlight = source->get_feature(BaseMaterial3D::FEATURE_BACKLIGHT);
	set_parameter(made, "backlight", has_backlight ? source->get_backlight() : Color(0.0f, 0.0f, 0.0f));
}

// The add-on's shader of plants of parts has versions with the same parameters.
static Ref<Shader> version_of(const Ref<Shader> &shader, DrawnParts drawn, bool is_packed) {
	if (!is_packed || shader != plant_shader(true)) {
		return shader;
	}
	switch (drawn) {
		case DrawnParts::solid:
			return solids_shader();
		case DrawnParts::orders:
			return orders_shader();
		case DrawnParts::with_cards:
			return cards_shader();
		case DrawnParts::orders_with_cards:
			return orders_with_cards_shader();
		case DrawnParts::shadows:
			break;
	}
	return shadows_shader();
}

void set_shader(const Ref<ShaderMaterial> &material, const Ref<Shader> &shader) {
	if (material->get_shader() != shader) {
		material->set_shader(shader);
	}
}

void take_over(const Ref<ShaderMaterial> &source, const Ref<Shader> &shader, const Ref<ShaderMaterial> &made) {
	set_shader(made, shader);
	const Array uniforms = shader.is_valid() ? shader->get_shader_uniform_list() : Array();
	for (int64_t i = 0; i < uniforms.size(); i++) {
		const Dictionary uniform = uniforms[i];
		const String name = uniform["name"];
		if (!name.begins_with(OWN_PREFIX)) {
			set_parameter(made, name, source->get_shader_parameter(name));
		}
	}
}

void follow_material(const Ref<Material> &source, const Ref<ShaderMaterial> &made, DrawnParts drawn, bool is_packed) {
	const Ref<ShaderMaterial> own = source;
	const Ref<BaseMaterial3D> plain = source;
	if (own.is_valid()) {
		take_over(own, version_of(own->get_shader(), drawn, is_packed), made);
	} else if (plain.is_valid()) {
		take_over(plain, made);
	}
}

Ref<ShaderMaterial> make_field_material(const Ref<Material> &source, bool of_parts, DrawnParts drawn, bool is_packed) {
	const Ref<ShaderMaterial> own = source;
	if (own.is_valid()) {
		const Ref<ShaderMaterial> copy = own->duplicate();
		copy->set_shader(version_of(own->get_shader(), drawn, is_packed));
		return copy;
	}
	Ref<ShaderMaterial> made = new_counted<ShaderMaterial>();
	made->set_shader(of_parts ? version_of(plant_shader(true), drawn, is_packed) : plant_shader(false));
	const Ref<BaseMaterial3D> plain = source;
	if (plain.is_valid()) {
		take_over(plain, made);
	}
	return made;
}

// Shapes per bend of the tip, not per amplitude: textures contain bends.
static Array shapes_of(const StemConstants &stem) {
	Array shapes;
	for (const float (&shape)[4] : stem.shape) {
		const float second = stem.modes == 2 ? shape[1] / stem.mode[1].tip_slope : 0.0f;
		shapes.push_back(Vector4(shape[0] / stem.mode[0].tip_slope, second, shape[2], shape[3]));
	}
	return shapes;
}

void set_stem_parameters(const Ref<ShaderMaterial> &material, const MotionSpecies &species) {
	const bool is_stem = species.law == Law::stem;
	set_parameter(material, "undergrowth_stem_modes", is_stem ? species.stem.modes : 0);
	if (is_stem) {
		set_parameter(material, "undergrowth_stem_shapes", shapes_of(species.stem));
		set_parameter(material, "undergrowth_stem_share", first_share(species.stem));
	}
}

bool draws_cards(const Ref<Material> &source) {
	const Ref<ShaderMaterial> own = source;
	const Ref<Shader> shader = own.is_valid() ? own->get_shader() : Ref<Shader>();
	return source.is_null() ||
			(shader.is_valid() && (shader == plant_shader(true) || shader->get_code().contains(CARD_INCLUDE_NAME)));
}

bool reads_packed_vertices(const Ref<Material> &source) {
	const Ref<ShaderMaterial> own = source;
	if (own.is_null()) {
		return true;
	}
	const Ref<Shader> shader = own->get_shader();
	return shader.is_valid() && (shader == plant_shader(true) || shader->get_code().contains(PACKED_NAME));
}

bool bends_in_shader(const Ref<ShaderMaterial> &material) {
	const Ref<Shader> shader = material->get_shader();
	return shader.is_valid() && shader->get_code().contains(INCLUDE_NAME);
}

} // namespace undergrowth
