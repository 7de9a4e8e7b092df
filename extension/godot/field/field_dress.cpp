#include "field/field_dress.hpp"

#include "field/field_material.hpp"
#include "field/field_recipe.hpp"
#include "messages.hpp"
#include "stem/stem_shape.hpp"

#include <algorithm>

using namespace godot;

namespace undergrowth {

static constexpr float FARTHEST = 1e9f; // m.
static constexpr float LEAST_MARGIN = 1.0f; // m.
static constexpr float SHADOW_MARGIN = 0.5f; // m.
static constexpr float SWINGS_TO = 60.0f; // In plant heights: beyond this distance a leaf sways by less than a pixel.
static constexpr float SWINGS_WHOLE = 0.75f; // Fraction of that distance up to which leaves sway fully.

static Vector3 vector_of(const float (&numbers)[3]) {
	return Vector3(numbers[0], numbers[1], numbers[2]);
}

// Plants without parts have the same width from all directions.
static Vector2 above_at(const FieldLook &look, size_t level) {
	return look.has_parts() && level < look.from_above.size() ? look.from_above[level] : Vector2();
}

Ref<Material> FieldDress::worn(const FieldLook &look) const {
	const Ref<Material> instead = node->get_material_override();
	return instead.is_valid() ? instead : look.function->get_material();
}

void FieldDress::make(FieldStyle &style) const {
	for (FieldLook &look : style.looks) {
		const bool is_new = look.materials.empty();
		for (size_t i = look.materials.size(); i < style.levels.size() + 2; i++) { // The last two are for shadows.
			look.materials.push_back(make_field_material(worn(look), look.has_parts()));
		}
		if (is_new && !look.materials.empty() && !bends_in_shader(look.materials[0])) {
			report_error(look.function.ptr(),
					"its material has a shader that does not bend in a PlantField3D. Include "
					"undergrowth_bend.gdshaderinc, which says how.");
		}
	}
}

void FieldDress::take_away(const FieldStyle &style) const {
	for (const FieldLook &look : style.looks) {
		for (const Ref<ShaderMaterial> &material : look.materials) {
			material->set_shader_parameter("undergrowth_level", Vector4(FARTHEST, FARTHEST, LEAST_MARGIN, LEAST_MARGIN));
		}
	}
}

void FieldDress::put_on(FieldStyle &style, const FieldMotion &motion) {
	has_sent = false;
	sent_clock = -1.0f;
	make(style);
	for (FieldLook &look : style.looks) {
		put_on_look(look, motion);
	}
}

void FieldDress::put_on_last(FieldStyle &style, const FieldMotion &motion) {
	has_sent = false;
	sent_clock = -1.0f;
	make(style);
	put_on_look(style.looks.back(), motion);
}

// Returns the level of a material. The last two materials are for the shadows of finer levels.
static FieldLevel drawn_level(const FieldLook &look, size_t material) {
	if (material < look.levels.size()) {
		return look.levels[material];
	}
	if (material > look.levels.size()) {
		FieldLevel near = look.levels[size_t(std::max(look.near_shadow_level, 0))];
		near.begin = 0.0f;
		near.end = look.near_shadow_end;
		near.end_margin = SHADOW_MARGIN;
		near.is_used = look.near_shadow_level >= 0;
		return near;
	}
	FieldLevel level = *std::find_if(
			look.levels.begin(), look.levels.end() - 1, [](const FieldLevel &one) { return one.casts_for_finer; });
	level.begin = look.near_shadow_end;
	level.margin = SHADOW_MARGIN;
	return level;
}

void FieldDress::put_on_look(const FieldLook &look, const FieldMotion &motion) const {
	for (size_t i = 0; i < look.materials.size(); i++) {
		const FieldLevel level = drawn_level(look, i);
		const float begin = level.begin > 0.0f ? level.begin : -FARTHEST;
		const float end = level.end > 0.0f ? level.end : FARTHEST;
		const Thinning thinning = level.thinning_of(look.has_parts());
		const Ref<ShaderMaterial> &material = look.materials[i];
		set_parameter(material, "undergrowth_level", Vector4(begin, end, level.margin, level.end_margin));
		set_parameter(material, "undergrowth_share_ends", vector_of(thinning.distances));
		set_parameter(material, "undergrowth_shares", vector_of(thinning.shares));
		set_parameter(material, "undergrowth_has_parts", look.has_parts());
		set_parameter(material, "undergrowth_mean", look.mean);
		set_parameter(material, "undergrowth_from_above", above_at(look, std::min(i, look.levels.size() - 1)));
		set_parameter(material, "undergrowth_bends", motion.pose_texture());
		set_parameter(material, "undergrowth_blends", motion.blend_texture());
		set_parameter(material, "undergrowth_beats", motion.beat_texture());
		set_parameter(material, "undergrowth_has_heights", motion.has_heights());
		set_parameter(material, "undergrowth_axes", axes_of(node).basis.inverse());
	}
	tell_of_stem(look);
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

void FieldDress::tell_of_stem(const FieldLook &look) const {
	const bool is_stem = look.motion.law == Law::stem;
	for (const Ref<ShaderMaterial> &material : look.materials) {
		set_parameter(material, "undergrowth_stem_modes", is_stem ? look.motion.stem.modes : 0);
		if (is_stem) {
			set_parameter(material, "undergrowth_stem_shapes", shapes_of(look.motion.stem));
			set_parameter(material, "undergrowth_stem_share", first_share(look.motion.stem));
		}
	}
}

void FieldDress::tell_of_stems(const FieldStyle &style) const {
	for (const FieldLook &look : style.looks) {
		tell_of_stem(look);
	}
}

void FieldDress::tell_of_axes(const FieldStyle &style) const {
	const Basis to_field = axes_of(node).basis.inverse();
	for (const FieldLook &look : style.looks) {
		for (const Ref<ShaderMaterial> &material : look.materials) {
			set_parameter(material, "undergrowth_axes", to_field);
		}
	}
}

void FieldDress::take_off(FieldStyle &style, std::vector<std::vector<Ref<ShaderMaterial>>> &old) const {
	for (FieldLook &look : style.looks) {
		old.push_back(std::move(look.materials));
		look.materials.clear();
		look.take_material();
	}
}

void FieldDress::follow(const FieldStyle &style) {
	if (style.looks.empty()) {
		return;
	}
	followed_look = (followed_look + 1) % style.looks.size();
	const FieldLook &look = style.looks[followed_look];
	for (const Ref<ShaderMaterial> &material : look.materials) {
		follow_material(worn(look), material);
	}
}

void FieldDress::tell_of_swings(const FieldStyle &style, const FieldMotion &motion, const SeenDistances &seen) {
	const float clock = motion.swing_clock();
	if (clock == sent_clock && seen.nearest == sent_seen.nearest && seen.farthest == sent_seen.farthest) {
		return;
	}
	sent_clock = clock;
	sent_seen = seen;
	static const StringName &swing = *new StringName("undergrowth_swing"); // Set in each material in each frame.
	for (const FieldLook &look : style.looks) {
		const float end = look.motion.longest * SWINGS_TO;
		for (size_t i = 0; look.motion.has_parts && i < look.materials.size(); i++) {
			const FieldLevel level = drawn_level(look, i);
			const float begin = level.begin - level.margin;
			if (level.is_used && std::max(begin, seen.nearest) < end && begin <= seen.farthest &&
					(level.end <= 0.0f || level.end + level.end_margin >= seen.nearest)) {
				look.materials[i]->set_shader_parameter(swing, Vector3(clock, end * SWINGS_WHOLE, end));
			}
		}
	}
}

void FieldDress::tell_of_followers(const FieldStyle &style, const FieldMotion &motion, const Transform3D &axes) {
	if (!motion.follows_prototypes()) {
		return;
	}
	const FieldMotion::Delays delays = motion.follower_delays(axes);
	const bool are_same =
			has_sent && delays.after == sent.after && delays.before == sent.before && delays.share == sent.share;
	sent = delays;
	has_sent = true;
	for (size_t i = 0; i < style.looks.size(); i++) {
		const Vector4 history = motion.history_of(int(i));
		for (const Ref<ShaderMaterial> &material : style.looks[i].materials) {
			material->set_shader_parameter("undergrowth_history", history);
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
