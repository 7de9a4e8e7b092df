// Methods of PlantField3D that do not concern single plants, its callbacks, and the binding for scripts.

#include "nodes/plant_field_3d.hpp"

#include "base/bind_properties.hpp"
#include "base/renamed_properties.hpp"
#include "field/build/field_areas.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <cmath>

using namespace godot;

namespace undergrowth {

// A pointer to a method that returns a type that is not complete yet has another signature in WebAssembly.
static_assert(sizeof(TypedArray<Transform3D>) > 0);

void PlantField3D::reset_motion() {
	runtime.settle();
}

Vector3 PlantField3D::sample_velocity(const Vector3 &root, double height) {
	static constexpr double MAX_HEIGHT = 1e4; // m.
	if (!root.is_finite() || !(height >= 0.0 && height <= MAX_HEIGHT)) {
		report_error(this, "sample_velocity() needs a finite position and a height from 0 to 10000 metres.");
		return Vector3();
	}
	if (properties.wind.is_valid() && !PlantWind::is_air(properties.wind)) {
		report_error(this,
				"sample_velocity() needs a wind of KIND_AIR: other kinds are forces. Set its kind, or call its "
				"sample().");
		return Vector3();
	}
	const Transform3D axes = get_global_transform();
	const float scale = float(axes.basis.get_scale().y);
	const Vector3 air = runtime.motion.blocking_air_around(
			axes.affine_inverse().xform(root), float(scale > 0.0f ? height / scale : height));
	return axes.basis.orthonormalized().xform(air);
}

void PlantField3D::preview(double delta, const Ref<PlantWind> &blowing) {
	static constexpr double MAX_FRAME_TIME = 3600.0; // s.
	// Tools call it in every frame, like Plant3D's. A field that cannot move stays still without an error.
	if (std::isfinite(delta) && delta >= 0.0 && delta <= MAX_FRAME_TIME && is_inside_tree() && get_plant_count() > 0 &&
			!may_simulate()) {
		runtime.preview(delta, blowing);
	}
}

void PlantField3D::report_bodies() {
	for (const GroupBodies::Event &event : runtime.motion.take_events()) {
		if (Object *body = ObjectDB::get_instance(event.body)) {
			call_deferred("emit_signal", event.has_entered ? "body_entered_plants" : "body_exited_plants", body);
		}
	}
}

void PlantField3D::report_skeleton(Skeleton3D *skeleton, bool is_shown) {
	call_deferred("emit_signal", is_shown ? "skeleton_shown" : "skeleton_hidden", skeleton);
}

int64_t PlantField3D::get_skeleton_plant(const Skeleton3D *skeleton) const {
	const PlantRef place = runtime.skeletons.find(skeleton);
	return place.chunk < 0 ? NO_PLANT : runtime.store.id(place);
}

TypedArray<Skeleton3D> PlantField3D::get_skeletons() const {
	return runtime.skeletons.skeletons();
}

Polygon PlantField3D::outline_polygon() const {
	return read_outline(this, properties);
}

static PackedVector3Array points_of(const Polygon &polygon) {
	PackedVector3Array points;
	for (const glm::vec2 &point : polygon) {
		points.push_back(Vector3(point.x, 0.0f, point.y));
	}
	return points;
}

PackedVector3Array PlantField3D::get_outline_points() const {
	return points_of(outline_polygon());
}

PackedVector3Array PlantField3D::get_exclusion_points(int index) const {
	Polygon polygon;
	if (index >= 0 && index < properties.exclusions.size() && is_inside_tree()) {
		read_exclusion(this, properties, index, polygon);
	}
	return points_of(polygon);
}

void PlantField3D::change_materials() {
	if (runtime.needs_other_meshes()) {
		dirty.mark_style();
	} else {
		runtime.change_materials();
	}
}

// Applies the change of a species' function.
void PlantField3D::update_style(const Ref<PlantFunction> &function) {
	if (function->is_motion_change()) {
		runtime.read_motion(function.ptr(), !may_simulate());
	} else if (function->is_material_change()) {
		change_materials();
	} else {
		dirty.mark_style();
	}
}

// The signal names neither the entry nor the change, so both are searched.
void PlantField3D::on_species_changed() {
	const Ref<PlantFieldSpecies> entry = species.find_emitter();
	if (entry.is_null()) {
		return;
	}
	if (entry->is_species_change()) {
		update_style(entry->get_species());
	} else if (entry->get_change_kind() == PlantFieldSpecies::CHANGE_APPEARANCE) {
		dirty.mark_style();
	} else {
		dirty.mark_placement();
		update_configuration_warnings();
	}
}

// For species of added plants. on_species_changed() handles those that are also in the list.
void PlantField3D::on_added_species_changed() {
	for (const SpeciesStyle &style : runtime.setup.styles) {
		if (style.function.is_valid() && (style.function->is_motion_change() || style.function->is_material_change())) {
			if (runtime.listed_entry(style.function).is_null()) {
				update_style(style.function);
			}
			return;
		}
	}
	dirty.mark_style();
}

void PlantField3D::on_levels_changed() {
	changed(About::levels);
}

void PlantField3D::on_area_changed() {
	dirty.mark_area();
	update_gizmos();
}

void PlantField3D::on_ground_changed() {
	runtime.forget_ground();
	dirty.mark_placement();
}

void PlantField3D::on_wind_changed() {
	update_configuration_warnings();
}

void PlantField3D::on_map_painted(const Rect2 &rect) {
	if (!rect.has_area() || !is_inside_tree() || dirty.is_placement_dirty() || problems.has_fault()) {
		dirty.mark_placement();
		return;
	}
	runtime.touch({ { rect.position.x, rect.position.y }, { rect.get_end().x, rect.get_end().y } });
	frames.follow(true);
	if (runtime.is_building_parts()) {
		frames.queue_end();
	}
	update_gizmos();
}

bool PlantField3D::apply_changes(const PackedByteArray &bytes) {
	species.choose_grass(); // The edits may contain plants of the default grass.
	const bool is_sound = plants.apply_changes(bytes);
	if (is_inside_tree()) {
		frames.follow(runtime.needs_frames());
	}
	return is_sound;
}

void PlantField3D::set_saved_changes(const PackedByteArray &bytes) {
	loaded_changes = bytes;
	is_unread = !bytes.is_empty() && !apply_changes(bytes);
}

PackedByteArray PlantField3D::get_saved_changes() const {
	if (is_unread || !Engine::get_singleton()->is_editor_hint() || properties.map.is_null()) {
		return loaded_changes;
	}
	return plants.has_changes() ? plants.changes() : PackedByteArray();
}

Dictionary PlantField3D::get_statistics() {
	return statistics.to_dictionary(this, runtime, dirty.is_restyle_queued());
}

void PlantField3D::on_frame_drawn() {
	on_frame_ending(); // In a paused tree nothing else calls it.
	runtime.cull();
}

// Binds a method that the engine calls, with an underscore before its name.
#define LISTEN(m_name, ...) ClassDB::bind_method(D_METHOD("_" #m_name, ##__VA_ARGS__), &PlantField3D::m_name)

// Binds the method `m_asked` of PlantQueries.
#define OF_PLANTS(m_name, m_method, ...)                                                                               \
	ClassDB::bind_method(D_METHOD(#m_name, ##__VA_ARGS__), of_plants<&PlantQueries::m_method>(&PlantQueries::m_method))

bool PlantField3D::_set(const StringName &name, const Variant &value) {
	static constexpr double METRES_OF_RATIO = 12.0; // The former default of 3 m is the present one of 0.25.
	if (name == StringName("fade_margin")) {
		return set_renamed_property(
				this, name, std::clamp(double(value) / METRES_OF_RATIO, 0.0, 1.0), { { "fade_margin", "fade_ratio" } });
	}
	return set_renamed_property(this, name, value, { { "kept_changes", "saved_changes" } });
}

void PlantField3D::_bind_methods() {
	ClassDB::bind_static_method("PlantField3D", D_METHOD("from_species", "functions", "weights"),
			&PlantField3D::from_species, DEFVAL(PackedFloat32Array()));
	LISTEN(on_species_changed);
	LISTEN(on_added_species_changed);
	LISTEN(on_levels_changed);
	LISTEN(on_area_changed);
	LISTEN(on_ground_changed);
	LISTEN(on_wind_changed);
	LISTEN(on_map_painted, "rect");
	LISTEN(on_rebuild_queued);
	LISTEN(on_tree_frame);
	LISTEN(on_frame_ending);
	LISTEN(on_physics_frame);
	LISTEN(on_frame_drawn);
	LISTEN(preview, "delta", "wind");
	LISTEN(advise, "text");
	BIND(rebuild);
	BIND(is_building);
	BIND(build_now);
	OF_PLANTS(add_plants, add, "transforms", "species");
	OF_PLANTS(remove_plant, remove, "id");
	OF_PLANTS(remove_plants, remove_all, "ids");
	OF_PLANTS(remove_in_sphere, remove_in_sphere, "center", "radius");
	OF_PLANTS(remove_in_box, remove_in_box, "box");
	OF_PLANTS(remove_in_polygon, remove_in_polygon, "points");
	OF_PLANTS(remove_along, remove_along, "points", "width");
	OF_PLANTS(set_height_in_sphere, set_height_in_sphere, "center", "radius", "height");
	OF_PLANTS(get_changes, changes);
	BIND(apply_changes, "changes");
	BIND(get_plant_count);
	OF_PLANTS(get_plant_ids, ids);
	OF_PLANTS(has_plant, has, "id");
	OF_PLANTS(find_plants_in_box, find_in_box, "box");
	OF_PLANTS(find_plants_in_sphere, find_in_sphere, "center", "radius");
	OF_PLANTS(find_nearest_plant, find_nearest, "point", "max_distance");
	ClassDB::bind_method(D_METHOD("get_species_at", "point", "max_distance"),
			of_plants<&PlantQueries::species_at>(&PlantQueries::species_at), DEFVAL(0.5));
	OF_PLANTS(get_plant_transform, transform, "id");
	OF_PLANTS(get_plant_species, species, "id");
	OF_PLANTS(get_plant_height, height, "id");
	OF_PLANTS(get_plant_seed, seed, "id");
	OF_PLANTS(get_plant_transforms, transforms, "ids");
	OF_PLANTS(get_plant_heights, heights, "ids");
	BIND(get_outline_points);
	BIND(get_exclusion_points, "index");
	BIND(is_point_in_plants, "point");
	OF_PLANTS(apply_impulse_in_sphere, apply_impulse_in_sphere, "center", "radius", "impulse");
	OF_PLANTS(apply_blast, apply_blast, "center", "radius", "impulse");
	ClassDB::bind_method(D_METHOD("trample_in_sphere", "center", "radius", "angle"),
			of_plants<&PlantQueries::trample_in_sphere>(&PlantQueries::trample_in_sphere), DEFVAL(1.2));
	OF_PLANTS(get_tip_position, tip_position, "id");
	OF_PLANTS(get_tip_positions, tip_positions, "ids");
	OF_PLANTS(get_motion_state, motion_state, "ids");
	OF_PLANTS(set_motion_state, set_motion_state, "ids", "state");
	BIND(reset_motion);
	BIND(sample_velocity, "root", "height");
	BIND(get_motion_time);
	OF_PLANTS(get_skeleton, skeleton, "id");
	BIND(get_skeleton_plant, "skeleton");
	BIND(get_skeletons);
	BIND(get_statistics);
	bind_properties();
	ADD_SIGNAL(MethodInfo("build_progressed", PropertyInfo(Variant::FLOAT, "ratio")));
	ADD_SIGNAL(MethodInfo("build_finished"));
	ADD_SIGNAL(MethodInfo("build_failed", PropertyInfo(Variant::STRING, "message")));
	const PropertyInfo body(Variant::OBJECT, "body", PROPERTY_HINT_RESOURCE_TYPE, "Node3D");
	ADD_SIGNAL(MethodInfo("body_entered_plants", body));
	ADD_SIGNAL(MethodInfo("body_exited_plants", body));
	const PropertyInfo skeleton(Variant::OBJECT, "skeleton", PROPERTY_HINT_RESOURCE_TYPE, "Skeleton3D");
	ADD_SIGNAL(MethodInfo("skeleton_shown", skeleton));
	ADD_SIGNAL(MethodInfo("skeleton_hidden", skeleton));
	BIND_ENUM_CONSTANT(GROUND_NONE);
	BIND_ENUM_CONSTANT(GROUND_COLLIDERS);
	BIND_ENUM_CONSTANT(GROUND_MESH);
	BIND_ENUM_CONSTANT(GROUND_OBJECT);
	BIND_ENUM_CONSTANT(GROUND_HIGHEST);
	BIND_ENUM_CONSTANT(GROUND_LOWEST);
}

} // namespace undergrowth
