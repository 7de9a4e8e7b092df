#pragma once

#include "placement/habitat_survey.hpp"
#include "placement/plants.hpp"
#include "placement/triangle_ground.hpp"

#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <glm/vec3.hpp>

#include <memory>
#include <vector>

namespace undergrowth {

/// The ground under the plants of a field.
struct FieldGround {
	enum class Kind { none, colliders, mesh, object };

	Kind kind = Kind::none;
	GroundChoice choice = GroundChoice::highest;
	GroundLimits limits;
	std::shared_ptr<const HabitatSurvey> survey; ///< For habitats; null: none.
	godot::PackedVector3Array triangles; ///< Triangles of a mesh: three corners each, in the field's axes.

	/// True if a GroundSampler queries the ground on the main thread.
	bool needs_queries() const { return kind == Kind::colliders || kind == Kind::object; }
	/// Reads heights and normals of a mesh under all plants; NaN beside the mesh. Does nothing for other kinds of
	/// ground. Any thread.
	void look_up(const FieldPlants &plants, std::vector<float> &heights, std::vector<glm::vec3> &normals) const;
};

} // namespace undergrowth
