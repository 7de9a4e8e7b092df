#pragma once

#include "motion/bodies.hpp"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <cstdint>
#include <functional>
#include <set>
#include <vector>

namespace undergrowth {

/// Follows the bodies of a group for a field, or for plants that stand alone (PlantBodies), whose axes are the world's,
/// so that they push plants alike at every frame rate: where they are is noted in each frame, and between two frames
/// they are taken to go straight on. Main thread.
///
/// A body's velocity is that of each of its shapes since the step before. It is taken in the world or, where that is
/// less, in the field: a field that moves past a body that stands, or together with one, is not pushed by its motion.
/// What goes farther than FASTEST between two frames was set down elsewhere, and does not push by that.
class GroupBodies {
public:
	static constexpr double FASTEST = 50.0; ///< m/s.
	static constexpr double SHAPES_KEPT = 0.25; ///< s, after which a body's shapes are looked for anew.
	static constexpr double BODY_PATIENCE = 1.0; ///< s, until a body that cannot push is told of.
	static constexpr double GROUP_PATIENCE = 5.0; ///< s, until a group without members is told of.

	/// How far anything goes in a frame of `delta` seconds (m) that was not set down elsewhere.
	static float farthest_way(double delta);

	/// A body that came among plants, or left them.
	struct Event {
		uint64_t body; ///< Its instance id; it may be freed by now.
		bool has_entered;
	};

	/// Where bodies are looked for.
	struct Place {
		godot::SceneTree *tree = nullptr;
		uint64_t world = 0; ///< Instance id of the World3D; bodies in others do not push.
		godot::Transform3D axes; ///< From the field's to the world's, invertible.
	};

	/// Once in every frame, of `delta` seconds: notes where the bodies of `group` are. An empty group has no bodies.
	void watch(const Place &here, const godot::StringName &group, double delta);
	/// What pushes in a step whose time is `ago` seconds before this frame (0 to its delta), in field axes. Steps are
	/// asked for in their order. It holds until the next call.
	const std::vector<MovingBody> &gather(double ago);
	/// Which bodies `touches` has changed for, by what gather() gave last, and who left the group or the tree.
	std::vector<Event> find_events(const std::function<bool(const MovingBody &)> &touches);
	/// Calls visit(instance id, shape) for each shape that gather() gave last. For those who find events of their own,
	/// and drop_gone() then.
	void for_each_shape(const std::function<void(uint64_t, const MovingBody &)> &visit) const;
	/// Forgets who left the group or the tree.
	void drop_gone();
	/// What is amiss, with what to do; each once.
	std::vector<godot::String> take_warnings();
	/// Forgets all bodies without a word, as a field does that leaves the tree.
	void forget();

private:
	/// Where a shape is.
	struct Spot {
		MovingBody shape; ///< Field axes, without velocity.
		glm::vec3 in_world; ///< m, its middle.
	};
	struct Shape {
		uint64_t holder;
		Spot before; ///< In the frame before.
		Spot now;
		Spot stepped; ///< In the last step.
		double stepped_at = -1.0; ///< s of `time`; below 0: in none.
		bool is_here = false; ///< It can push in this frame.
		bool was_here = false;
	};
	struct Body {
		uint64_t id;
		std::vector<Shape> shapes;
		double age = 0.0; ///< s.
		double shapes_age = SHAPES_KEPT; ///< s.
		bool is_here = true;
		bool is_touching = false;
		size_t first = 0, count = 0; ///< Of what was gathered.
	};

	std::vector<Body> bodies;
	std::vector<MovingBody> gathered;
	godot::Transform3D axes, to_field;
	godot::StringName watched_group;
	double time = 0.0; ///< s.
	double frame = 0.0; ///< s, the last one's length.
	double empty_for = 0.0; ///< s without a member so far.
	bool is_group_known = false; ///< It has had a member, or was warned of.
	std::set<uint64_t> warned_of;
	std::vector<godot::String> warnings;

	void note_members(const godot::TypedArray<godot::Node> &nodes, uint64_t world, double delta);
	void note(const godot::Node3D *node, double delta);
	void find_shapes(Body &body, const godot::Node3D *node);
	void note_shape(Shape &shape);
	bool is_jump(const Spot &from, const Spot &to) const;
	glm::vec3 velocity(const Spot &from, const Spot &to, double seconds) const;
	void warn_of(const Body &body, const godot::Node *node);
	void warn_of_group(int64_t members, double delta);
};

} // namespace undergrowth
