#include "nodes/plant_field_3d.hpp"

#include "base/bind_properties.hpp"
#include "base/convert.hpp"
#include "base/follow_changes.hpp"
#include "base/messages.hpp"
#include "base/runs_in_editor.hpp"
#include "base/stopwatch.hpp"
#include "field/build/field_areas.hpp"
#include "field/field_inspector.hpp"
#include "plants/plant_simulation.hpp"

#include <limits>
#include <type_traits>
#include <utility>

using namespace godot;

namespace undergrowth {

PlantField3D::PlantField3D() :
		runtime(this, properties,
				{ [this](const String &fault) { problems.report(fault); },
						[this](const String &fault) { emit_signal("build_failed", fault); },
						[this](const String &advice) { problems.advise(advice); },
						[this](float ratio) { emit_signal("build_progressed", ratio); },
						[this] { emit_signal("build_finished"); },
						[this](Skeleton3D *skeleton, bool is_shown) { report_skeleton(skeleton, is_shown); } }) {
	set_gi_mode(GI_MODE_DISABLED); // Voxels of many small plants are dark spots.
}

PlantField3D::~PlantField3D() {
	runtime.motion.wait();
}

PlantField3D *PlantField3D::from_species(const Array &functions, const PackedFloat32Array &weights) {
	PlantField3D *field = memnew(PlantField3D);
	TypedArray<PlantFieldSpecies> entries;
	for (int64_t i = 0; i < functions.size(); i++) {
		const Ref<PlantFunction> function = functions[i];
		if (function.is_null()) {
			report_error(field, "from_species() needs PlantFunctions; entry " + String::num_int64(i) + " is none.");
			continue;
		}
		entries.push_back(PlantFieldSpecies::of(function, i < weights.size() ? double(weights[i]) : 1.0));
	}
	field->set_species(entries);
	return field;
}

AABB PlantField3D::_get_aabb() const {
	const AABB drawn = runtime.box();
	if (drawn.has_volume()) {
		return drawn;
	}
	const AreaBox area = bounding_box(outline_polygon());
	return AABB(
			Vector3(area.low.x, 0.0f, area.low.y), Vector3(area.high.x - area.low.x, 1.0f, area.high.y - area.low.y));
}

PackedStringArray PlantField3D::_get_configuration_warnings() const {
	return problems.warnings();
}

void PlantField3D::on_rebuild_queued() {
	FieldDirtyFlags::Parts dirty_parts = dirty.take();
	if (!dirty_parts.any()) {
		return;
	}
	if (dirty_parts.placement) {
		const int64_t seed = seed_at(this, properties.seed);
		// Tiles of two seeds do not fit together.
		dirty_parts.style = std::exchange(properties.place_seed, seed) != seed || dirty_parts.style;
	}
	dependencies.watch(this, properties);
	species.choose_grass();
	if (dirty_parts.area && !dirty_parts.placement) {
		runtime.follow_area();
	}
	if (dirty_parts.placement || dirty_parts.style) {
		runtime.rebuild(dirty_parts.placement, dirty_parts.style);
	}
	for (const String &name : forgotten_layers(properties)) {
		properties.map->warn_if_unread(name);
	}
	frames.follow(runtime.needs_frames());
}

void PlantField3D::rebuild() {
	runtime.forget_ground();
	dirty.mark_placement();
	dirty.mark_style();
	if (is_inside_tree()) { // Else it is built when it enters the tree.
		on_rebuild_queued();
	}
}

bool PlantField3D::is_building() const {
	return runtime.is_building() || runtime.is_building_parts() || dirty.is_rebuild_queued();
}

bool PlantField3D::build_now() {
	if (!is_inside_tree()) {
		report_error(this, "build_now() needs the field in the tree. Add it first.");
		return false;
	}
	on_rebuild_queued();
	const bool is_built = runtime.build_now();
	if (is_inside_tree()) {
		frames.follow(runtime.needs_frames());
	}
	return is_built;
}

bool PlantField3D::may_simulate() const {
	return properties.simulation_enabled && !runs_in_editor();
}

bool PlantField3D::begin_frame(uint64_t number) {
	const bool steps = may_simulate() && can_process() && runtime.can_step();
	begun_frame = steps ? number : begun_frame;
	return steps;
}

void PlantField3D::follow_simulation() {
	PlantSimulation *simulation = PlantSimulation::get_singleton();
	if (!simulation || !is_inside_tree()) {
		return;
	}
	simulation->enter(this);
	if (!runs_in_editor()) {
		simulation->follow(get_tree());
	}
}

// A handler of `filled` may remove the field from the tree.
void PlantField3D::poll(double delta, bool physics) {
	if (!dirty.is_clean()) {
		return; // It left the tree in this frame, or a build with other properties is due.
	}
	runtime.poll(delta, physics);
	if (is_inside_tree() && !runtime.needs_frames()) {
		frames.follow(false);
	}
}

void PlantField3D::on_frame_ending() {
	frames.begin_end();
	if (dirty.is_clean()) {
		runtime.follow_strokes(DirtyTiles::Moment::ending, 0.0);
	}
}

void PlantField3D::on_tree_frame() {
	poll(get_process_delta_time(), false);
}

void PlantField3D::on_physics_frame() {
	poll(get_physics_process_delta_time(), true);
}

void PlantField3D::process_frame() {
	const Stopwatch watch;
	if (runtime.is_transferring()) {
		statistics.note_frame(0.0, 0.0);
		return;
	}
	runtime.motion.wait();
	const double waiting = watch.usec();
	if (runtime.is_building_parts() && dirty.is_clean()) {
		runtime.follow_strokes(DirtyTiles::Moment::begun, get_process_delta_time());
		if (runtime.is_building_parts()) {
			frames.queue_end();
		}
	}
	if (dependencies.is_time()) {
		poll_dependencies();
	}
	const bool steps = may_simulate() && begun_frame == PlantSimulation::get_singleton()->frame_steps().frame;
	const double stepping = runtime.advance(get_process_delta_time(), steps);
	if (may_simulate()) {
		problems.report_motion(runtime.motion);
		report_bodies();
	}
	statistics.note_frame(watch.usec() - waiting - stepping, waiting);
}

// Polls what the engine does not report.
void PlantField3D::poll_dependencies() {
	runtime.update_render_flags({ uint32_t(get_layer_mask()), get_cast_shadows_setting() != SHADOW_CASTING_SETTING_OFF,
			get_transparency(), int(get_gi_mode()) });
	runtime.follow_materials();
	const DependencyPoller::Found found = dependencies.poll(this, properties);
	if (found.range) {
		changed(About::levels);
	}
	if (found.material) {
		change_materials();
	}
	if (species.differs()) {
		species.follow();
		dirty.mark_placement();
	}
	if (found.exclusions) {
		set_exclusions(properties.exclusions);
	}
	if (followed_levels.differ(properties.levels)) {
		set_levels(properties.levels);
	}
	if (found.area) {
		on_area_changed();
	}
	if (found.ground) {
		on_ground_changed();
	}
}

void PlantField3D::_notification(int what) {
	switch (what) {
		case NOTIFICATION_ENTER_TREE:
			set_notify_transform(true);
			set_process_internal(true);
			follow_simulation();
			runtime.enter_tree();
			frames.follow_drawing(true);
			dirty.enter_tree();
			poll_dependencies();
			frames.follow(runtime.needs_frames());
			break;
		case NOTIFICATION_ENTER_WORLD:
			runtime.note_world();
			break;
		case NOTIFICATION_EXIT_TREE:
			frames.follow(false);
			if (PlantSimulation *simulation = PlantSimulation::get_singleton()) {
				simulation->leave(this);
			}
			frames.follow_drawing(false);
			runtime.exit_tree();
			break;
		case NOTIFICATION_EXTENSION_RELOADED:
			species.follow();
			if (is_inside_tree()) {
				runtime.enter_tree();
			}
			dirty.mark_style();
			dirty.mark_placement();
			follow_simulation();
			break;
		case NOTIFICATION_INTERNAL_PROCESS:
			process_frame();
			break;
		case NOTIFICATION_TRANSFORM_CHANGED:
			runtime.moved();
			if (runs_in_editor() && properties.ground_mode != GROUND_NONE) {
				dirty.mark_placement(); // In the editor a moved field is built on its new ground.
			}
			break;
		case NOTIFICATION_VISIBILITY_CHANGED:
			runtime.motion.wait();
			runtime.set_visible(is_visible_in_tree());
			break;
		default:
			break;
	}
}

void PlantField3D::changed(About about) {
	if (about == About::meshes && runtime.needs_other_tiles()) {
		about = About::placement;
	}
	const bool needs_meshes = about == About::meshes || (about == About::levels && !runtime.update_levels());
	if (about == About::placement) {
		dirty.mark_placement();
	}
	if (needs_meshes) {
		dirty.mark_style();
	}
	if (about == About::area) {
		on_area_changed();
	}
	if (about == About::skeletons) {
		runtime.skeletons_changed();
	}
	update_configuration_warnings();
}

template <auto slot, const PlantField3D::Setting &setting> void PlantField3D::set(decltype(value_of(slot)) value) {
	using Value = decltype(value);
	bool is_accepted = true;
	if constexpr (std::is_arithmetic_v<Value>) {
		is_accepted = setting.is_angle ? accept_angle(this, setting.name, double(value), setting.range)
									   : accept_value(this, setting.name, double(value), setting.range);
	} else if constexpr (std::is_same_v<Value, Vector2>) {
		const auto accept = setting.is_angle ? accept_angle_span : accept_span;
		is_accepted = accept(this, setting.name, properties.*slot, value, setting.range);
	}
	if (is_accepted && value != properties.*slot) {
		properties.*slot = value;
		changed(setting.about);
	}
}

// A property that is only a value: the effect of a change, its bounds, and its PropertyInfo.
#define NUMBER(m_type, m_name, m_about, m_min, m_max, ...)                                                             \
	{                                                                                                                  \
		static constexpr Setting setting = { #m_name, About::m_about, { m_min, m_max } };                              \
		BIND_PROPERTY(m_type, m_name, "get_" #m_name, (&self_type::set<&FieldProperties::m_name, setting>),            \
				&self_type::get<&FieldProperties::m_name>, ##__VA_ARGS__);                                             \
	}
// The same for an angle or a span of angles, with bounds in degrees.
#define ANGLES(m_type, m_name, m_about, m_min, m_max, ...)                                                             \
	{                                                                                                                  \
		static constexpr Setting setting = { #m_name, About::m_about, { m_min, m_max }, true };                        \
		BIND_PROPERTY(m_type, m_name, "get_" #m_name, (&self_type::set<&FieldProperties::m_name, setting>),            \
				&self_type::get<&FieldProperties::m_name>, ##__VA_ARGS__);                                             \
	}
// The same without bounds.
#define VALUE(m_type, m_name, m_about, ...)                                                                            \
	NUMBER(m_type, m_name, m_about, std::numeric_limits<double>::lowest(),                                             \
			std::numeric_limits<double>::max(), ##__VA_ARGS__)
// A property with its own setter, or with a getter of another name.
#define SET_HERE(m_type, m_name, m_getter_name, ...)                                                                   \
	BIND_PROPERTY(m_type, m_name, m_getter_name, &self_type::set_##m_name,                                             \
			&self_type::get<&FieldProperties::m_name>, ##__VA_ARGS__)

void PlantField3D::bind_properties() {
	ADD_GROUP("Plants", "");
	PROPERTY(ARRAY, species, PROPERTY_HINT_ARRAY_TYPE, "24/17:PlantFieldSpecies");
	NUMBER(FLOAT, density, placement, 0.0, 10000.0, SLIDER("0,100,0.01,or_greater,suffix:plants/m²"));
	VALUE(INT, seed, placement);
	NUMBER(FLOAT, clumping, placement, 0.0, 1.0, SLIDER("0,1,0.01"));
	NUMBER(FLOAT, clump_size, placement, 0.01, 1000.0, SLIDER("0.1,50,0.1,or_greater,suffix:m"));
	NUMBER(FLOAT, combed, placement, 0.0, 1.0, SLIDER("0,1,0.01"));
	NUMBER(FLOAT, competition, placement, 0.0, 1.0, SLIDER("0,1,0.01"));
	ADD_GROUP("Area", "");
	SET_HERE(VECTOR2, size, "get_size", PROPERTY_HINT_NONE, "suffix:m");
	SET_HERE(NODE_PATH, outline, "get_outline", PROPERTY_HINT_NODE_PATH_VALID_TYPES, "Path3D");
	NUMBER(FLOAT, outline_width, area, 0.0, 1000.0, SLIDER("0,20,0.01,or_greater,suffix:m"));
	SET_HERE(OBJECT, map, "get_map", PROPERTY_HINT_RESOURCE_TYPE, "PlantMap");
	SET_HERE(ARRAY, exclusions, "get_exclusions", PROPERTY_HINT_ARRAY_TYPE, "22/35:Path3D,PlantField3D");
	SET_HERE(PACKED_FLOAT32_ARRAY, exclusion_widths, "get_exclusion_widths", PROPERTY_HINT_NONE, "suffix:m");
	NUMBER(FLOAT, edge_falloff, placement, 0.0, 100.0, SLIDER("0,5,0.01,or_greater,suffix:m"));
	SET_HERE(FLOAT, view_distance, "get_view_distance", SLIDER("0,500,1,or_greater,suffix:m"));
	SET_HERE(BOOL, endless, "is_endless");
	VALUE(ARRAY, streaming_targets, nothing, PROPERTY_HINT_ARRAY_TYPE, "22/35:Node3D");
	ADD_GROUP("Ground", "");
	PROPERTY(INT, ground_mode, PROPERTY_HINT_ENUM, "None,Colliders,Mesh,Object");
	PROPERTY(INT, ground_choice, PROPERTY_HINT_ENUM, "Highest,Lowest");
	VALUE(INT, ground_collision_mask, placement, PROPERTY_HINT_LAYERS_3D_PHYSICS);
	VALUE(NODE_PATH, ground_mesh, placement, PROPERTY_HINT_NODE_PATH_VALID_TYPES, "MeshInstance3D");
	VALUE(NODE_PATH, ground_object, placement);
	NUMBER(FLOAT, ground_sample_spacing, placement, 0.0, 100.0, SLIDER("0,4,0.01,or_greater,suffix:m"));
	NUMBER(VECTOR2, height_limits, placement, -1e6, 1e6, PROPERTY_HINT_NONE, "suffix:m");
	ANGLES(VECTOR2, slope_limits, placement, 0.0, 180.0, SLIDER("0,180,0.1,radians_as_degrees"));
	NUMBER(FLOAT, slope_alignment, placement, 0.0, 1.0, SLIDER("0,1,0.01"));
	ANGLES(FLOAT, sun_latitude, placement, -90.0, 90.0, SLIDER("-90,90,0.1,radians_as_degrees"));
	ADD_GROUP("Motion", "");
	SET_HERE(OBJECT, wind, "get_wind", PROPERTY_HINT_RESOURCE_TYPE, "PlantWind");
	NUMBER(FLOAT, apparent_wind, nothing, 0.0, 10.0, SLIDER("0,1,0.01,or_greater"));
	SET_HERE(BOOL, simulation_enabled, "is_simulation_enabled");
	NUMBER(INT, max_threads, nothing, 0.0, 256.0, SLIDER("0,16,1,or_greater"));
	SET_HERE(INT, update_interval, "get_update_interval", SLIDER("1,64,1"));
	NUMBER(FLOAT, far_distance, nothing, 0.0, 1e6, SLIDER("0,200,0.1,or_greater,suffix:m"));
	NUMBER(INT, prototypes, meshes, 0.0, 64.0, SLIDER("0,64,1"));
	SET_HERE(BOOL, contact_enabled, "is_contact_enabled");
	VALUE(STRING_NAME, bodies_group, nothing);
	NUMBER(FLOAT, touch_margin, nothing, 0.0, 100.0, SLIDER("0,2,0.01,or_greater,suffix:m"));
	NUMBER(FLOAT, regrowth_rate, nothing, 0.0, 1000.0, SLIDER("0,1,0.001,or_greater,suffix:1/s"));
	ADD_GROUP("Drawing", "");
	SET_HERE(ARRAY, levels, "get_levels", PROPERTY_HINT_ARRAY_TYPE, "24/17:PlantFieldLevel");
	NUMBER(FLOAT, pixel_error, levels, 0.0, 100.0, SLIDER("0,16,0.1,or_greater,suffix:px"));
	NUMBER(FLOAT, fade_ratio, levels, 0.0, 1.0, SLIDER("0,1,0.01"));
	NUMBER(FLOAT, shadow_distance, levels, 0.0, 1e6, SLIDER("0,200,0.1,or_greater,suffix:m"));
	NUMBER(FLOAT, skeleton_distance, skeletons, 0.0, 1e6, SLIDER("0,20,0.1,or_greater,suffix:m"));
	NUMBER(INT, max_skeletons, skeletons, 0.0, 1024.0, SLIDER("0,1024,1"));
	NUMBER(FLOAT, tile_size, meshes, 1.0, 1000.0, SLIDER("4,100,0.1,or_greater,suffix:m"));
	ADD_GROUP("Building", "");
	NUMBER(FLOAT, build_budget_msec, nothing, 0.1, 1000.0, SLIDER("0.1,16,0.1,or_greater,suffix:ms"));
	// After the properties that decide the ids of plants.
	PROPERTY(PACKED_BYTE_ARRAY, saved_changes, PROPERTY_HINT_NONE, "", PROPERTY_USAGE_STORAGE);
}

void PlantField3D::_validate_property(PropertyInfo &property) const {
	if (!shows_in_inspector(property.name, properties)) {
		property.usage &= ~uint32_t(PROPERTY_USAGE_EDITOR);
	}
}

void PlantField3D::set_contact_enabled(bool on) {
	properties.contact_enabled = on;
	update_configuration_warnings();
	runtime.motion.fit_contact(on);
}

void PlantField3D::set_simulation_enabled(bool on) {
	properties.simulation_enabled = on;
	if (!on) {
		runtime.refresh(); // Draws the result of the last step.
	}
}

void PlantField3D::set_update_interval(int step_count) {
	if (accept_value(this, "update_interval", step_count, { 1, 64 })) {
		properties.update_interval = step_count;
		runtime.motion.set_update_interval(step_count);
	}
}

void PlantField3D::set_wind(const Ref<PlantWind> &wind) {
	const Callable listener(this, "_on_wind_changed");
	unfollow_changes(properties.wind.ptr(), listener);
	properties.wind = wind;
	follow_changes(properties.wind.ptr(), listener);
	update_configuration_warnings();
}

void PlantField3D::set_size(const Vector2 &metres) {
	static constexpr Range SIZE_RANGE = { 0.0, 1e5 };
	if (accept_value(this, "size", metres.x, SIZE_RANGE) && accept_value(this, "size", metres.y, SIZE_RANGE) &&
			metres != properties.size) {
		properties.size = metres;
		dirty.mark_placement();
		update_gizmos();
	}
}

void PlantField3D::set_outline(const NodePath &path) {
	if (path == properties.outline) {
		return;
	}
	properties.outline = path;
	notify_property_list_changed();
	dirty.mark_placement();
	update_gizmos();
}

void PlantField3D::set_map(const Ref<PlantMap> &painted) {
	if (painted == properties.map) {
		return;
	}
	const Callable listener(this, "_on_map_painted");
	if (properties.map.is_valid()) {
		follow_signal(properties.map.ptr(), "area_changed", listener, false);
	}
	properties.map = painted;
	if (painted.is_valid()) {
		follow_signal(properties.map.ptr(), "area_changed", listener);
	}
	notify_property_list_changed();
	dirty.mark_placement();
	update_gizmos();
	update_configuration_warnings();
}

void PlantField3D::set_view_distance(double metres) {
	if (accept_value(this, "view_distance", metres, { 0.0, 1e4 }) && metres != properties.view_distance) {
		const bool is_other_kind = (metres > 0.0) != runtime.streams();
		properties.view_distance = metres;
		if (is_other_kind) {
			dirty.mark_placement();
		}
		update_configuration_warnings();
	}
}

void PlantField3D::set_endless(bool on) {
	if (on == properties.endless) {
		return;
	}
	properties.endless = on;
	notify_property_list_changed();
	dirty.mark_placement();
	update_gizmos();
}

// Scripts may also have appended to the array, so it may differ from the stored one.
void PlantField3D::set_exclusions(const TypedArray<NodePath> &paths) {
	properties.exclusions = paths.duplicate();
	if (dependencies.has_other_exclusions(properties)) {
		dependencies.store_exclusions(properties);
		dirty.mark_placement();
	}
}

void PlantField3D::set_exclusion_widths(const PackedFloat32Array &metres) {
	static constexpr Range WIDTH_RANGE = { 0.0, 1000.0 };
	bool are_accepted = true;
	for (int64_t i = 0; i < metres.size() && are_accepted; i++) {
		are_accepted = accept_value(this, "exclusion_widths", metres[i], WIDTH_RANGE);
	}
	if (are_accepted && metres != properties.exclusion_widths) {
		properties.exclusion_widths = metres;
		on_area_changed();
	}
}

void PlantField3D::set_ground_mode(GroundMode mode) {
	if (mode < GROUND_NONE || mode > GROUND_OBJECT) {
		report_error(
				this, "ground_mode " + String::num_int64(mode) + " does not exist. Use one of the GROUND_ constants.");
	} else if (int(mode) != properties.ground_mode) {
		properties.ground_mode = int(mode);
		notify_property_list_changed();
		dirty.mark_placement();
	}
}

void PlantField3D::set_ground_choice(GroundHeight choice) {
	if (choice != GROUND_HIGHEST && choice != GROUND_LOWEST) {
		report_error(this, "ground_choice must be GROUND_HIGHEST or GROUND_LOWEST; the old value stays.");
	} else if (int(choice) != properties.ground_choice) {
		properties.ground_choice = int(choice);
		dirty.mark_placement();
	}
}

void PlantField3D::set_species(const TypedArray<PlantFieldSpecies> &entries) {
	if (species.set(entries)) {
		dirty.mark_placement();
		update_configuration_warnings();
	}
}

void PlantField3D::set_levels(const TypedArray<PlantFieldLevel> &entries) {
	properties.levels = entries.duplicate();
	followed_levels.follow(properties.levels, Callable(this, "_on_levels_changed"));
	on_levels_changed();
}

PlantCanopy PlantField3D::canopy_around(const Vector3 &place, const Ref<PlantFunction> &function, float height) const {
	int own = -1;
	for (size_t i = 0; i < runtime.setup.styles.size(); i++) {
		own = runtime.setup.styles[i].function == function ? int(i) : own;
	}
	const Transform3D global = get_global_transform();
	const float scale = float(global.basis.get_scale().y);
	PlantCanopy found = runtime.motion.canopy_around(
			to_glm(global.affine_inverse().xform(place)), scale > 0.0f ? height / scale : height, own);
	found.height *= scale;
	found.taller.height *= scale;
	return found;
}

} // namespace undergrowth
