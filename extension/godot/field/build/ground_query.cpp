#include "field/build/ground_query.hpp"

#include "base/convert.hpp"
#include "base/messages.hpp"
#include "base/new_object.hpp"
#include "field/build/build_input.hpp"
#include "field/build/field_ground.hpp"
#include "field/build/field_habitats.hpp"

#include <godot_cpp/classes/collision_object3d.hpp>
#include <godot_cpp/classes/physics_direct_space_state3d.hpp>
#include <godot_cpp/classes/physics_ray_query_parameters3d.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace godot;

namespace undergrowth {

static constexpr float RAY_REACH = 1000.0f; // m above and below the field's plane.
static constexpr float BELOW_HIT = 0.001f; // m below a hit, the start of the next ray.
static constexpr int MAX_HITS = 16; // Of rays through objects above the lowest ground.
static constexpr int MAX_FRAMES_WITHOUT_SPACE = 10; // Physics frames. Rays fail after them.
static constexpr int PLACES_AT_ONCE = 64;
static constexpr int BATCH_PLACES = 256; // Per call of get_heights().
static constexpr float SLOPE_STEP = 0.25f; // m between two heights of a slope.
static const glm::vec3 UP = { 0.0f, 1.0f, 0.0f };

static void add_collision_objects(const Node *node, TypedArray<RID> &found) {
	if (const CollisionObject3D *object = Object::cast_to<CollisionObject3D>(node)) {
		found.push_back(object->get_rid());
	}
	for (int i = 0; i < node->get_child_count(); i++) {
		add_collision_objects(node->get_child(i), found);
	}
}

// Collision objects of a group that pushes plants, with those of all child nodes. They are not ground.
static TypedArray<RID> collision_objects_of(SceneTree *tree, const StringName &group) {
	TypedArray<RID> found;
	const TypedArray<Node> members = group.is_empty() ? TypedArray<Node>() : tree->get_nodes_in_group(group);
	for (int64_t i = 0; i < members.size(); i++) {
		add_collision_objects(Object::cast_to<Node>(members[i]), found);
	}
	return found;
}

namespace {

bool slopes_matter(const PlacementOptions &options) {
	constexpr float UPRIGHT = 1.5707f; // rad; no ground with a height is steeper.
	return options.slope_limits.x > 0.0f || options.slope_limits.y < UPRIGHT || options.slope_alignment > 0.0 ||
			habitats_use(options, HabitatFactor::slope);
}

// Normals remain perpendicular under an uneven scale of the field.
glm::vec3 normal_in(const Transform3D &field, const Vector3 &normal) {
	return to_glm(field.basis.transposed().xform(normal));
}

/// Casts a ray straight down at each position, in physics frames. If physics runs on its own thread, its space is
/// locked outside of them.
class RayQuery : public GroundQuery {
public:
	RayQuery(Node3D *of, const FieldProperties &options) :
			node(of),
			field(axes_of(of)),
			to_field(axes_of(of).affine_inverse()),
			group(options.bodies_group),
			mask(uint32_t(options.ground_collision_mask)),
			max_hits(GroundChoice(options.ground_choice) == GroundChoice::lowest ? MAX_HITS : 1) {}

	State begin() override {
		const Ref<World3D> world = node->get_world_3d();
		const bool has_space = world.is_valid() && world->get_space().is_valid();
		space = has_space ? world->get_direct_space_state() : nullptr;
		if (!space) {
			frames_without_space++;
			return frames_without_space < MAX_FRAMES_WITHOUT_SPACE ? State::waiting : State::failed;
		}
		frames_without_space = 0;
		ray = new_counted<PhysicsRayQueryParameters3D>();
		ray->set_collision_mask(mask);
		ray->set_exclude(collision_objects_of(node->get_tree(), group));
		return State::ready;
	}

	bool measure(const glm::vec2 *places, int count, float *heights, glm::vec3 *normals) override {
		for (int i = 0; i < count; i++) {
			glm::vec3 normal = UP;
			heights[i] = cast(places[i], normal);
			if (normals) {
				normals[i] = normal;
			}
		}
		return true;
	}

	int max_places() const override { return PLACES_AT_ONCE; }
	bool is_of_physics() const override { return true; }
	String fault() const override {
		return "ground_mode GROUND_COLLIDERS needs 3D physics, which is disabled. Select a 3D physics engine in the "
			   "project settings, or another ground_mode.";
	}
	String advice() const override {
		return "no collider is below or above the field, so nothing grows. Check that ground_collision_mask has a "
			   "layer of the ground, and that the ground is within 1000 m. If the ground appears later, call rebuild() "
			   "then.";
	}

private:
	Node3D *node;
	Transform3D field, to_field;
	StringName group;
	uint32_t mask;
	int max_hits; ///< Of consecutive rays, each of which begins below the hit of the previous one.
	int frames_without_space = 0;
	PhysicsDirectSpaceState3D *space = nullptr; ///< Of this frame.
	Ref<PhysicsRayQueryParameters3D> ray;

	float cast(const glm::vec2 &place, glm::vec3 &normal) {
		float height = NAN;
		float from = RAY_REACH;
		ray->set_to(field.xform(Vector3(place.x, -RAY_REACH, place.y)));
		for (int hits = 0; hits < max_hits && from > -RAY_REACH; hits++) {
			ray->set_from(field.xform(Vector3(place.x, from, place.y)));
			const Dictionary hit = space->intersect_ray(ray);
			if (hit.is_empty()) {
				break;
			}
			height = to_field.xform(Vector3(hit["position"])).y;
			normal = normal_in(field, Vector3(hit["normal"]));
			from = std::min(from, height) - BELOW_HIT;
		}
		return height;
	}
};

/// Calls get_height() of an object at positions in the world, or get_heights() if it exists. Slopes come from
/// get_normal(), or from heights beside each position if it does not exist.
class ObjectQuery : public GroundQuery {
public:
	ObjectQuery(const Node3D *of, Object *ground, const FieldProperties &options) :
			field(axes_of(of)),
			to_field(axes_of(of).affine_inverse()),
			object(uint64_t(ground->get_instance_id())),
			has_batch(ground->has_method("get_heights")),
			has_normals(ground->has_method("get_normal")),
			needs_normals(slopes_matter(options)) {}

	State begin() override { return State::ready; }

	bool measure(const glm::vec2 *places, int count, float *heights, glm::vec3 *normals) override {
		if (!find_heights(world_places(places, count, { 0.0f, 0.0f }), heights)) {
			return false;
		}
		if (!normals || !needs_normals) {
			return true;
		}
		return has_normals ? find_normals(places, count, heights, normals)
						   : derive_normals(places, count, heights, normals);
	}

	int max_places() const override { return has_batch ? BATCH_PLACES : PLACES_AT_ONCE; }
	bool is_of_physics() const override { return false; }
	String fault() const override { return problem; }
	String advice() const override {
		return "its ground_object returned no ground at any position, so nothing grows. Check that the field lies on "
			   "the ground. If the ground appears later, call rebuild() then.";
	}

private:
	Transform3D field, to_field;
	uint64_t object;
	bool has_batch, has_normals, needs_normals;
	String problem;

	Object *find_object() {
		Object *ground = ObjectDB::get_instance(object);
		if (!ground) {
			problem = "its ground_object was freed during a build. Set another one, or another ground_mode.";
		}
		return ground;
	}

	PackedVector3Array world_places(const glm::vec2 *places, int count, const glm::vec2 &aside) const {
		PackedVector3Array world;
		world.resize(count);
		Vector3 *into = world.ptrw();
		for (int i = 0; i < count; i++) {
			into[i] = field.xform(Vector3(places[i].x + aside.x, 0.0f, places[i].y + aside.y));
		}
		return world;
	}

	float height_in_field(const Vector3 &place, float height) const {
		return std::isfinite(height) ? to_field.xform(Vector3(place.x, height, place.z)).y : NAN;
	}

	bool find_heights(const PackedVector3Array &places, float *heights) {
		return has_batch ? find_heights_at_once(places, heights) : find_heights_singly(places, heights);
	}

	bool find_heights_at_once(const PackedVector3Array &places, float *heights) {
		Object *ground = find_object();
		if (!ground) {
			return false;
		}
		const Variant answer = ground->call("get_heights", places);
		const PackedFloat32Array found =
				answer.get_type() == Variant::PACKED_FLOAT32_ARRAY ? PackedFloat32Array(answer) : PackedFloat32Array();
		if (found.size() != places.size()) {
			problem = "get_heights() of " + describe(ground) +
					" did not return a PackedFloat32Array with one height per position. Return world heights in "
					"metres, in the order of the positions, with NAN where there is no ground.";
			return false;
		}
		for (int64_t i = 0; i < found.size(); i++) {
			heights[i] = height_in_field(places[i], found[i]);
		}
		return true;
	}

	bool find_heights_singly(const PackedVector3Array &places, float *heights) {
		for (int64_t i = 0; i < places.size(); i++) {
			Object *ground = find_object(); // A call may free it.
			if (!ground) {
				return false;
			}
			const Variant height = ground->call("get_height", places[i]);
			if (height.get_type() != Variant::FLOAT && height.get_type() != Variant::INT) {
				problem = "get_height() of " + describe(ground) +
						" did not return a float. Return a world height in metres, or NAN where there is no ground.";
				return false;
			}
			heights[i] = height_in_field(places[i], float(double(height)));
		}
		return true;
	}

	bool find_normals(const glm::vec2 *places, int count, float *heights, glm::vec3 *normals) {
		const PackedVector3Array world = world_places(places, count, { 0.0f, 0.0f });
		for (int i = 0; i < count; i++) {
			normals[i] = UP;
			if (!std::isfinite(heights[i])) {
				continue;
			}
			Object *ground = find_object();
			if (!ground) {
				return false;
			}
			const Variant normal = ground->call("get_normal", world[i]);
			if (normal.get_type() != Variant::VECTOR3) {
				problem = "get_normal() of " + describe(ground) + " did not return a Vector3. Return a unit normal.";
				return false;
			}
			const Vector3 up = normal;
			heights[i] = up.is_finite() ? heights[i] : NAN;
			normals[i] = up.is_finite() ? normal_in(field, up) : UP;
		}
		return true;
	}

	bool derive_normals(const glm::vec2 *places, int count, const float *heights, glm::vec3 *normals) {
		std::vector<float> along_x, along_z;
		if (!find_slopes(places, count, heights, { SLOPE_STEP, 0.0f }, along_x) ||
				!find_slopes(places, count, heights, { 0.0f, SLOPE_STEP }, along_z)) {
			return false;
		}
		for (int i = 0; i < count; i++) {
			normals[i] = { -along_x[size_t(i)], 1.0f, -along_z[size_t(i)] };
		}
		return true;
	}

	// Height per metre from each position to one beside it, or to one on the other side if the ground ends there.
	bool find_slopes(const glm::vec2 *places, int count, const float *heights, const glm::vec2 &aside,
			std::vector<float> &slopes) {
		slopes.assign(size_t(count), 0.0f);
		std::vector<float> beside(size_t(count), 0.0f);
		if (!find_heights(world_places(places, count, aside), beside.data())) {
			return false;
		}
		std::vector<int> ends;
		std::vector<glm::vec2> end_places;
		for (int i = 0; i < count; i++) {
			if (std::isfinite(beside[size_t(i)])) {
				slopes[size_t(i)] = std::isfinite(heights[i]) ? (beside[size_t(i)] - heights[i]) / SLOPE_STEP : 0.0f;
			} else if (std::isfinite(heights[i])) {
				ends.push_back(i);
				end_places.push_back(places[i]);
			}
		}
		if (ends.empty()) {
			return true;
		}
		if (!find_heights(world_places(end_places.data(), int(ends.size()), -aside), beside.data())) {
			return false;
		}
		for (size_t i = 0; i < ends.size(); i++) {
			const float slope = (heights[ends[i]] - beside[i]) / SLOPE_STEP;
			slopes[size_t(ends[i])] = std::isfinite(slope) ? slope : 0.0f;
		}
		return true;
	}
};

} // namespace

Object *find_ground_object(const Node3D *field, const NodePath &path) {
	if (path.is_empty()) {
		return nullptr;
	}
	Object *found = field->get_node_or_null(path);
	const String property = path.get_concatenated_subnames();
	return found && !property.is_empty() ? found->get_indexed(NodePath(":" + property)).get_validated_object() : found;
}

std::unique_ptr<GroundQuery> query_ground(Node3D *field, const FieldProperties &options) {
	if (options.ground_mode == int(FieldGround::Kind::object)) {
		Object *ground = find_ground_object(field, options.ground_object);
		return ground ? std::make_unique<ObjectQuery>(field, ground, options) : nullptr;
	}
	return std::make_unique<RayQuery>(field, options);
}

} // namespace undergrowth
