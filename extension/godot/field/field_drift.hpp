#pragma once

#include "wind/air_drift.hpp"

#include <godot_cpp/variant/transform3d.hpp>

namespace undergrowth {

/// How fast a field's node moves and turns: where it is is noted in each frame, and between two frames it moves
/// straight on. A node that moves farther than GroupBodies::farthest_way(), or turns by more than half a radian, was
/// set down elsewhere. Main thread.
class FieldDrift {
public:
	/// Once in every frame, of `delta` seconds. `axes`: from the field's axes to the world's, invertible.
	void watch(const godot::Transform3D &axes, double delta);
	/// Once in every step, whose time is `ago` seconds before this frame: the mean of the last STEPS steps, in the
	/// field's axes. A node that moves in physics frames advances in some drawn frames by two of them and in others by
	/// none.
	AirDrift step(double ago);

private:
	static constexpr int STEPS = 4;

	godot::Transform3D before; ///< In the frame before.
	godot::Transform3D now;
	godot::Transform3D stepped[STEPS]; ///< In the last steps: a ring.
	double stepped_at[STEPS] = {}; ///< s of `time`.
	int newest = 0; ///< Of both rings.
	double time = 0.0; ///< s.
	double frame = 0.0; ///< s, the last one's length.
	bool is_moving = false; ///< In the last steps or since.
	bool is_placed = false;

	bool is_jump() const;
	void begin();
};

} // namespace undergrowth
