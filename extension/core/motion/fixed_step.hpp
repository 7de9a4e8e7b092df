#pragma once

namespace undergrowth {

/// Turns frames of any length into whole steps of a fixed length, so that the motion does not depend on the frame rate.
class FixedStep {
public:
	/// `step` in seconds, finite and > 0; at most `max_steps` steps a frame: the time beyond is dropped.
	explicit FixedStep(double step, int max_steps = 128);

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
