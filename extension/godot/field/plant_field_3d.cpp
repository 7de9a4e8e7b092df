// PlantField3D in the scene tree. _properties.cpp has its properties, and _binding.cpp the methods for scripts.

#include "field/plant_field_3d.hpp"

#include "field/field_areas.hpp"
#include "messages.hpp"
#include "runs_in_editor.hpp"
#include "stopwatch.hpp"

#include <utility>

using namespace godot;

namespace undergrowth {

PlantField3D::PlantField3D() :
		meadow(this, properties,
				{ [this](const String &fault) { problems.report(fault); },
						[this](const String &fault) { emit_signal("build_failed", fault); },
						[this](const String &advice) { problems.advise(advice); },
						[this](float ratio) { emit_signal("build_progressed", ratio); },
						[this] { emit_signal("build_finished"); },
						[this](Skeleton3D *skeleton, bool is_shown) { tell_of_skeleton(skeleton, is_shown); } }) {}

PlantField3D::~PlantField3D() {
	meadow.motion.wait();
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
	const AABB drawn = meadow.box();
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

void PlantField3D::on_fill_queued() {
	FieldStaleness::Parts stale = staleness.take();
	if (!stale.any()) {
		return;
	}
	if (stale.stand) {
		const int64_t seed = seed_at(this, properties.seed);
		// Tiles of two seeds do not fit together.
		stale.look = std::exchange(properties.place_seed, seed) != seed || stale.look;
	}
	untold.watch(this, properties);
	species.choose_grass();
	if (stale.area && !stale.stand) {
		meadow.follow_area();
	}
	if (stale.stand || stale.look) {
		meadow.fill(stale.stand, stale.look);
	}
	for (const String &name : forgotten_layers(properties)) {
		properties.map->tell_if_unread(name);
	}
	frames.follow(meadow.wants_frames());
}

void PlantField3D::rebuild() {
	staleness.mark_stand();
	staleness.mark_look();
	if (is_inside_tree()) { // Else it is built when it enters the tree.
		on_fill_queued();
	}
}

bool PlantField3D::is_building() const {
	return meadow.is_building() || meadow.is_patching() || staleness.grows_soon();
}

bool PlantField3D::build_now() {
	if (!is_inside_tree()) {
		report_error(this, "build_now() needs the field in the tree. Add it first.");
		return false;
	}
	on_fill_queued();
	const bool is_built = meadow.build_now();
	if (is_inside_tree()) {
		frames.follow(meadow.wants_frames());
	}
	return is_built;
}

bool PlantField3D::may_simulate() const {
	return properties.simulation_enabled && !runs_in_editor();
}

// A handler of `filled` may remove the field from the tree.
void PlantField3D::poll(double delta, bool physics) {
	if (!staleness.is_fresh()) {
		return; // It left the tree in this frame, or a build with other properties is due.
	}
	meadow.poll(delta, physics);
	if (is_inside_tree() && !meadow.wants_frames()) {
		frames.follow(false);
	}
}

void PlantField3D::on_frame_ending() {
	frames.begin_end();
	if (staleness.is_fresh()) {
		meadow.follow_strokes(FieldPatches::Moment::ending, 0.0);
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
	if (meadow.is_handing_over()) {
		statistics.note_frame(0.0, 0.0);
		return;
	}
	meadow.motion.wait();
	const double waiting = watch.usec();
	if (meadow.is_patching() && staleness.is_fresh()) {
		meadow.follow_strokes(FieldPatches::Moment::begun, get_process_delta_time());
		if (meadow.is_patching()) {
			frames.queue_end();
		}
	}
	if (untold.is_time()) {
		look_around();
	}
	const double stepping = meadow.advance(get_process_delta_time(), may_simulate());
	if (may_simulate()) {
		problems.tell_of(meadow.motion);
		tell_of_bodies();
	}
	statistics.note_frame(watch.usec() - waiting - stepping, waiting);
}

// Polls what the engine does not report.
void PlantField3D::look_around() {
	meadow.update_wear({ uint32_t(get_layer_mask()), get_cast_shadows_setting() != SHADOW_CASTING_SETTING_OFF,
			get_transparency() });
	meadow.follow_materials();
	const UntoldChanges::Found found = untold.look(this, properties);
	if (found.range) {
		changed(About::levels);
	}
	if (found.material) {
		meadow.change_materials();
	}
	if (species.differs()) {
		species.follow();
		staleness.mark_stand();
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
			FieldMonitors::enter(&meadow, this);
			meadow.enter_tree();
			frames.follow_drawing(true);
			staleness.enter_tree();
			look_around();
			frames.follow(meadow.wants_frames());
			break;
		case NOTIFICATION_ENTER_WORLD:
			meadow.note_world();
			break;
		case NOTIFICATION_EXIT_TREE:
			frames.follow(false);
			FieldMonitors::leave(&meadow);
			frames.follow_drawing(false);
			meadow.exit_tree();
			break;
		case NOTIFICATION_EXTENSION_RELOADED:
			species.follow();
			staleness.mark_look();
			staleness.mark_stand();
			break;
		case NOTIFICATION_INTERNAL_PROCESS:
			process_frame();
			break;
		case NOTIFICATION_TRANSFORM_CHANGED:
			meadow.moved();
			if (runs_in_editor() && properties.ground_mode != GROUND_NONE) {
				staleness.mark_stand(); // In the editor a moved field is built on its new ground.
			}
			break;
		case NOTIFICATION_VISIBILITY_CHANGED:
			meadow.motion.wait();
			meadow.set_visible(is_visible_in_tree());
			break;
		default:
			break;
	}
}

} // namespace undergrowth
