#pragma once

#include "motion/bodies.hpp"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace undergrowth {

/// The bodies of a group in one world, as the engine has them in a frame.
struct BodyReading {
	struct Shape {
		uint64_t holder; ///< Instance id of the CollisionShape3D.
		bool is_here = false; ///< It can push in this frame.
		MovingBody body; ///< World axes, without velocity.
	};
	struct Body {
		uint64_t id;
		std::vector<Shape> shapes;
		bool can_push = false; ///< A shape can push when it is enabled.
		bool is_member = true; ///< In this frame.
		double age = 0.0; ///< s.
		double shapes_age = 0.0; ///< s.
	};

	godot::StringName group;
	uint64_t world = 0; ///< Instance id of the World3D.
	std::vector<Body> bodies;
	int members = 0; ///< Members of the group that are in this world, or in none.
	bool is_read = false; ///< In this frame.
};

/// Reads the bodies of groups from the engine, once a frame for any number of fields and plants. Main thread.
class BodyReadings {
public:
	static constexpr double SHAPES_LIFETIME = 0.25; ///< s, after which the shapes of a body are searched again.

	/// Begins a frame of `seconds`. Drops the readings without a use in the last frame.
	void begin_frame(godot::SceneTree *of, double seconds);
	/// Returns the bodies of a group in a world, which it reads at the first call in a frame. Null without a name.
	/// Valid until the next frame.
	const BodyReading *read(const godot::StringName &group, uint64_t world);

private:
	std::vector<std::unique_ptr<BodyReading>> readings;
	godot::SceneTree *tree = nullptr;
	double delta = 0.0; ///< s.

	void update(BodyReading &reading) const;
	void note(BodyReading &reading, const godot::Node3D *node) const;
};

} // namespace undergrowth
