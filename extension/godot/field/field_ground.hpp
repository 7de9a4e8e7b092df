#pragma once

#include "stand/plants.hpp"

#include <godot_cpp/classes/world3d.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/transform3d.hpp>

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

/// Casts a ray straight down for each plant, a part of them at a time. Main thread.
class FieldRays {
public:
	static constexpr float REACH = 1000.0f; ///< m above and below the field's plane.

	FieldRays(const godot::Ref<godot::World3D> &world, const godot::Transform3D &field, uint32_t mask);
	/// Goes on for about `usec`; tells whether all are done.
	bool cast(const FieldPlants &plants, double usec);
	float progress(const FieldPlants &plants) const;

	std::vector<float> heights; ///< m, field axes; NaN where nothing was hit.
	std::vector<glm::vec3> normals;

private:
	godot::Ref<godot::World3D> space_of;
	godot::Transform3D placed;
	uint32_t collision_mask;
};

} // namespace undergrowth
