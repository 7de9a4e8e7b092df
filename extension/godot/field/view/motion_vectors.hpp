#pragma once

namespace undergrowth {

/// What a field showed in the last drawn frame, for the motion vectors that Forward+ writes for TAA, FSR 2 and effects.
///
/// The engine writes vectors only for instances whose transform has changed. It calls the vertex function a second
/// time, with the previous transform and the present textures. So the field tilts its instances by a tiny angle to
/// alternating sides. The sign of the tilt shows the shader which call is the previous one.
class MotionVectors {
public:
	static constexpr float TILT = 7.62939453125e-6f; ///< 2^-17: x of a plant's y axis, in the field's axes.

	/// The state of a field in a frame.
	struct Shown {
		double steps = 0.0; ///< Position of the drawn frame in the steps of the motion.
		float clock = 0.0f; ///< Drawn swing clock.
	};
	/// Parameter undergrowth_before of the shader, and the tilt of the instances.
	struct Sent {
		float tilt = 0.0f; ///< 0: no vectors.
		float clock = 0.0f; ///< Of the previous frame.
		float steps = 0.0f; ///< Time since the previous frame.

		bool operator==(const Sent &other) const {
			return tilt == other.tilt && clock == other.clock && steps == other.steps;
		}
	};

	/// Call once before each drawn frame. `is_wanted`: a camera of the field needs vectors. Returns what to send. A
	/// field that did not move keeps its tilt, so the engine writes no vectors for it. After a jump of more than
	/// MAX_STEPS, plants have vectors of length 0.
	Sent next(const Shown &now, bool is_wanted);

private:
	static constexpr double MAX_STEPS = 8.0;

	Shown before;
	Sent sent;
	bool has_before = false;
};

} // namespace undergrowth
