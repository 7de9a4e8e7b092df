#pragma once

#include "climb/climb_settings.hpp"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/node_path.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// The surfaces of one body, for a worker.
struct SupportFaces {
	godot::PackedVector3Array corners; ///< In the body's own axes.
	godot::Transform3D to_growth; ///< To the axes in which the plant grows.
};

/// Adds the faces of all bodies, each as the body of its number.
ClimbSupport join_faces(const std::vector<SupportFaces> &bodies);

/// The bodies that a climber grows on: meshes, CSG shapes, or collision shapes. Reads their surfaces, and follows their
/// rigid motion. Main thread.
class ClimberSupports {
public:
	/// Reads the nodes at `paths`, or the parent of `climber` if there are none. Of a node without a surface, all below
	/// it are read. `growth`: from the axes of growth to the world's. Returns what is wrong and what to do, and then
	/// changes nothing.
	godot::String read(const godot::Node3D *climber, const godot::TypedArray<godot::NodePath> &paths,
			const godot::Transform3D &growth, std::vector<SupportFaces> &into);
	/// Reads the transforms. Returns true if a body moved since the last call.
	bool follow();
	int count() const { return int(bodies.size()); }
	/// Returns the motion of a body since read(), in world axes.
	godot::Transform3D moved(int body) const;
	/// Returns the last motion of a body that follow() found.
	godot::Transform3D step(int body) const;

private:
	struct Body {
		uint64_t node = 0; ///< Instance id.
		godot::Transform3D grown, before, now; ///< Without scale.
	};
	std::vector<Body> bodies;
};

/// Returns the transform without scale and shear.
godot::Transform3D rigid(const godot::Transform3D &transform);

} // namespace undergrowth
