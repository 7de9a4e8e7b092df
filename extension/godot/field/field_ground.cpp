#include "field/field_ground.hpp"

#include "convert.hpp"
#include "new_object.hpp"
#include "stand/triangle_ground.hpp"
#include "stopwatch.hpp"

#include <godot_cpp/classes/collision_object3d.hpp>

#include <cmath>

using namespace godot;

namespace undergrowth {

void FieldGround::look_up(
		const FieldPlants &plants, std::vector<float> &heights, std::vector<glm::vec3> &normals) const {
	if (kind == Kind::mesh) {
		const auto *corners = reinterpret_cast<const glm::vec3 *>(triangles.ptr());
		find_ground(corners, int(triangles.size() / 3), plants, heights, normals);
	}
}

FieldRays::FieldRays(const Transform3D &field, uint32_t mask) :
		placed(field), to_field(field.affine_inverse()), collision_mask(mask) {}

FieldRays::State FieldRays::cast(
		const Ref<World3D> &world, const TypedArray<RID> &excluded, const FieldPlants &plants, double usec) {
	const Stopwatch watch;
	const bool has_space = world.is_valid() && world->get_space().is_valid();
	PhysicsDirectSpaceState3D *space = has_space ? world->get_direct_space_state() : nullptr;
	if (!space) {
		frames_without_space++;
		return frames_without_space < PATIENCE ? State::going_on : State::failed;
	}
	frames_without_space = 0;
	Ref<PhysicsRayQueryParameters3D> ray = new_counted<PhysicsRayQueryParameters3D>();
	ray->set_collision_mask(collision_mask);
	ray->set_exclude(excluded);
	while (heights.size() < size_t(plants.size())) {
		const size_t i = heights.size();
		cast_one(space, ray.ptr(), plants.x[i], plants.z[i]);
		if (heights.size() % 64 == 0 && watch.usec() > usec) {
			break;
		}
	}
	return heights.size() == size_t(plants.size()) ? State::done : State::going_on;
}

void FieldRays::cast_one(PhysicsDirectSpaceState3D *space, PhysicsRayQueryParameters3D *ray, float x, float z) {
	ray->set_from(placed.xform(Vector3(x, REACH, z)));
	ray->set_to(placed.xform(Vector3(x, -REACH, z)));
	const Dictionary hit = space->intersect_ray(ray);
	if (hit.is_empty()) {
		heights.push_back(NAN);
		normals.push_back({ 0.0f, 1.0f, 0.0f });
		return;
	}
	hit_count++;
	heights.push_back(to_field.xform(Vector3(hit["position"])).y);
	// Normals stay at right angles where a field is scaled unevenly.
	normals.push_back(to_glm(placed.basis.transposed().xform(Vector3(hit["normal"]))));
}

static void add_collision_objects(const Node *node, TypedArray<RID> &found) {
	if (const CollisionObject3D *object = Object::cast_to<CollisionObject3D>(node)) {
		found.push_back(object->get_rid());
	}
	for (int i = 0; i < node->get_child_count(); i++) {
		add_collision_objects(node->get_child(i), found);
	}
}

TypedArray<RID> collision_objects_of(SceneTree *tree, const StringName &group) {
	TypedArray<RID> found;
	const TypedArray<Node> members = group.is_empty() ? TypedArray<Node>() : tree->get_nodes_in_group(group);
	for (int64_t i = 0; i < members.size(); i++) {
		add_collision_objects(Object::cast_to<Node>(members[i]), found);
	}
	return found;
}

} // namespace undergrowth
