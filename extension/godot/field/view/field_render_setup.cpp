#include "field/view/field_render_setup.hpp"

#include <godot_cpp/classes/geometry_instance3d.hpp>
#include <godot_cpp/classes/rendering_server.hpp>

#include <utility>

using namespace godot;

namespace undergrowth {

FieldRenderSetup outline_of(const FieldRenderSetup &setup) {
	FieldRenderSetup outline;
	outline.levels = setup.levels;
	outline.rule = setup.rule;
	outline.tile_size = setup.tile_size;
	outline.is_of_tiles = setup.is_of_tiles;
	outline.needs_colors = setup.needs_colors;
	for (const SpeciesStyle &style : setup.styles) {
		SpeciesStyle some;
		some.variant_count = style.variant_count;
		some.detail = style.detail;
		some.is_by_error = style.is_by_error;
		some.levels = style.levels;
		some.errors = style.errors;
		some.triangles = style.triangles;
		some.texel = style.texel;
		some.closest = style.closest;
		some.usual_triangles = style.usual_triangles;
		some.are_carded = style.are_carded;
		some.have_bodies = style.have_bodies;
		some.density = style.density;
		some.mean_scale = style.mean_scale;
		some.variants = style.variants;
		some.meshes = style.meshes;
		some.motion = style.motion;
		some.width = style.width;
		some.nearest.assign(style.nearest.begin(), style.nearest.begin() + (style.nearest.empty() ? 0 : 1));
		outline.styles.push_back(std::move(some));
	}
	return outline;
}

void InstanceRenderFlags::set_gi(const RID &instance) const {
	RenderingServer *server = RenderingServer::get_singleton();
	server->instance_geometry_set_flag(instance, RenderingServer::INSTANCE_FLAG_USE_BAKED_LIGHT,
			gi_mode == int(GeometryInstance3D::GI_MODE_STATIC));
	server->instance_geometry_set_flag(instance, RenderingServer::INSTANCE_FLAG_USE_DYNAMIC_GI,
			gi_mode == int(GeometryInstance3D::GI_MODE_DYNAMIC));
}

} // namespace undergrowth
