#include "field/field_inspector.hpp"

#include "field/build/field_ground.hpp"
#include "field/build/field_habitats.hpp"

#include <algorithm>
#include <iterator>

using namespace godot;

namespace undergrowth {

static bool is_of_one_mesh(const String &name) {
	static const char *const names[] = { "gi_lightmap_texel_density", "gi_lightmap_texel_scale", "gi_lightmap_scale",
		"material_overlay", "extra_cull_margin", "custom_aabb", "ignore_occlusion_culling", "visibility_range_begin",
		"visibility_range_begin_margin", "visibility_range_end_margin", "visibility_range_fade_mode", "sorting_offset",
		"sorting_use_aabb_center" };
	return std::any_of(std::begin(names), std::end(names), [&](const char *one) { return name == one; });
}

static bool is_idle_in_area(const String &name, const PlacementOptions &options) {
	const bool is_painted = options.map.is_valid();
	const bool has_no_area = is_painted || options.endless;
	return (name == "size" && (has_no_area || !options.outline.is_empty())) || (name == "outline" && has_no_area) ||
			(name == "outline_width" && (has_no_area || options.outline.is_empty())) ||
			(name == "edge_falloff" && has_no_area && options.exclusions.is_empty()) ||
			(name == "endless" && is_painted);
}

static bool is_idle_on_ground(const String &name, const PlacementOptions &options) {
	using Kind = FieldGround::Kind;
	const auto kind = Kind(options.ground_mode);
	const bool is_flat = kind == Kind::none;
	return (name == "ground_collision_mask" && kind != Kind::colliders) ||
			(name == "ground_sample_spacing" && kind != Kind::colliders && kind != Kind::object) ||
			(name == "ground_choice" && (is_flat || kind == Kind::object)) ||
			(name == "ground_mesh" && kind != Kind::mesh) || (name == "ground_object" && kind != Kind::object) ||
			(name == "sun_latitude" && !habitats_use(options, HabitatFactor::light)) ||
			(is_flat && (name == "height_limits" || name.begins_with("slope_")));
}

bool shows_in_inspector(const String &name, const PlacementOptions &options) {
	return !is_of_one_mesh(name) && !is_idle_in_area(name, options) && !is_idle_on_ground(name, options);
}

} // namespace undergrowth
