#pragma once

#include "stand/plants.hpp"
#include "stand/triangle_ground.hpp"

#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <glm/vec3.hpp>

#include <vector>

namespace undergrowth {

/// What plants of a field stand on.
struct FieldGround {
	enum class Kind { none, colliders, mesh, object };

	Kind kind = Kind::none;
	GroundChoice choice = GroundChoice::highest;
	GroundLimits limits;
	godot::PackedVector3Array triangles; ///< Of a mesh: three corners each, field axes.

	/// Whether the ground is asked on the main thread, by a GroundSurvey.
	bool needs_survey() const { return kind == Kind::colliders || kind == Kind::object; }
	/// Heights and normals of a mesh under all plants; nothing for other kinds. NaN beside the mesh. On any thread.
	void look_up(const FieldPlants &plants, std::vector<float> &heights, std::vector<glm::vec3> &normals) const;
};

} // namespace undergrowth
