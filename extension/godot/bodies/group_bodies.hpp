#pragma once

#include "bodies/body_readings.hpp"

#include <godot_cpp/variant/transform3d.hpp>

#include <cstdint>
#include <functional>
#include <set>
#include <vector>

namespace undergrowth {

/// Tracks the bodies of a group for a field, or for `Plant3D`s (PlantBodies), whose axes are the world's. Interpolates
/// linearly between the positions in two frames, so that pushes are the same at every frame rate. Main thread.
///
/// Each shape has its own velocity, since the step before: in the world or in the field, whichever is less. So a field
/// that moves past a resting body, or together with a body, is not pushed by its own motion. A shape that moves faster
/// than FASTEST between two frames was set to another position, and that move does not push.
class GroupBodies {
public:
	static constexpr double FASTEST = 50.0; ///< m/s.
	static constexpr double BODY_PATIENCE = 1.0; ///< s, until the warning about a body that cannot push.
	static constexpr double GROUP_PATIENCE = 5.0; ///< s, until the warning about a group without members.

	/// Returns the longest motion (m) in a frame of `delta` seconds; a longer one is a move to another position.
	static float farthest_way(double delta);

	/// A body that came among plants or left them.
	struct Event {
		uint64_t body; ///< Instance id; the body may be freed.
		bool has_entered;
	};

	/// Follows the bodies of `reading`, null for none, in a frame of `delta` seconds. Call it once in every frame.
	/// `axes`: from the field's to the world's, invertible.
	void watch(const BodyReading *reading, const godot::Transform3D &axes, double delta);
	/// Returns the shapes that push in a step at `ago` seconds before this frame (0 to its delta), in field axes. Call
	/// in the order of the steps. Valid until the next call.
	const std::vector<MovingBody> &gather(double ago);
	/// Returns the bodies with a changed result of `touches` for the last gathered shapes, and those that left the
	/// group or the tree.
	std::vector<Event> find_events(const std::function<bool(const MovingBody &)> &touches);
	/// Calls visit(instance id, shape) for each shape of the last gather(). For callers that find events themselves;
	/// call drop_gone() after it.
	void for_each_shape(const std::function<void(uint64_t, const MovingBody &)> &visit) const;
	/// Removes bodies that left the group or the tree.
	void drop_gone();
	/// Returns new warnings, with what to do; each once.
	std::vector<godot::String> take_warnings();
	/// Removes all bodies without events. Call when a field leaves the tree.
	void forget();

private:
	/// Position of a shape.
	struct Spot {
		MovingBody shape; ///< Field axes, without velocity.
		glm::vec3 in_world; ///< Its middle, m.
	};
	struct Shape {
		uint64_t holder;
		Spot before; ///< In the frame before.
		Spot now;
		Spot stepped; ///< In the last step.
		double stepped_at = -1.0; ///< s of `time`; below 0: in no step.
		bool is_here = false; ///< It can push in this frame.
		bool was_here = false;
	};
	struct Body {
		uint64_t id;
		std::vector<Shape> shapes;
		bool is_here = true;
		bool is_touching = false;
		size_t first = 0, count = 0; ///< Range in `gathered`.
	};

	std::vector<Body> bodies;
	std::vector<MovingBody> gathered;
	godot::Transform3D to_world, to_field;
	godot::StringName watched_group;
	double time = 0.0; ///< s.
	double frame = 0.0; ///< Length of the last frame, s.
	double empty_for = 0.0; ///< s without a member.
	bool is_group_known = false; ///< It has had a member, or the warning was given.
	std::set<uint64_t> warned_of;
	std::vector<godot::String> warnings;

	Body &body_of(uint64_t id);
	void note(const BodyReading::Body &read);
	static void follow_shapes(Body &body, const BodyReading::Body &read);
	void note_shape(Shape &shape, const BodyReading::Shape &read) const;
	bool is_jump(const Spot &from, const Spot &to) const;
	glm::vec3 velocity(const Spot &from, const Spot &to, double seconds) const;
	static float growth(const Spot &from, const Spot &to, double seconds); ///< m/s.
	void warn_of(const BodyReading::Body &read);
	void warn_of_group(int members, double delta);
};

} // namespace undergrowth
