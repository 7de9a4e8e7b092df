#include "field/field_statistics.hpp"

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/variant/typed_array.hpp>

using namespace godot;

namespace undergrowth {

static PackedInt32Array count_drawn(const Node3D *node, FieldRuntime &runtime) {
	const Camera3D *camera = node->is_inside_tree() ? node->get_viewport()->get_camera_3d() : nullptr;
	PackedInt32Array drawn;
	for (const int count : runtime.count_drawn(camera ? camera->get_global_position() : node->get_position())) {
		drawn.push_back(count);
	}
	return drawn;
}

// The used levels of each style.
static TypedArray<Dictionary> list_levels(const FieldRenderSetup &setup) {
	TypedArray<Dictionary> listed;
	for (const SpeciesStyle &style : setup.styles) {
		PackedInt32Array segments;
		PackedInt32Array variants;
		PackedFloat32Array ends;
		PackedFloat32Array errors;
		PackedInt32Array triangles;
		PackedByteArray are_carded;
		for (size_t i = 0; i < style.levels.size(); i++) {
			if (style.levels[i].is_used) {
				segments.push_back(style.segments_at(style.levels[i]));
				variants.push_back(style.levels[i].groups(style.variant_count));
				ends.push_back(style.levels[i].end);
				errors.push_back(i < style.errors.size() ? style.errors[i] : 0.0f);
				triangles.push_back(i < style.errors.size() ? int(style.triangles_at(i)) : 0);
				are_carded.push_back(style.is_carded(i) ? 1 : 0);
			}
		}
		Dictionary one;
		one["species"] = style.function;
		one["segments"] = segments;
		one["variants"] = variants;
		one["ends"] = ends;
		one["errors"] = errors;
		one["triangles"] = triangles;
		one["are_carded"] = are_carded;
		listed.push_back(one);
	}
	return listed;
}

Dictionary FieldStatistics::to_dictionary(const Node3D *node, FieldRuntime &runtime, bool is_restyle_queued) const {
	const int count = runtime.store.plant_count();
	Dictionary values;
	values["plants"] = count;
	values["simulated"] = runtime.motion.simulated_count(runtime.store);
	values["drawn_by_level"] = count_drawn(node, runtime);
	values["levels"] = list_levels(runtime.setup);
	values["is_rebuilding_meshes"] = (runtime.is_at_work() && !runtime.is_building()) || is_restyle_queued;
	values["is_listing_shadows"] = runtime.is_listing_shadows();
	values["tiles"] = runtime.tiles.existing_count();
	values["tiles_waiting"] = runtime.tiles.waiting_count();
	values["tiles_usec"] = runtime.streams() ? runtime.tiles_usec : 0.0;
	values["build_usec"] = runtime.build_cost.usec();
	values["skeletons"] = int64_t(runtime.skeletons.count());
	values["step_usec"] = runtime.motion.busy_usec();
	values["upload_usec"] = runtime.upload_usec;
	values["thin_usec"] = runtime.thin_usec;
	values["main_usec"] = main_usec;
	values["wait_usec"] = wait_usec;
	values["bytes_per_plant"] = runtime.motion.bytes_per_plant(runtime.store);
	return values;
}

} // namespace undergrowth
