#include "climb/climber_supports.hpp"

#include "base/convert.hpp"
#include "base/messages.hpp"
#include "conventions.hpp"

#include <godot_cpp/classes/box_shape3d.hpp>
#include <godot_cpp/classes/capsule_shape3d.hpp>
#include <godot_cpp/classes/collision_shape3d.hpp>
#include <godot_cpp/classes/cylinder_shape3d.hpp>
#include <godot_cpp/classes/mesh.hpp>
#include <godot_cpp/classes/mesh_instance3d.hpp>
#include <godot_cpp/classes/shape3d.hpp>
#include <godot_cpp/classes/sphere_shape3d.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr double MIN_VOLUME = 1e-12;
static constexpr int ROWS = 16; // Of round shapes.

namespace {

struct FoundFaces {
	const Node3D *node;
	PackedVector3Array corners;
	Transform3D place; ///< In the node's axes.
};

} // namespace

Transform3D rigid(const Transform3D &transform) {
	const bool is_flat = std::fabs(transform.basis.determinant()) < MIN_VOLUME;
	return Transform3D(is_flat ? Basis() : transform.basis.orthonormalized(), transform.origin);
}

// Adds the quads between rings of points from the lowest to the highest.
static void add_lathe(const std::vector<Vector2> &profile, PackedVector3Array &into) {
	const auto at = [&](size_t row, int column) {
		const double angle = 2.0 * PI * column / (2 * ROWS);
		return Vector3(
				profile[row].x * float(std::cos(angle)), profile[row].y, profile[row].x * float(std::sin(angle)));
	};
	for (size_t row = 0; row + 1 < profile.size(); row++) {
		for (int column = 0; column < 2 * ROWS; column++) {
			const Vector3 corners[6] = { at(row, column), at(row + 1, column), at(row + 1, column + 1), at(row, column),
				at(row + 1, column + 1), at(row, column + 1) };
			for (const Vector3 &corner : corners) {
				into.push_back(corner);
			}
		}
	}
}

// `lift` (m): half the length of the cylinder between both half spheres.
static std::vector<Vector2> round_profile(float radius, float lift) {
	std::vector<Vector2> profile;
	for (int row = 0; row <= 2 * ROWS; row++) {
		const double angle = PI * row / (2 * ROWS);
		const float side = row < ROWS ? -lift : lift;
		profile.push_back(Vector2(radius * float(std::sin(angle)), side - radius * float(std::cos(angle))));
	}
	return profile;
}

static void add_box(const Vector3 &size, PackedVector3Array &into) {
	static const int FACES[6][4] = { { 0, 1, 3, 2 }, { 4, 6, 7, 5 }, { 0, 2, 6, 4 }, { 1, 5, 7, 3 }, { 0, 4, 5, 1 },
		{ 2, 3, 7, 6 } };
	for (const int (&face)[4] : FACES) {
		for (const int corner : { 0, 1, 2, 0, 2, 3 }) {
			const int i = face[corner];
			into.push_back(
					0.5f * Vector3(i & 1 ? size.x : -size.x, i & 2 ? size.y : -size.y, i & 4 ? size.z : -size.z));
		}
	}
}

static PackedVector3Array faces_of(const Ref<Shape3D> &shape) {
	PackedVector3Array faces;
	Object *any = shape.ptr();
	if (const auto *box = Object::cast_to<BoxShape3D>(any)) {
		add_box(box->get_size(), faces);
	} else if (const auto *sphere = Object::cast_to<SphereShape3D>(any)) {
		add_lathe(round_profile(sphere->get_radius(), 0.0f), faces);
	} else if (const auto *capsule = Object::cast_to<CapsuleShape3D>(any)) {
		const float radius = capsule->get_radius();
		add_lathe(round_profile(radius, std::max(0.5f * float(capsule->get_height()) - radius, 0.0f)), faces);
	} else if (const auto *cylinder = Object::cast_to<CylinderShape3D>(any)) {
		const float radius = cylinder->get_radius();
		const float half = 0.5f * float(cylinder->get_height());
		add_lathe({ { 0.0f, -half }, { radius, -half }, { radius, half }, { 0.0f, half } }, faces);
	} else if (any && any->is_class("ConcavePolygonShape3D")) {
		faces = any->call("get_faces");
	}
	return faces;
}

static void add_mesh(const Node3D *node, std::vector<FoundFaces> &into) {
	if (const auto *instance = Object::cast_to<MeshInstance3D>(node)) {
		const Ref<Mesh> mesh = instance->get_mesh();
		if (mesh.is_valid()) {
			into.push_back({ node, mesh->get_faces(), Transform3D() });
		}
	} else if (node->is_class("CSGShape3D")) {
		const Array meshes = const_cast<Node3D *>(node)->call("get_meshes");
		const Ref<Mesh> mesh = meshes.size() > 1 ? Ref<Mesh>(meshes[1]) : Ref<Mesh>();
		if (mesh.is_valid()) {
			into.push_back({ node, mesh->get_faces(), Transform3D(meshes[0]) });
		}
	}
}

static void add_shape(const Node3D *node, std::vector<FoundFaces> &into) {
	if (const auto *collision = Object::cast_to<CollisionShape3D>(node)) {
		into.push_back({ node, faces_of(collision->get_shape()), Transform3D() });
	}
}

// Plants are no supports: their meshes are internal children, which are not listed here.
static void add_below(
		const Node *node, void (*add)(const Node3D *, std::vector<FoundFaces> &), std::vector<FoundFaces> &into) {
	if (const auto *place = Object::cast_to<Node3D>(node)) {
		add(place, into);
	}
	for (int i = 0; i < node->get_child_count(); i++) {
		add_below(node->get_child(i), add, into);
	}
}

static String add_node(const Node *node, std::vector<FoundFaces> &into) {
	const size_t before = into.size();
	add_below(node, add_mesh, into);
	if (into.size() == before) {
		add_below(node, add_shape, into);
	}
	const bool is_empty = std::all_of(into.begin() + int64_t(before), into.end(),
			[](const FoundFaces &found) { return found.corners.is_empty(); });
	return is_empty ? "supports: " + describe(node) +
					" has no surface. Use a MeshInstance3D, a CSG shape, or a CollisionShape3D that is a box, sphere, "
					"capsule, cylinder or ConcavePolygonShape3D."
					: String();
}

String ClimberSupports::read(const Node3D *climber, const TypedArray<NodePath> &paths, const Transform3D &growth,
		std::vector<SupportFaces> &into) {
	std::vector<FoundFaces> found;
	String fault;
	for (int64_t i = 0; i < paths.size() && fault.is_empty(); i++) {
		const NodePath path = paths[i];
		const Node *node = path.is_empty() ? nullptr : climber->get_node_or_null(path);
		fault = node ? add_node(node, found)
					 : "supports[" + String::num_int64(i) + "] '" + String(path) + "' is no node. Choose the wall.";
	}
	if (paths.is_empty()) {
		fault = climber->get_parent_node_3d() ? add_node(climber->get_parent_node_3d(), found)
											  : String("needs a wall. Set supports, or make it a child of the wall.");
	}
	if (!fault.is_empty()) {
		return fault;
	}
	const Transform3D to_growth = growth.affine_inverse();
	bodies.clear();
	for (const FoundFaces &one : found) {
		const Transform3D place = one.node->get_global_transform();
		into.push_back({ one.corners, to_growth * place * one.place });
		bodies.push_back({ uint64_t(one.node->get_instance_id()), rigid(place), rigid(place), rigid(place) });
	}
	return String();
}

bool ClimberSupports::follow() {
	bool has_moved = false;
	for (Body &body : bodies) {
		body.before = body.now;
		const Node3D *node = Object::cast_to<Node3D>(ObjectDB::get_instance(body.node));
		if (node && node->is_inside_tree()) {
			body.now = rigid(node->get_global_transform());
		}
		has_moved = has_moved || body.now != body.before;
	}
	return has_moved;
}

Transform3D ClimberSupports::moved(int body) const {
	const Body &one = bodies[size_t(body)];
	return one.now * one.grown.affine_inverse();
}

Transform3D ClimberSupports::step(int body) const {
	const Body &one = bodies[size_t(body)];
	return one.now * one.before.affine_inverse();
}

ClimbSupport join_faces(const std::vector<SupportFaces> &bodies) {
	ClimbSupport joined;
	for (size_t body = 0; body < bodies.size(); body++) {
		const PackedVector3Array &corners = bodies[body].corners;
		for (int64_t i = 0; i + 2 < corners.size(); i += 3) {
			for (int64_t corner = i; corner < i + 3; corner++) {
				joined.corners.push_back(to_glm(bodies[body].to_growth.xform(corners[corner])));
			}
			joined.bodies.push_back(int(body));
		}
	}
	return joined;
}

} // namespace undergrowth
