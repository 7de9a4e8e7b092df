#include "field/ground_survey.hpp"

#include "convert.hpp"
#include "field/field_ground.hpp"
#include "field/field_recipe.hpp"
#include "messages.hpp"
#include "new_object.hpp"
#include "stopwatch.hpp"

#include <godot_cpp/classes/collision_object3d.hpp>
#include <godot_cpp/classes/physics_direct_space_state3d.hpp>
#include <godot_cpp/classes/physics_ray_query_parameters3d.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr float RAY_REACH = 1000.0f; // m above and below the field's plane.
static constexpr float BELOW_HIT = 0.001f; // m below what a ray hit the next one begins.
static constexpr int MOST_HITS = 16; // Of rays through what is above the lowest ground.
static constexpr int PATIENCE = 10; // Physics frames without a space to ask, until rays fail.
static constexpr size_t ANSWERS_AT_ONCE = 64;
// In one frame at least so long, and a share of frames that take long anyway.
static constexpr double LEAST_ASKING_USEC = 3000.0;
static constexpr double MOST_ASKING_USEC = 50000.0;
static constexpr double ASKING_SHARE = 0.2;
static const glm::vec3 UP = { 0.0f, 1.0f, 0.0f };

void GroundSurvey::add(float height, const glm::vec3 &normal) {
	found_count += std::isfinite(height) ? 1 : 0;
	heights.push_back(height);
	normals.push_back(normal);
}

static void add_collision_objects(const Node *node, TypedArray<RID> &found) {
	if (const CollisionObject3D *object = Object::cast_to<CollisionObject3D>(node)) {
		found.push_back(object->get_rid());
	}
	for (int i = 0; i < node->get_child_count(); i++) {
		add_collision_objects(node->get_child(i), found);
	}
}

// Of a group's members, and those below them: what pushes plants is not what they stand on.
static TypedArray<RID> collision_objects_of(SceneTree *tree, const StringName &group) {
	TypedArray<RID> found;
	const TypedArray<Node> members = group.is_empty() ? TypedArray<Node>() : tree->get_nodes_in_group(group);
	for (int64_t i = 0; i < members.size(); i++) {
		add_collision_objects(Object::cast_to<Node>(members[i]), found);
	}
	return found;
}

namespace {

// Normals stay at right angles where a field is scaled unevenly.
glm::vec3 normal_in(const Transform3D &field, const Vector3 &normal) {
	return to_glm(field.basis.transposed().xform(normal));
}

/// Casts a ray straight down for each plant. In physics frames: where physics has a thread of its own, nobody may ask
/// it outside of them.
class RaySurvey : public GroundSurvey {
public:
	RaySurvey(Node3D *of, const FieldProperties &options) :
			node(of),
			field(axes_of(of)),
			to_field(axes_of(of).affine_inverse()),
			group(options.bodies_group),
			mask(uint32_t(options.ground_collision_mask)),
			most_hits(GroundChoice(options.ground_choice) == GroundChoice::lowest ? MOST_HITS : 1) {}

	State go_on(const FieldPlants &plants, double usec) override {
		const Stopwatch watch;
		const Ref<World3D> world = node->get_world_3d();
		const bool has_space = world.is_valid() && world->get_space().is_valid();
		PhysicsDirectSpaceState3D *space = has_space ? world->get_direct_space_state() : nullptr;
		if (!space) {
			frames_without_space++;
			return frames_without_space < PATIENCE ? State::going_on : State::failed;
		}
		frames_without_space = 0;
		Ref<PhysicsRayQueryParameters3D> ray = new_counted<PhysicsRayQueryParameters3D>();
		ray->set_collision_mask(mask);
		ray->set_exclude(collision_objects_of(node->get_tree(), group));
		while (heights.size() < size_t(plants.size())) {
			const size_t i = heights.size();
			cast(space, ray.ptr(), plants.x[i], plants.z[i]);
			if (heights.size() % ANSWERS_AT_ONCE == 0 && watch.usec() > usec) {
				break;
			}
		}
		return heights.size() == size_t(plants.size()) ? State::done : State::going_on;
	}

	bool is_of_physics() const override { return true; }
	String fault() const override {
		return "there is no 3D physics to cast rays at, so nothing is planted. Choose a 3D physics engine in the "
			   "project settings, or another ground_mode.";
	}
	String advice() const override {
		return "no collider is below or above it, so nothing grows. Check that ground_collision_mask has a layer of "
			   "the ground, that the ground is within 1000 m, and call fill() once it is there where it comes later.";
	}

private:
	Node3D *node;
	Transform3D field, to_field;
	StringName group;
	uint32_t mask;
	int most_hits; ///< Of one ray after the other, each of which begins below the hit of the one before.
	int frames_without_space = 0;

	void cast(PhysicsDirectSpaceState3D *space, PhysicsRayQueryParameters3D *ray, float x, float z) {
		float height = NAN;
		glm::vec3 normal = UP;
		float from = RAY_REACH;
		ray->set_to(field.xform(Vector3(x, -RAY_REACH, z)));
		for (int hits = 0; hits < most_hits && from > -RAY_REACH; hits++) {
			ray->set_from(field.xform(Vector3(x, from, z)));
			const Dictionary hit = space->intersect_ray(ray);
			if (hit.is_empty()) {
				break;
			}
			height = to_field.xform(Vector3(hit["position"])).y;
			normal = normal_in(field, Vector3(hit["normal"]));
			from = std::min(from, height) - BELOW_HIT;
		}
		add(height, normal);
	}
};

/// Asks an object that answers get_height(), and get_normal() if it has that, for places in the world.
class ObjectSurvey : public GroundSurvey {
public:
	ObjectSurvey(const Node3D *of, Object *ground) :
			field(axes_of(of)),
			to_field(axes_of(of).affine_inverse()),
			asked(uint64_t(ground->get_instance_id())),
			has_normals(ground->has_method("get_normal")) {}

	State go_on(const FieldPlants &plants, double usec) override {
		const Stopwatch watch;
		while (problem.is_empty() && heights.size() < size_t(plants.size())) {
			const size_t i = heights.size();
			ask(field.xform(Vector3(plants.x[i], 0.0f, plants.z[i])));
			if (heights.size() % ANSWERS_AT_ONCE == 0 && watch.usec() > usec) {
				break;
			}
		}
		if (!problem.is_empty()) {
			return State::failed;
		}
		return heights.size() == size_t(plants.size()) ? State::done : State::going_on;
	}

	bool is_of_physics() const override { return false; }
	String fault() const override { return problem; }
	String advice() const override {
		return "its ground_object tells of no ground at any of its places, so nothing grows. Check that the field lies "
			   "on "
			   "it, and call fill() once it is there where it comes later.";
	}

private:
	Transform3D field, to_field;
	uint64_t asked;
	bool has_normals;
	String problem;

	void ask(const Vector3 &place) {
		Object *ground = ObjectDB::get_instance(asked);
		if (!ground) {
			problem = "its ground_object was freed while it was asked. Set another one, or another ground_mode.";
			return;
		}
		const Variant height = ground->call("get_height", place);
		const bool is_number = height.get_type() == Variant::FLOAT || height.get_type() == Variant::INT;
		const Variant normal = has_normals && is_number ? ground->call("get_normal", place) : Variant(Vector3(0, 1, 0));
		if (!is_number || normal.get_type() != Variant::VECTOR3) {
			problem = String(is_number ? "get_normal() of " : "get_height() of ") + describe(ground) +
					" answers with no " + (is_number ? "Vector3" : "float") + ", so it is no ground. Return " +
					(is_number ? "a unit normal." : "metres of the world, or NAN where there is no ground.");
			return;
		}
		const float y = float(double(height));
		const Vector3 up = normal;
		const bool is_there = std::isfinite(y) && up.is_finite();
		add(is_there ? to_field.xform(Vector3(place.x, y, place.z)).y : NAN, is_there ? normal_in(field, up) : UP);
	}
};

} // namespace

double GroundAsker::usual_usec(double delta) {
	return std::clamp(1e6 * ASKING_SHARE * delta, LEAST_ASKING_USEC, MOST_ASKING_USEC);
}

GroundSurvey::State GroundAsker::go_on(
		const FieldPlants &plants, Node3D *field, const FieldProperties &options, double usec, bool physics) {
	if (!survey) {
		survey = survey_ground(field, options);
	}
	if (!survey) {
		FieldGround ground;
		why = read_ground(field, options, ground);
		return GroundSurvey::State::failed;
	}
	if (survey->is_of_physics() != physics) {
		return GroundSurvey::State::going_on;
	}
	const GroundSurvey::State state = survey->go_on(plants, usec);
	why = survey->fault();
	return state;
}

void GroundAsker::tell_of_no_ground(const FieldPlants &plants, const Node3D *field) {
	const bool is_missed = !survey->has_found_any() && plants.size() > 0;
	if (is_missed && missing.is_empty()) {
		report_warning(field, survey->advice());
	}
	missing = is_missed ? survey->advice() : String();
}

void GroundAsker::note_ground(const FieldPlants &plants) {
	has_found_some = has_found_some || survey->has_found_any();
	if (plants.size() > 0) {
		untold = survey->advice();
	}
}

void GroundAsker::take_findings(GroundAsker &other) {
	has_found_some = std::exchange(other.has_found_some, false) || has_found_some;
	const String others = std::exchange(other.untold, String());
	untold = untold.is_empty() ? others : untold;
}

void GroundAsker::tell_of_all(const Node3D *field) {
	missing = has_found_some ? String() : untold;
	if (!missing.is_empty()) {
		report_warning(field, missing);
	}
	untold = String();
	has_found_some = false;
}

Object *find_ground_object(const Node3D *field, const NodePath &path) {
	Object *found = path.is_empty() ? nullptr : field->get_node_or_null(path);
	const String property = path.get_concatenated_subnames();
	return found && !property.is_empty() ? found->get_indexed(NodePath(":" + property)).get_validated_object() : found;
}

std::unique_ptr<GroundSurvey> survey_ground(Node3D *field, const FieldProperties &options) {
	if (options.ground_mode == int(FieldGround::Kind::object)) {
		Object *ground = find_ground_object(field, options.ground_object);
		return ground ? std::make_unique<ObjectSurvey>(field, ground) : nullptr;
	}
	return std::make_unique<RaySurvey>(field, options);
}

} // namespace undergrowth
