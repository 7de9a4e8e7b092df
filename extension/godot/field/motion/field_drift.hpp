#pragma once

#include "wind/air_drift.hpp"

#include <godot_cpp/variant/transform3d.hpp>

namespace undergrowth {

/// Measures how fast a field's node moves and turns, from its transform in each frame, interpolated linearly between
/// frames. A node that moves farther than GroupBodies::farthest_way() or turns by more than half a radian in a frame
/// was teleported: its velocity restarts at 0. Main thread.
class FieldDrift {
public:
	/// Call once per frame of `delta` seconds. `axes`: from the field's axes to the world's, invertible.
	void watch(const godot::Transform3D &axes, double delta);
	/// Call once per step, `ago` seconds before this frame. Returns the mean of the last STEPS steps, in the field's
	/// axes. The mean smooths nodes that move in physics frames: they advance by two physics frames in some drawn
	/// frames and by none in other ones.
	AirDrift step(double ago);

private:
	static constexpr int STEPS = 4;

	godot::Transform3D before; ///< In the previous frame.
	godot::Transform3D now;
	godot::Transform3D stepped[STEPS]; ///< In the last steps, as a ring.
	double stepped_at[STEPS] = {}; ///< Values of `time` (s).
	int newest = 0; ///< Index in both rings.
	double time = 0.0; ///< s.
	double frame = 0.0; ///< Length of the last frame (s).
	bool is_moving = false; ///< True if the node moved in the last steps or since.
	bool is_placed = false;

	bool is_jump() const;
	void begin();
};

} // namespace undergrowth
