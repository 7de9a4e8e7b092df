// PlantClimber3D: growth, notifications of the tree, and its supports.

#include "nodes/plant_climber_3d.hpp"

#include "base/convert.hpp"
#include "base/frame_cost.hpp"
#include "base/renderer.hpp"
#include "base/runs_in_editor.hpp"
#include "base/stopwatch.hpp"
#include "base/world_of.hpp"
#include "climb/surface_grid.hpp"
#include "field/build/build_input.hpp"
#include "plants/plant_simulation.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/resource_loader.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static const char *const READY_LEAF = "res://addons/undergrowth/climbers/ivy_leaf.tres";
static constexpr float MOVED = 1e-4f; // m, and of unit axes.

PlantClimber3D::~PlantClimber3D() {
	task.wait();
	if (PlantSimulation *simulation = PlantSimulation::get_singleton()) {
		simulation->leave(&motion);
	}
}

void PlantClimber3D::_notification(int what) {
	switch (what) {
		case NOTIFICATION_ENTER_TREE:
			set_process_internal(true);
			followed = get_global_transform();
			view.set_owner(uint64_t(get_instance_id()));
			if (is_dirty) {
				rebuild_call.queue(); // The supports may enter the tree after it.
			}
			break;
		case NOTIFICATION_ENTER_WORLD:
			view.set_world(get_world_3d()->get_scenario());
			view.set_visible(is_visible_in_tree());
			update_motion();
			break;
		case NOTIFICATION_EXIT_WORLD:
			view.set_world(RID());
			break;
		case NOTIFICATION_EXIT_TREE:
			if (PlantSimulation *simulation = PlantSimulation::get_singleton()) {
				simulation->leave(&motion);
			}
			break;
		case NOTIFICATION_EXTENSION_RELOADED:
			set_process_internal(true);
			mark_dirty();
			break;
		case NOTIFICATION_INTERNAL_PROCESS:
			process_frame();
			break;
		case NOTIFICATION_VISIBILITY_CHANGED:
			view.set_visible(is_visible_in_tree());
			break;
		case NOTIFICATION_PAUSED:
		case NOTIFICATION_UNPAUSED:
		case NOTIFICATION_DISABLED:
		case NOTIFICATION_ENABLED:
			update_simulation();
			break;
		default:
			break;
	}
}

void PlantClimber3D::report_problem(const String &what) {
	if (what != problem) { // Reports each fault once for any number of builds.
		problem = what;
		if (!what.is_empty()) {
			report_error(this, problem);
		}
		update_configuration_warnings();
	}
}

Ref<PlantFunction> PlantClimber3D::used_species() const {
	return species.is_valid() ? species : Ref<PlantFunction>(ResourceLoader::get_singleton()->load(READY_LEAF));
}

// Many properties may change in one frame. It grows once, after the end of the frame.
void PlantClimber3D::mark_dirty() {
	is_dirty = true;
	if (is_inside_tree()) {
		rebuild_call.queue();
	}
}

void PlantClimber3D::on_rebuild_queued() {
	rebuild_call.begin();
	if (is_dirty && is_inside_tree() && !build) { // A growing plant grows again when it has ended.
		start();
	}
}

bool PlantClimber3D::rebuild() {
	if (!is_inside_tree()) {
		report_error(this, "rebuild() needs the node in the scene tree. Add it first.");
		return false;
	}
	if (build) {
		is_dirty = true;
		return true;
	}
	return start();
}

String PlantClimber3D::prepare(ClimberBuild &into) {
	const Ref<PlantFunction> leaf = used_species();
	if (leaf.is_null()) {
		return "has no species, and " + String(READY_LEAF) + " is missing. Set species to a PlantFunction of one leaf.";
	}
	for (size_t i = 0; i < CLIMBER_LEVELS.size(); i++) {
		const String fault = leaf->sample(0.0, CLIMBER_LEVELS[i].segments, seed, into.leaf[i]);
		if (!fault.is_empty()) {
			return describe(leaf.ptr()) + ": " + fault;
		}
		if (!into.leaf[i].grown) {
			return describe(leaf.ptr()) + ": leaves need a species of parts. Use one with arrangements or _grow().";
		}
	}
	growing = rigid(get_global_transform());
	const Basis to_growth = growing.basis.transposed();
	into.settings = settings;
	into.settings.seed = uint64_t(seed);
	into.settings.light = to_glm(to_growth.xform(light_direction));
	into.settings.down = to_glm(to_growth.xform(Vector3(0.0f, -1.0f, 0.0f)));
	const Transform3D from_node = growing.affine_inverse() * get_global_transform();
	for (const Vector3 &point : path) {
		into.settings.path.push_back(to_glm(from_node.xform(point)));
	}
	into.leaf_scale = float(leaf_size);
	into.makes_meshes = renders_on_threads() && Workers::are_used();
	into.reads_half_floats = !is_compatibility();
	shown_species = leaf;
	shown_height = into.leaf[0].height;
	return growing_bodies.read(this, supports, growing, into.faces);
}

bool PlantClimber3D::start() {
	const Stopwatch watch;
	is_dirty = false;
	auto made = std::make_unique<ClimberBuild>();
	const String fault = prepare(*made);
	if (!fault.is_empty()) {
		report_problem(fault);
		return false;
	}
	build = std::move(made);
	ClimberBuild *working = build.get();
	main_thread_usec = watch.usec();
	task.start([working] { working->run(); });
	return true;
}

void PlantClimber3D::adopt() {
	const Stopwatch watch;
	task.wait();
	const std::unique_ptr<ClimberBuild> grown = std::move(build);
	grow_usec = 1e6 * grown->seconds;
	report_problem(String::utf8(grown->fault.c_str()));
	if (grown->fault.empty()) {
		bodies = growing_bodies;
		growth = growing;
		leaves = grown->climb.leaves;
		cells_of_leaves = grown->cells.of_leaves;
		stem_length = grown->climb.total_length;
		list_levels(*grown);
		stem_vertices = grown->stem_vertices;
		view.show(*grown, shown_species->get_material(), kind_of_motion(shown_species, shown_height));
		places.assign(size_t(bodies.count()), growth);
		motion.set_cells(grown->cells.cells, places, growth.origin.y);
		update_motion();
		bodies.follow();
		place_all();
		followed = get_global_transform();
		if (Engine::get_singleton()->is_editor_hint()) {
			update_gizmos();
		}
	}
	main_thread_usec += watch.usec();
	emit_signal("grown");
	if (is_dirty) {
		rebuild_call.queue();
	}
}

void PlantClimber3D::list_levels(const ClimberBuild &grown) {
	levels.clear();
	for (size_t i = 0; i < CLIMBER_LEVELS.size(); i++) {
		Dictionary level;
		level["begin"] = double(grown.begins[i]);
		level["share"] = double(CLIMBER_LEVELS[i].share);
		level["leaf_vertices"] = grown.leaf_vertices[i];
		levels.push_back(level);
	}
}

void PlantClimber3D::process_frame() {
	if (build && !task.is_running()) {
		adopt();
	}
	follow_supports();
}

static bool is_near(const Transform3D &one, const Transform3D &other) {
	float apart = float(one.origin.distance_to(other.origin));
	for (int i = 0; i < 3; i++) {
		apart = std::max(apart, float(one.basis.get_column(i).distance_to(other.basis.get_column(i))));
	}
	return apart < MOVED;
}

// The node follows the body at its root, so that a saved scene grows the same plant. If only the node was moved, in the
// editor, the plant grows at its new root.
void PlantClimber3D::follow_supports() {
	const bool has_moved = bodies.follow();
	const Transform3D own = get_global_transform();
	if (has_moved) {
		const Transform3D step = bodies.step(0);
		if (is_near(own, followed) && !is_near(own, step * followed)) {
			set_global_transform(step * followed);
		}
		place_all();
	} else if (runs_in_editor() && bodies.count() > 0 && !is_near(own, followed)) {
		mark_dirty();
	}
	followed = get_global_transform();
}

void PlantClimber3D::place_all() {
	places.clear();
	for (int i = 0; i < bodies.count(); i++) {
		places.push_back(bodies.moved(i) * growth);
	}
	view.place(places);
	if (!motion.is_empty()) {
		motion.place(places);
	}
}

MotionSpecies PlantClimber3D::kind_of_motion(const Ref<PlantFunction> &of, float height) const {
	MotionSpecies kind;
	kind.law = Law(int(of->get_law()));
	kind.joint = of->make_joint(Basis());
	kind.collision_radius = 0.0f;
	if (const std::shared_ptr<const StemConstants> stem = of->find_stem(height, PlantWind::is_air(wind))) {
		kind.stem = *stem;
	}
	return kind;
}

void PlantClimber3D::update_motion() {
	if (shown_species.is_null() || motion.is_empty()) {
		return;
	}
	wind_is_air = PlantWind::is_air(wind);
	ClimberMotion::Setup changed;
	changed.species = kind_of_motion(shown_species, shown_height);
	changed.rest = shown_species->resting_bend();
	changed.length = shown_height * float(leaf_size);
	changed.wind = wind;
	changed.world = world_of(this);
	motion.set_up(changed);
	motion.show_in(view.leaf_material());
	update_simulation();
}

bool PlantClimber3D::may_simulate() const {
	return simulation_enabled && is_inside_tree() && !motion.is_empty() && can_process() &&
			!Engine::get_singleton()->is_editor_hint();
}

void PlantClimber3D::update_simulation() {
	PlantSimulation *simulation = PlantSimulation::get_singleton();
	if (simulation && may_simulate()) {
		simulation->follow(get_tree());
		simulation->enter(&motion);
	} else if (simulation) {
		simulation->leave(&motion);
	}
}

Transform3D PlantClimber3D::get_leaf_transform(int leaf) const {
	if (leaf < 0 || leaf >= int(leaves.size())) {
		report_error(this,
				"get_leaf_transform(" + String::num_int64(leaf) + ") needs a leaf from 0 to get_leaf_count() - 1.");
		return Transform3D();
	}
	const ClimbLeaf &one = leaves[size_t(leaf)];
	const float scale = float(leaf_size) * one.size;
	const Basis axes(
			to_godot(glm::cross(one.out, one.down)) * scale, to_godot(one.out) * scale, to_godot(one.down) * scale);
	return places[size_t(one.body)] * Transform3D(axes, to_godot(one.place));
}

double PlantClimber3D::get_leaf_deflection(int leaf) const {
	if (leaf < 0 || leaf >= int(leaves.size())) {
		report_error(this,
				"get_leaf_deflection(" + String::num_int64(leaf) + ") needs a leaf from 0 to get_leaf_count() - 1.");
		return 0.0;
	}
	return 2.0 * std::atan(double(motion.bend_of(cells_of_leaves[size_t(leaf)]).length()));
}

AABB PlantClimber3D::get_reach() const {
	return view.box();
}

Dictionary PlantClimber3D::get_statistics() const {
	Dictionary all;
	all["grow_usec"] = grow_usec;
	all["main_thread_usec"] = main_thread_usec;
	all["leaves"] = int(leaves.size());
	all["levels"] = levels.duplicate(true);
	all["stem_vertices"] = stem_vertices;
	all["instances"] = view.instance_count();
	all["stem_length"] = double(stem_length);
	return all;
}

void PlantClimber3D::reset_motion() {
	motion.settle();
}

Variant PlantClimber3D::pick(const Vector3 &from, const Vector3 &direction, bool is_first) {
	if (is_first) {
		std::vector<SupportFaces> faces;
		ClimberSupports reader;
		picked = reader.read(this, supports, Transform3D(), faces).is_empty() ? join_faces(faces) : ClimbSupport();
	}
	glm::vec3 place(0.0f);
	return first_on_ray(picked, to_glm(from), to_glm(direction), place) ? Variant(to_godot(place)) : Variant();
}

void PlantClimber3D::preview(double delta, const Ref<PlantWind> &blowing) {
	if (std::isfinite(delta) && delta >= 0.0 && delta < 1.0 && !motion.is_empty() && !may_simulate()) {
		motion.preview(delta, blowing);
	}
}

} // namespace undergrowth
