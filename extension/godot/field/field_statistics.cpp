#include "field/field_statistics.hpp"

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/viewport.hpp>
#include <godot_cpp/variant/typed_array.hpp>

using namespace godot;

namespace undergrowth {

static PackedInt32Array count_drawn(const Node3D *node, const Meadow &meadow) {
	const Camera3D *camera = node->is_inside_tree() ? node->get_viewport()->get_camera_3d() : nullptr;
	PackedInt32Array drawn;
	for (const int count : meadow.count_drawn(camera ? camera->get_global_position() : node->get_position())) {
		drawn.push_back(count);
	}
	return drawn;
}

// The used levels of each look.
static TypedArray<Dictionary> list_levels(const FieldStyle &style) {
	TypedArray<Dictionary> listed;
	for (const FieldLook &look : style.looks) {
		PackedInt32Array segments;
		PackedFloat32Array ends;
		PackedFloat32Array errors;
		for (size_t i = 0; i < look.levels.size(); i++) {
			if (look.levels[i].is_used) {
				segments.push_back(look.segments_at(look.levels[i]));
				ends.push_back(look.levels[i].end);
				errors.push_back(i < look.errors.size() ? look.errors[i] : 0.0f);
			}
		}
		Dictionary one;
		one["species"] = look.function;
		one["segments"] = segments;
		one["ends"] = ends;
		one["errors"] = errors;
		listed.push_back(one);
	}
	return listed;
}

Dictionary FieldStatistics::tell(const Node3D *node, Meadow &meadow, bool is_dressed_soon) const {
	meadow.motion.wait();
	const int count = meadow.store.plant_count();
	Dictionary told;
	told["plants"] = count;
	told["simulated"] = meadow.motion.simulated_count();
	told["drawn_by_level"] = count_drawn(node, meadow);
	told["levels"] = list_levels(meadow.style);
	told["is_rebuilding_meshes"] = (meadow.is_at_work() && !meadow.is_building()) || is_dressed_soon;
	told["tiles"] = meadow.tiles.standing_count();
	told["tiles_waiting"] = meadow.tiles.waiting_count();
	told["tiles_usec"] = meadow.streams() ? meadow.tiles_usec : 0.0;
	told["build_usec"] = meadow.filling.usec();
	told["skeletons"] = int64_t(meadow.skeletons.count());
	told["step_usec"] = meadow.motion.busy_usec();
	told["upload_usec"] = meadow.upload_usec;
	told["thin_usec"] = meadow.thin_usec;
	told["main_usec"] = main_usec;
	told["wait_usec"] = wait_usec;
	told["bytes_per_plant"] = count > 0 ? double(meadow.store.bytes()) / count + meadow.motion.bytes_per_plant() : 0.0;
	return told;
}

} // namespace undergrowth
