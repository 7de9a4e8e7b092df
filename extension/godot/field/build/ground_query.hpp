#pragma once

#include "field/resources/field_options.hpp"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/string.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <memory>

namespace undergrowth {

/// Queries the ground of a field from colliders or an object. Only for the main thread.
class GroundQuery {
public:
	enum class State { ready, waiting, failed };

	virtual ~GroundQuery() = default;
	/// Call before the first measure() of a frame.
	virtual State begin() = 0;
	/// Heights (m, field axes; NaN: no ground) below or above positions (m, field axes). `normals` may be null; else it
	/// gets normals of any length, if slopes matter to the field. Returns false after a failure, which is final.
	virtual bool measure(const glm::vec2 *places, int count, float *heights, glm::vec3 *normals) = 0;
	/// Maximum number of positions per measure(). The caller checks the time after each.
	virtual int max_places() const = 0;
	/// True: call it only in physics frames. False: call it only in other frames.
	virtual bool is_of_physics() const = 0;
	/// Describes why it failed, and what to do.
	virtual godot::String fault() const = 0;
	/// What to check if no plant has ground.
	virtual godot::String advice() const = 0;
};

/// Returns null if the path of ground_object leads to no object.
std::unique_ptr<GroundQuery> query_ground(godot::Node3D *field, const FieldProperties &options);

/// The object at a path, which may be a property of a node ("Terrain:data"), or null.
godot::Object *find_ground_object(const godot::Node3D *field, const godot::NodePath &path);

} // namespace undergrowth
