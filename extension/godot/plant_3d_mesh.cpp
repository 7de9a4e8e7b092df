// The half of Plant3D that builds what is drawn: mesh, skin, skeleton and the box around all deflections.

#include "plant_3d.hpp"

#include "as_written.hpp"
#include "new_object.hpp"
#include "shared_resources.hpp"

#include <godot_cpp/classes/engine.hpp>

using namespace godot;

namespace undergrowth {

static const char *const SKELETON_NAME = "PlantSkeleton";
static const char *const MESH_NAME = "PlantMesh";

void Plant3D::report_problem(const String &what) {
	if (what != problem) { // The same fault is told once, however often the plant is built.
		problem = what;
		report_error(this, problem);
		update_configuration_warnings();
	}
}

// Many properties may change in one frame; the mesh is built once, at its end.
void Plant3D::mark_stale() {
	mesh_is_stale = true;
	if (is_inside_tree() && !rebuild_is_queued) {
		rebuild_is_queued = true;
		call_deferred("_on_rebuild_queued");
	}
}

void Plant3D::on_rebuild_queued() {
	rebuild_is_queued = false;
	if (mesh_is_stale && species.is_valid()) {
		build_mesh();
	}
}

bool Plant3D::rebuild() {
	if (species.is_null()) {
		report_problem("cannot be built without a species. Set a PlantFunction.");
		return false;
	}
	return build_mesh();
}

bool Plant3D::build_mesh() {
	mesh_is_stale = false;
	SampledPlant sampled;
	const String fault = species->sample(height, segments, seed, sampled);
	sampled.has_part_bones = true;
	if (!fault.is_empty()) {
		report_problem(describe(species.ptr()) + ": " + fault);
		return false;
	}
	if (!problem.is_empty()) {
		problem = String();
		update_configuration_warnings();
	}
	mesh = sampled.build();
	bone().parts = nullptr;
	parts = PartSkeleton::of(sampled);
	built_height = sampled.height;
	show_mesh();
	update_motion();
	emit_signal("mesh_changed");
	return true;
}

void Plant3D::find_children() {
	skeleton = Object::cast_to<Skeleton3D>(get_node_or_null(SKELETON_NAME));
	bone().posed = glm::vec3(NAN); // Whatever the bone shows now, the next pose is set.
	skeleton_is_held = true; // Perhaps.
	const Node *found = skeleton ? skeleton->get_node_or_null(MESH_NAME) : nullptr;
	mesh_instance = found ? uint64_t(found->get_instance_id()) : 0;
}

// A script may free or take away what get_skeleton() gave it. The plant grows anew at the end of the frame.
void Plant3D::lose_skeleton() {
	if (skeleton && skeleton->get_parent() != this) {
		skeleton = nullptr;
		mesh_instance = 0;
		find_drawn();
		mark_stale();
	}
}

// Known once the mesh instance is in the tree.
void Plant3D::find_drawn() {
	const MeshInstance3D *shown = get_mesh_instance();
	drawn = shown ? shown->get_skin_reference() : Ref<SkinReference>();
	update_bone();
}

MeshInstance3D *Plant3D::get_mesh_instance() const {
	return Object::cast_to<MeshInstance3D>(ObjectDB::get_instance(mesh_instance));
}

void Plant3D::make_children() {
	skeleton = new_node<Skeleton3D>();
	skeleton->set_name(SKELETON_NAME);
	bone().posed = { 0.0f, 1.0f, 0.0f };
	skeleton_is_held = false;
	make_mesh_instance();
	add_child(skeleton, false, INTERNAL_MODE_FRONT);
}

void Plant3D::make_mesh_instance() {
	MeshInstance3D *made = new_node<MeshInstance3D>();
	made->set_name(MESH_NAME);
	skeleton->add_child(made, false, INTERNAL_MODE_FRONT);
	made->set_skeleton_path(NodePath(".."));
	mesh_instance = made->get_instance_id();
}

// The skeleton is bound anew, and stands anew as it did.
void Plant3D::set_up_bones() {
	const bool is_other = parts || skeleton->get_bone_count() != PartSkeleton::count(nullptr);
	PartSkeleton::set_up(skeleton, parts.get());
	get_mesh_instance()->set_skin(PartSkeleton::skin_of(parts.get()));
	if (is_other) {
		bone().posed = glm::vec3(NAN);
	}
}

void Plant3D::show_mesh() {
	if (!skeleton) {
		find_children(); // A reloaded library finds the children that its former self made.
	}
	if (!skeleton) {
		make_children();
	} else if (!get_mesh_instance()) {
		make_mesh_instance();
	}
	set_up_bones();
	get_mesh_instance()->set_mesh(mesh);
	get_mesh_instance()->set_custom_aabb(reach());
	find_drawn();
	if (Engine::get_singleton()->is_editor_hint()) {
		update_gizmos(); // They show the height, and a click is tested against the mesh.
	}
}

// Linear blend skinning moves no vertex farther from the root than it is at rest. A plant on a slope, a wall or a
// ceiling may hang below its own root, so all directions count.
AABB Plant3D::reach() const {
	const AABB rest = mesh->get_aabb();
	const Vector3 farthest = rest.position.abs().max(rest.get_end().abs());
	const float radius = farthest.length();
	return AABB(Vector3(-radius, -radius, -radius), Vector3(2.0f * radius, 2.0f * radius, 2.0f * radius));
}

Ref<ArrayMesh> Plant3D::get_mesh() {
	if (mesh_is_stale && species.is_valid()) {
		build_mesh();
	}
	return mesh;
}

Skeleton3D *Plant3D::get_skeleton() {
	get_mesh();
	if (!skeleton_is_held) {
		skeleton_is_held = true;
		update_bone();
		bone().catch_up();
	}
	return skeleton;
}

AABB Plant3D::get_reach() {
	get_mesh();
	return mesh.is_valid() ? reach() : AABB();
}

double Plant3D::get_plant_height() {
	get_mesh();
	return as_written(built_height);
}

} // namespace undergrowth
