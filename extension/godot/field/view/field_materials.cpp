#include "field/view/field_materials.hpp"

#include "base/convert.hpp"
#include "base/messages.hpp"
#include "base/stopwatch.hpp"
#include "field/build/build_input.hpp"
#include "field/view/field_material.hpp"
#include "form/shared_cards.hpp"
#include "model/model_material.hpp"
#include "species/shared_resources.hpp"

#include <godot_cpp/classes/rendering_server.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr float FARTHEST = 1e9f; // m.
static constexpr float MIN_MARGIN = 1.0f; // m.
static constexpr float SHADOW_MARGIN = 0.5f; // m.
static constexpr float SWINGS_TO = 60.0f; // In plant heights: beyond this distance a leaf sways by less than a pixel.
static constexpr float SWINGS_WHOLE = 0.75f; // Fraction of that distance up to which leaves sway fully.

static Vector3 vector_of(const float (&numbers)[3]) {
	return Vector3(numbers[0], numbers[1], numbers[2]);
}

// Plants without parts have the same width from all directions.
static Vector2 above_at(const SpeciesStyle &style, size_t material) {
	const size_t level = style.level_of(material);
	return style.has_parts() && level < style.from_above.size() ? style.from_above[level] : Vector2();
}

Ref<ShaderMaterial> FieldMaterials::make_one(const SpeciesStyle &style, size_t level) const {
	if (style.model()) {
		return make_model_material(style.source_material(level / style.slots(), node->get_material_override()));
	}
	const Ref<Material> source = style.present_material(node->get_material_override());
	const Ref<ShaderMaterial> made =
			make_field_material(source, style.has_parts(), style.drawn_parts(level), style.is_packed);
	if (style.is_carded(level)) {
		made->set_shader_parameter("undergrowth_card_colors", style.cards->colors());
		made->set_shader_parameter("undergrowth_card_surfaces", style.cards->surfaces());
	}
	return made;
}

bool FieldMaterials::make(FieldRenderSetup &setup, double usec) const {
	const Stopwatch watch;
	bool is_any = false;
	for (SpeciesStyle &style : setup.styles) {
		while (style.materials.size() < style.slots() * std::max(style.sources.size(), size_t(1))) {
			if (std::exchange(is_any, true) && watch.usec() > usec) {
				return false;
			}
			style.materials.push_back(make_one(style, style.materials.size()));
			if (style.materials.size() == 1 && !bends_in_shader(style.materials[0])) {
				report_error(style.function.ptr(),
						"its material has a shader that does not bend in a PlantField3D. Include "
						"undergrowth_bend.gdshaderinc, which says how.");
			}
		}
	}
	return true;
}

void FieldMaterials::hide(const FieldRenderSetup &setup) const {
	for (const SpeciesStyle &style : setup.styles) {
		for (const Ref<ShaderMaterial> &material : style.materials) {
			material->set_shader_parameter("undergrowth_level", Vector4(FARTHEST, FARTHEST, MIN_MARGIN, MIN_MARGIN));
		}
	}
}

void FieldMaterials::forget_sent() {
	has_sent = is_listed = false;
	sent_clock = -1.0f;
	sent_leans.clear();
	sent_before = {};
	sent_precipitation = {};
}

void FieldMaterials::bind(FieldRenderSetup &setup, const FieldMotion &motion) {
	forget_sent();
	make(setup, std::numeric_limits<double>::infinity());
	for (SpeciesStyle &style : setup.styles) {
		bind_style(style, motion);
	}
}

void FieldMaterials::bind_last(FieldRenderSetup &setup, const FieldMotion &motion) {
	forget_sent();
	make(setup, std::numeric_limits<double>::infinity());
	bind_style(setup.styles.back(), motion);
}

// Returns the level that a material draws, or that a caster's material casts.
static FieldLevel drawn_level(const SpeciesStyle &style, size_t material) {
	if (material < style.levels.size()) {
		return style.levels[material];
	}
	const ShadowCaster &caster = style.casters[material - style.levels.size()];
	FieldLevel level = style.levels[style.level_of(material)];
	level.is_used = caster.level >= 0;
	level.begin = caster.begin;
	level.end = caster.end;
	level.margin = level.end_margin = SHADOW_MARGIN;
	level.lod_density = caster.lod_density;
	return level;
}

void FieldMaterials::bind_style(const SpeciesStyle &style, const FieldMotion &motion) const {
	for (size_t i = 0; i < style.materials.size(); i++) {
		const FieldLevel level = drawn_level(style, i % style.slots());
		const float begin = level.begin > 0.0f ? level.begin : -FARTHEST;
		const float end = level.end > 0.0f ? level.end : FARTHEST;
		const LodDensity lod_density = level.lod_density_of(style.has_parts());
		const Ref<ShaderMaterial> &material = style.materials[i];
		set_parameter(material, "undergrowth_level", Vector4(begin, end, level.margin, level.end_margin));
		set_parameter(material, "undergrowth_shadow_end", std::max(level.shadow_end, MIN_MARGIN));
		set_parameter(material, "undergrowth_share_ends", vector_of(lod_density.distances));
		set_parameter(material, "undergrowth_shares", vector_of(lod_density.densities));
		set_parameter(material, "undergrowth_has_parts", style.has_parts());
		set_parameter(material, "undergrowth_mean", style.mean);
		set_parameter(material, "undergrowth_from_above", above_at(style, i % style.slots()));
		set_parameter(material, "undergrowth_bends", motion.pose_texture());
		set_parameter(material, "undergrowth_blends", motion.blend_texture());
		set_parameter(material, "undergrowth_beats", motion.beat_texture());
		set_parameter(material, "undergrowth_has_heights", motion.has_heights());
		set_parameter(material, "undergrowth_axes", axes_of(node).basis.inverse());
		set_parameter(material, "undergrowth_origin", axes_of(node).origin);
	}
	send_stem(style);
	style.set_surface_materials();
}

void FieldMaterials::send_stem(const SpeciesStyle &style) const {
	for (const Ref<ShaderMaterial> &material : style.materials) {
		set_stem_parameters(material, style.motion);
	}
}

void FieldMaterials::send_stems(const FieldRenderSetup &setup) {
	is_listed = false;
	for (const SpeciesStyle &style : setup.styles) {
		send_stem(style);
	}
}

void FieldMaterials::send_axes(const FieldRenderSetup &setup) const {
	const Basis to_field = axes_of(node).basis.inverse();
	const Vector3 origin = axes_of(node).origin;
	for (const SpeciesStyle &style : setup.styles) {
		for (const Ref<ShaderMaterial> &material : style.materials) {
			set_parameter(material, "undergrowth_axes", to_field);
			set_parameter(material, "undergrowth_origin", origin);
		}
	}
}

void FieldMaterials::release(FieldRenderSetup &setup, std::vector<std::vector<Ref<ShaderMaterial>>> &old) {
	is_listed = false;
	for (SpeciesStyle &style : setup.styles) {
		old.push_back(std::move(style.materials));
		style.materials.clear();
		style.take_material();
	}
}

void FieldMaterials::follow(const FieldRenderSetup &setup) {
	if (setup.styles.empty()) {
		return;
	}
	followed_style = (followed_style + 1) % setup.styles.size();
	const SpeciesStyle &style = setup.styles[followed_style];
	const Ref<Material> source = style.drawn_material(node->get_material_override());
	if (style.needs_other_meshes(source)) {
		return; // Until the next build.
	}
	if (style.model()) {
		follow_models(style);
		return;
	}
	for (size_t i = 0; i < style.materials.size(); i++) {
		follow_material(source, style.materials[i], style.drawn_parts(i), style.is_packed);
	}
}

// The code of a shader is made once for all materials of a source.
void FieldMaterials::follow_models(const SpeciesStyle &style) const {
	for (size_t first = 0; first < style.materials.size(); first += style.slots()) {
		const Ref<Material> source = style.source_material(first / style.slots(), node->get_material_override());
		const Ref<Shader> shader = model_shader(source);
		for (size_t i = first; i < std::min(first + style.slots(), style.materials.size()); i++) {
			follow_model_material(source, shader, style.materials[i]);
		}
	}
}

void FieldMaterials::list_swinging(const FieldRenderSetup &setup) {
	is_listed = true;
	sent_clock = -1.0f;
	swinging.clear();
	swings_to = 0.0f;
	for (size_t species = 0; species < setup.styles.size(); species++) {
		const SpeciesStyle &style = setup.styles[species];
		const float end = style.motion.longest * SWINGS_TO;
		for (size_t i = 0; style.motion.has_parts && i < style.materials.size(); i++) {
			const FieldLevel level = drawn_level(style, i % style.slots());
			const float nearest = level.begin - level.margin;
			const float farthest = level.end > 0.0f ? level.end + level.end_margin : std::numeric_limits<float>::max();
			const bool swings = style.materials[i]->get_shader() != shadows_shader();
			if (swings && level.is_used && nearest < end) {
				swinging.push_back(
						{ style.materials[i]->get_rid(), nearest, farthest, int(species), end * SWINGS_WHOLE, end });
				swings_to = std::max(swings_to, end);
			}
		}
	}
}

bool FieldMaterials::has_swinging(const FieldRenderSetup &setup) {
	if (!is_listed) {
		list_swinging(setup);
	}
	return !swinging.empty();
}

// Sets the parameter in the renderer only: a material's own copy of it would cost more than everything else here.
void FieldMaterials::send_swing_clock(const FieldMotion &motion, const SeenDistances &seen) {
	if (seen.nearest >= swings_to) {
		return; // Does not read the list.
	}
	const float clock = motion.swing_clock();
	if (clock == sent_clock && seen.nearest == sent_seen.nearest && seen.farthest == sent_seen.farthest) {
		return;
	}
	sent_clock = clock;
	sent_seen = seen;
	static const StringName &swing = *new StringName("undergrowth_swing");
	static const StringName &air = *new StringName("undergrowth_air");
	RenderingServer *server = RenderingServer::get_singleton();
	for (const Swinging &one : swinging) {
		if (seen.nearest < one.end && one.nearest <= seen.farthest && one.farthest >= seen.nearest) {
			server->material_set_param(one.material, swing, Vector3(clock, one.whole, one.end));
			const glm::vec4 around = motion.part_air(one.species);
			server->material_set_param(one.material, air, Vector4(around.x, around.y, around.z, around.w));
		}
	}
}

void FieldMaterials::send_leans(const FieldRenderSetup &setup, const FieldMotion &motion) {
	static constexpr float VISIBLE = 0.004f; // A brightness of less than 1 %.
	static constexpr int FRAMES_BETWEEN = 16; // The mean changes over seconds.
	if (!sent_leans.empty() && ++frames_since_leans < FRAMES_BETWEEN) {
		return;
	}
	frames_since_leans = 0;
	static const StringName &mean_lean = *new StringName("undergrowth_mean_lean");
	RenderingServer *server = RenderingServer::get_singleton();
	sent_leans.resize(setup.styles.size(), -1.0f);
	for (size_t i = 0; i < setup.styles.size(); i++) {
		const float lean = motion.mean_lean(int(i));
		if (sent_leans[i] >= 0.0f && std::abs(lean - sent_leans[i]) < VISIBLE) {
			continue;
		}
		sent_leans[i] = lean;
		for (const Ref<ShaderMaterial> &material : setup.styles[i].materials) {
			server->material_set_param(material->get_rid(), mean_lean, lean);
		}
	}
}

void FieldMaterials::send_precipitation(const FieldRenderSetup &setup, const Precipitation &precipitation) {
	if (precipitation == sent_precipitation) {
		return;
	}
	sent_precipitation = precipitation;
	static const StringName &name = *new StringName("undergrowth_precipitation");
	const Vector2 value(precipitation.wetness, precipitation.snow);
	for (const SpeciesStyle &style : setup.styles) {
		for (const Ref<ShaderMaterial> &material : style.materials) {
			RenderingServer::get_singleton()->material_set_param(material->get_rid(), name, value);
		}
	}
}

// The materials of shadows stay as they are: no pass of shadows writes vectors.
void FieldMaterials::send_before(const FieldRenderSetup &setup, const MotionVectors::Sent &before, float step) {
	if (before == sent_before) {
		return;
	}
	sent_before = before;
	static const StringName &name = *new StringName("undergrowth_before");
	const Vector4 value(before.tilt, before.clock, before.steps * std::sqrt(step), before.steps);
	for (const SpeciesStyle &style : setup.styles) {
		for (size_t i = 0; i < style.materials.size(); i++) {
			if (i % style.slots() < style.levels.size()) {
				RenderingServer::get_singleton()->material_set_param(style.materials[i]->get_rid(), name, value);
			}
		}
	}
}

void FieldMaterials::send_followers(const FieldRenderSetup &setup, const FieldMotion &motion, const Transform3D &axes) {
	if (!motion.follows_prototypes()) {
		return;
	}
	const FieldMotion::Delays delays = motion.follower_delays(axes);
	const bool are_same =
			has_sent && delays.after == sent.after && delays.before == sent.before && delays.share == sent.share;
	sent = delays;
	has_sent = true;
	static const StringName &history_name = *new StringName("undergrowth_history");
	RenderingServer *server = RenderingServer::get_singleton();
	for (size_t i = 0; i < setup.styles.size(); i++) {
		const Vector4 history = motion.history_of(int(i));
		for (const Ref<ShaderMaterial> &material : setup.styles[i].materials) {
			server->material_set_param(material->get_rid(), history_name, history);
			if (are_same) {
				continue;
			}
			material->set_shader_parameter("undergrowth_delay", delays.after);
			material->set_shader_parameter("undergrowth_delay_before", delays.before);
			material->set_shader_parameter("undergrowth_delay_share", delays.share);
		}
	}
}

} // namespace undergrowth
