#pragma once

#include "field/field_options.hpp"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/string.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <memory>

namespace undergrowth {

/// Queries the ground of a field at some places, where only the main thread can: colliders or an object.
class GroundQuery {
public:
	enum class State { ready, waiting, failed };

	virtual ~GroundQuery() = default;
	/// Before the first measure() of a frame.
	virtual State begin() = 0;
	/// Heights (m, field axes; NaN: no ground) below or above places (m, field axes). Where `normals` is not null it
	/// gets normals of any length, if slopes matter to the field. False: it has failed, and stays so.
	virtual bool measure(const glm::vec2 *places, int count, float *heights, glm::vec3 *normals) = 0;
	/// Places of one measure(), after which the time is checked.
	virtual int max_places() const = 0;
	/// Only in physics frames, or only in other frames.
	virtual bool is_of_physics() const = 0;
	/// Why it failed, and what to do.
	virtual godot::String fault() const = 0;
	/// What to check where none of the plants has ground.
	virtual godot::String advice() const = 0;
};

/// Null where the path of ground_object leads to no object.
std::unique_ptr<GroundQuery> query_ground(godot::Node3D *field, const FieldProperties &options);

/// The object that a path leads to, which may be a property of a node ("Terrain:data"); null where it leads nowhere.
godot::Object *find_ground_object(const godot::Node3D *field, const godot::NodePath &path);

} // namespace undergrowth
