#pragma once

namespace undergrowth {

/// Turns frames of any length into whole steps of a fixed length, so that the motion does not depend on the frame rate.
class FixedStep {
public:
	static constexpr double LONGEST_FRAME = 8.0 / 60.0; ///< s that a frame catches up at most.
	/// s that the steps of a frame may take: whoever does them drops the rest after it, but for the first.
	static constexpr double MOST_STEPPING = 1.0 / 30.0;

	/// `step` in seconds, finite and > 0; at most `max_steps` steps a frame: the time beyond is dropped.
	FixedStep(double step, int max_steps);
	/// For frames that may be late: at most as many steps as LONGEST_FRAME holds, and two at least.
	explicit FixedStep(double step);

	/// Steps to do now. A delta that is negative or not finite counts as 0.
	int advance(double delta);
	/// How far the present is from the last step but one (0) to the last (1), for MotionPage::interpolate().
	float alpha() const;
	double step() const;

private:
	double step_length;
	double left = 0.0;
	int most;
};

} // namespace undergrowth
