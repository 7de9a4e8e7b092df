#include "field/field_ground.hpp"

#include "convert.hpp"
#include "new_object.hpp"

#include <godot_cpp/classes/collision_object3d.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>

using namespace godot;

namespace undergrowth {

namespace {

/// Triangles in the cells of a grid over the ground, so that a look-up tests few of them. (The engine's TriangleMesh
/// took fifteen to thirty times as long for 100,000 plants.)
class TriangleGrid {
public:
	explicit TriangleGrid(const PackedVector3Array &triangles);
	/// The highest point over (x, z); false beside all triangles.
	bool find(float x, float z, float &height, glm::vec3 &normal) const;

private:
	const Vector3 *corners;
	float low_x = 0.0f, low_z = 0.0f;
	float cell = 1.0f;
	int columns = 1, rows = 1;
	std::vector<int> firsts; ///< Of each cell, and the end.
	std::vector<int> members; ///< Triangles by cell.

	int column_of(float x) const { return std::clamp(int((x - low_x) / cell), 0, columns - 1); }
	int row_of(float z) const { return std::clamp(int((z - low_z) / cell), 0, rows - 1); }
	template <class Act> void for_each_cell(int triangle, Act &&act) const;
};

constexpr int MOST_CELLS_A_SIDE = 512;

TriangleGrid::TriangleGrid(const PackedVector3Array &triangles) : corners(triangles.ptr()) {
	const int count = int(triangles.size() / 3);
	float high_x = 0.0f, high_z = 0.0f;
	for (int i = 0; i < 3 * count; i++) {
		low_x = i == 0 ? corners[i].x : std::min(low_x, corners[i].x);
		low_z = i == 0 ? corners[i].z : std::min(low_z, corners[i].z);
		high_x = i == 0 ? corners[i].x : std::max(high_x, corners[i].x);
		high_z = i == 0 ? corners[i].z : std::max(high_z, corners[i].z);
	}
	const float extent = std::max({ high_x - low_x, high_z - low_z, 1e-3f });
	const int side = std::clamp(int(std::sqrt(float(count))), 1, MOST_CELLS_A_SIDE);
	cell = extent / float(side);
	columns = std::clamp(int((high_x - low_x) / cell) + 1, 1, MOST_CELLS_A_SIDE + 1);
	rows = std::clamp(int((high_z - low_z) / cell) + 1, 1, MOST_CELLS_A_SIDE + 1);
	firsts.assign(size_t(columns) * size_t(rows) + 1, 0);
	for (int i = 0; i < count; i++) {
		for_each_cell(i, [&](size_t at) { firsts[at + 1]++; });
	}
	for (size_t i = 1; i < firsts.size(); i++) {
		firsts[i] += firsts[i - 1];
	}
	members.resize(size_t(firsts.back()));
	std::vector<int> next(firsts.begin(), firsts.end() - 1);
	for (int i = 0; i < count; i++) {
		for_each_cell(i, [&](size_t at) { members[size_t(next[at]++)] = i; });
	}
}

template <class Act> void TriangleGrid::for_each_cell(int triangle, Act &&act) const {
	const Vector3 *t = corners + 3 * triangle;
	const int last_row = row_of(std::max({ t[0].z, t[1].z, t[2].z }));
	const int last_column = column_of(std::max({ t[0].x, t[1].x, t[2].x }));
	for (int row = row_of(std::min({ t[0].z, t[1].z, t[2].z })); row <= last_row; row++) {
		for (int column = column_of(std::min({ t[0].x, t[1].x, t[2].x })); column <= last_column; column++) {
			act(size_t(row) * size_t(columns) + size_t(column));
		}
	}
}

bool TriangleGrid::find(float x, float z, float &height, glm::vec3 &normal) const {
	bool found = false;
	if (members.empty() || x < low_x || z < low_z || x > low_x + cell * float(columns) ||
			z > low_z + cell * float(rows)) {
		return false;
	}
	const size_t at = size_t(row_of(z)) * size_t(columns) + size_t(column_of(x));
	for (int i = firsts[at]; i < firsts[at + 1]; i++) {
		const Vector3 *t = corners + 3 * members[size_t(i)];
		const float ax = t[1].x - t[0].x, az = t[1].z - t[0].z;
		const float bx = t[2].x - t[0].x, bz = t[2].z - t[0].z;
		const float doubled = ax * bz - az * bx;
		const float px = x - t[0].x, pz = z - t[0].z;
		const float u = (px * bz - pz * bx) / doubled;
		const float v = (ax * pz - az * px) / doubled;
		if (!(u >= 0.0f && v >= 0.0f && u + v <= 1.0f)) {
			continue;
		}
		const float y = t[0].y + u * (t[1].y - t[0].y) + v * (t[2].y - t[0].y);
		if (!found || y > height) {
			found = true;
			height = y;
			const Vector3 across = (t[1] - t[0]).cross(t[2] - t[0]);
			normal = to_glm(across.y < 0.0f ? -across : across); // Up, whichever way the triangle goes round.
		}
	}
	return found;
}

} // namespace

void FieldGround::look_up(
		const FieldPlants &plants, std::vector<float> &heights, std::vector<glm::vec3> &normals) const {
	if (kind != Kind::mesh) {
		return;
	}
	const TriangleGrid grid(triangles);
	heights.assign(size_t(plants.size()), NAN);
	normals.assign(size_t(plants.size()), glm::vec3(0.0f, 1.0f, 0.0f));
	for (size_t i = 0; i < heights.size(); i++) {
		grid.find(plants.x[i], plants.z[i], heights[i], normals[i]);
	}
}

FieldRays::FieldRays(const Transform3D &field, uint32_t mask) :
		placed(field), to_field(field.affine_inverse()), collision_mask(mask) {}

FieldRays::State FieldRays::cast(
		const Ref<World3D> &world, const TypedArray<RID> &excluded, const FieldPlants &plants, double usec) {
	using Clock = std::chrono::steady_clock;
	const Clock::time_point end = Clock::now() + std::chrono::microseconds(int64_t(usec));
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
		if (heights.size() % 64 == 0 && Clock::now() > end) {
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
