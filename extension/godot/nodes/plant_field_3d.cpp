// PlantField3D in the scene tree. _properties.cpp has its properties, and _binding.cpp the methods for scripts.

#include "nodes/plant_field_3d.hpp"

#include "base/messages.hpp"
#include "base/runs_in_editor.hpp"
#include "base/stopwatch.hpp"
#include "field/build/field_areas.hpp"

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
						[this](Skeleton3D *skeleton, bool is_shown) { report_skeleton(skeleton, is_shown); } }) {}

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
	dirty.mark_placement();
	dirty.mark_style();
	if (is_inside_tree()) { // Else it is built when it enters the tree.
		on_rebuild_queued();
	}
}

bool PlantField3D::is_building() const {
	return runtime.is_building() || runtime.is_building_regions() || dirty.is_rebuild_queued();
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
		runtime.follow_strokes(RegionBuilds::Moment::ending, 0.0);
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
	if (runtime.is_building_regions() && dirty.is_clean()) {
		runtime.follow_strokes(RegionBuilds::Moment::begun, get_process_delta_time());
		if (runtime.is_building_regions()) {
			frames.queue_end();
		}
	}
	if (dependencies.is_time()) {
		poll_dependencies();
	}
	const double stepping = runtime.advance(get_process_delta_time(), may_simulate());
	if (may_simulate()) {
		problems.report_motion(runtime.motion);
		report_bodies();
	}
	statistics.note_frame(watch.usec() - waiting - stepping, waiting);
}

// Polls what the engine does not report.
void PlantField3D::poll_dependencies() {
	runtime.update_render_flags({ uint32_t(get_layer_mask()), get_cast_shadows_setting() != SHADOW_CASTING_SETTING_OFF,
			get_transparency() });
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
			FieldMonitors::enter(&runtime, this);
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
			FieldMonitors::leave(&runtime);
			frames.follow_drawing(false);
			runtime.exit_tree();
			break;
		case NOTIFICATION_EXTENSION_RELOADED:
			species.follow();
			dirty.mark_style();
			dirty.mark_placement();
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

} // namespace undergrowth
