// PlantField3D's life in the tree. Beside it: _properties.cpp has what users set, _binding.cpp what
// they call.

#include "field/plant_field_3d.hpp"

#include "field/field_areas.hpp"
#include "stopwatch.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/scene_tree.hpp>

#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr int FRAMES_BETWEEN_LOOKS = 8; // At what cannot tell that it changed.
static const char *const FRAME_METHOD = "_on_tree_frame";
static const char *const PHYSICS_METHOD = "_on_physics_frame";

PlantField3D::PlantField3D() :
		meadow(this, properties,
				{ [this](const String &fault) { report_problem(fault); },
						[this](const String &advice) {
							if (std::exchange(no_ground, advice) != advice) {
								update_configuration_warnings();
							}
						},
						[this](float ratio) { emit_signal("fill_progressed", ratio); },
						[this] { emit_signal("filled"); },
						[this](Skeleton3D *skeleton, bool is_shown) { tell_of_skeleton(skeleton, is_shown); } }) {
	follow_species();
}

PlantField3D::~PlantField3D() {
	meadow.motion.wait();
}

PlantField3D *PlantField3D::from_species(const Array &functions, const PackedFloat32Array &shares) {
	PlantField3D *field = memnew(PlantField3D);
	TypedArray<PlantFieldSpecies> entries;
	for (int64_t i = 0; i < functions.size(); i++) {
		const Ref<PlantFunction> function = functions[i];
		if (function.is_null()) {
			report_error(field, "from_species() needs PlantFunctions; entry " + String::num_int64(i) + " is none.");
			continue;
		}
		entries.push_back(PlantFieldSpecies::of(function, i < shares.size() ? double(shares[i]) : 1.0));
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
	PackedStringArray warnings;
	for (const String &fault : { problem, no_ground }) {
		if (!fault.is_empty()) {
			warnings.push_back(fault);
		}
	}
	if (properties.prototypes > 0 && properties.contact_enabled) {
		warnings.push_back("Plants that follow Prototypes do not touch each other: set Prototypes to 0, or Contact "
						   "Enabled off.");
	}
	for (const String &name : forgotten_layers(properties)) {
		warnings.push_back("Of '" + name +
				"' something is painted on its map, and none of its species is called so: name one, or set the Layer "
				"of "
				"its entry.");
	}
	if (properties.wind.is_valid() && properties.wind->get_strength() == 0.0) {
		warnings.push_back(
				"The wind has a strength of 0 N, so these plants stand still: raise Strength in their Wind.");
	}
	return warnings;
}

// Many properties may change in one frame; the field grows once, after it.
void PlantField3D::mark_stale(bool stand) {
	(stand ? stand_is_stale : look_is_stale) = true;
	queue_fill();
}

void PlantField3D::queue_fill() {
	if (is_inside_tree() && !fill_is_queued) {
		fill_is_queued = true;
		call_deferred("_on_fill_queued");
	}
}

void PlantField3D::on_fill_queued() {
	fill_is_queued = false;
	const bool stand = stand_is_stale;
	const bool look = look_is_stale;
	if (!is_inside_tree() || (!stand && !look && !area_is_stale)) {
		return;
	}
	stand_is_stale = look_is_stale = false;
	watch_nodes();
	choose_grass();
	if (std::exchange(area_is_stale, false) && !stand) {
		meadow.follow_area();
	}
	if (stand || look) {
		meadow.fill(stand, look);
	}
	for (const String &name : forgotten_layers(properties)) {
		properties.map->tell_if_unread(name);
	}
	follow_frames(meadow.wants_frames());
}

void PlantField3D::fill() {
	stand_is_stale = look_is_stale = true;
	if (is_inside_tree()) { // Else it grows when it enters the tree.
		on_fill_queued();
	}
}

bool PlantField3D::is_filling() const {
	return meadow.is_filling() || meadow.is_patching() || ((stand_is_stale || area_is_stale) && fill_is_queued);
}

bool PlantField3D::may_simulate() const {
	return properties.simulation_enabled && !Engine::get_singleton()->is_editor_hint();
}

// Growing goes on in a tree that is paused, too: somebody may wait for it behind a loading screen.
void PlantField3D::follow_frames(bool on) {
	SceneTree *tree = get_tree();
	for (const auto &[signal, method] :
			{ std::pair("process_frame", FRAME_METHOD), std::pair("physics_frame", PHYSICS_METHOD) }) {
		const Callable listener(this, method);
		const bool follows = tree->is_connected(signal, listener);
		if (on && !follows) {
			tree->connect(signal, listener);
		} else if (!on && follows) {
			tree->disconnect(signal, listener);
		}
	}
}

// Whoever hears that it is filled may take the field out of the tree.
void PlantField3D::poll(double delta, bool physics) {
	if (!is_fresh()) {
		return; // It was taken out in this very frame, or grows anew, from other properties than it stands by.
	}
	meadow.poll(delta, physics);
	if (is_inside_tree() && !meadow.wants_frames()) {
		follow_frames(false);
	}
}

// After all nodes had their frame, before it is drawn.
void PlantField3D::queue_end() {
	if (meadow.is_patching() && !end_is_queued) {
		end_is_queued = true;
		call_deferred("_on_frame_ending");
	}
}

void PlantField3D::on_frame_ending() {
	end_is_queued = false;
	if (is_fresh()) {
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
		main_usec = wait_usec = 0.0;
		return;
	}
	meadow.motion.wait();
	wait_usec = watch.usec();
	if (meadow.is_patching() && is_fresh()) {
		meadow.follow_strokes(FieldPatches::Moment::begun, get_process_delta_time());
		queue_end();
	}
	if (frames_since_look++ % FRAMES_BETWEEN_LOOKS == 0) {
		look_around();
	}
	const double stepping = meadow.advance(get_process_delta_time(), may_simulate());
	if (may_simulate()) {
		tell_of_bodies();
	}
	main_usec = watch.usec() - wait_usec - stepping;
}

// What the engine does not tell of: its own properties of the node, entries of an array, other nodes' places.
void PlantField3D::look_around() {
	meadow.update_wear({ uint32_t(get_layer_mask()), get_cast_shadows_setting() != SHADOW_CASTING_SETTING_OFF,
			get_transparency() });
	meadow.follow_materials();
	if (get_visibility_range_end() != seen_range) {
		seen_range = get_visibility_range_end();
		changed(About::levels);
	}
	const uint64_t material = get_material_override().is_valid() ? get_material_override()->get_instance_id() : 0;
	if (material != seen_material) {
		seen_material = material;
		meadow.change_materials();
	}
	bool differs = int64_t(seen_species.size()) != listed.size();
	for (size_t i = 0; i < seen_species.size() && !differs; i++) {
		const Object *entry = listed[int64_t(i)];
		differs = (entry ? uint64_t(entry->get_instance_id()) : 0) != seen_species[i];
	}
	if (differs) {
		follow_species();
		mark_stale(true);
	}
	if (seen_exclusions != properties.exclusions) {
		set_exclusions(properties.exclusions);
	}
	if (seen_levels != properties.levels) {
		set_levels(properties.levels);
	}
	if (watched.has_moved(this)) {
		on_area_changed();
	}
	if (watched_ground.has_moved(this)) {
		on_ground_changed();
	}
}

// Outline and exclusions are live: a point that is dragged, a path that is moved, another field that grows.
void PlantField3D::watch_nodes() {
	watched.watch(this, find_area_nodes(this, properties), Callable(this, "_on_area_changed"));
	const NodePath ground = properties.ground_mode == GROUND_MESH ? properties.ground_mesh
			: properties.ground_mode == GROUND_OBJECT			  ? properties.ground_object
																  : NodePath();
	Node3D *node = ground.is_empty() ? nullptr : Object::cast_to<Node3D>(get_node_or_null(ground));
	watched_ground.watch(this, { node }, Callable(this, "_on_ground_changed"));
}

void PlantField3D::_notification(int what) {
	switch (what) {
		case NOTIFICATION_ENTER_TREE:
			set_notify_transform(true);
			set_process_internal(true);
			FieldMonitors::enter(&meadow, this);
			meadow.enter_tree();
			follow_drawing(true);
			if (stand_is_stale || look_is_stale || area_is_stale) {
				queue_fill();
			}
			look_around();
			follow_frames(meadow.wants_frames());
			break;
		case NOTIFICATION_EXIT_TREE:
			follow_frames(false);
			FieldMonitors::leave(&meadow);
			follow_drawing(false);
			meadow.exit_tree();
			break;
		case NOTIFICATION_EXTENSION_RELOADED:
			follow_species();
			look_is_stale = true;
			mark_stale(true);
			break;
		case NOTIFICATION_INTERNAL_PROCESS:
			process_frame();
			break;
		case NOTIFICATION_TRANSFORM_CHANGED:
			meadow.moved();
			if (Engine::get_singleton()->is_editor_hint() && properties.ground_mode != GROUND_NONE) {
				mark_stale(true); // In the editor plants stand on the ground that they are moved to.
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
