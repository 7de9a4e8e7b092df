#pragma once

namespace undergrowth {

/// Turns frames of any length into whole steps of a fixed length, so that the motion does not depend on the frame rate.
class FixedStep {
public:
	static constexpr double LONGEST_FRAME = 8.0 / 60.0; ///< s, maximum time that a frame catches up.

	/// `step` in seconds, finite and > 0; at most `max_steps` steps a frame: further time is dropped.
	FixedStep(double step, int max_steps);
	/// Limits a frame to the steps of LONGEST_FRAME, and at least two.
	explicit FixedStep(double step);

	/// Returns the number of steps to run now. A delta that is negative or not finite counts as 0.
	int advance(double delta);
	/// Position of the present between the last but one step (0) and the last (1), for MotionPage::interpolate().
	float alpha() const;
	double step() const;

private:
	double step_length;
	double left = 0.0;
	int step_limit;
};

} // namespace undergrowth
