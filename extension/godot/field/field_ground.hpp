#pragma once

#include "stand/plants.hpp"

#include <godot_cpp/classes/physics_direct_space_state3d.hpp>
#include <godot_cpp/classes/physics_ray_query_parameters3d.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <glm/vec3.hpp>

#include <vector>

namespace undergrowth {

/// What plants of a field stand on.
struct FieldGround {
	enum class Kind { none, colliders, mesh };

	Kind kind = Kind::none;
	GroundLimits limits;
	godot::PackedVector3Array triangles; ///< Of a mesh: three corners each, field axes.

	bool needs_rays() const { return kind == Kind::colliders; }
	/// Heights and normals of a mesh under all plants; nothing for other kinds. NaN beside the mesh. On any thread.
	void look_up(const FieldPlants &plants, std::vector<float> &heights, std::vector<glm::vec3> &normals) const;
};

/// Casts a ray straight down for each plant, a part of them at a time. In physics frames of the main thread only: where
/// physics has a thread of its own, nobody may ask it outside of them.
class FieldRays {
public:
	static constexpr float REACH = 1000.0f; ///< m above and below the field's plane.
	static constexpr int PATIENCE = 10; ///< Physics frames without a space to ask, until the rays fail.

	enum class State { going_on, done, failed };

	FieldRays(const godot::Transform3D &field, uint32_t mask);
	/// Goes on for about `usec` in a world's space, which may be null. Bodies of `excluded` are no ground. It fails
	/// where the world has no space for PATIENCE frames, and stays so.
	State cast(const godot::Ref<godot::World3D> &world, const godot::TypedArray<godot::RID> &excluded,
			const FieldPlants &plants, double usec);
	/// Whether any ray hit something.
	bool has_hit() const { return hit_count > 0; }

	std::vector<float> heights; ///< m, field axes; NaN where nothing was hit. As many as plants once all are done.
	std::vector<glm::vec3> normals;

private:
	godot::Transform3D placed, to_field;
	uint32_t collision_mask;
	int hit_count = 0;
	int frames_without_space = 0;

	void cast_one(godot::PhysicsDirectSpaceState3D *space, godot::PhysicsRayQueryParameters3D *ray, float x, float z);
};

/// The collision objects of a group's members, and those below them: what pushes plants is not what they stand on.
godot::TypedArray<godot::RID> collision_objects_of(godot::SceneTree *tree, const godot::StringName &group);

} // namespace undergrowth
