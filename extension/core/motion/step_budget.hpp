#pragma once

namespace undergrowth {

/// Limits the steps of a frame to a time, so that a slow frame does not slow down the next one. The limit is set before
/// the first step, so that winds, bodies, plants and fields drop the same steps.
class StepBudget {
public:
	static constexpr double MAX_TIME = 1.0 / 30.0; ///< s, after which a frame begins no further step.

	/// Records that each step of a frame took `seconds`.
	void record(double seconds);
	/// Returns the number of steps to run of those that are `due`: at least one of them. It is less than `due` only if
	/// the last two frames were slow, because another program can interrupt one frame.
	int allow(int due) const;

private:
	double last = 0.0;
	double last_but_one = 0.0;
};

} // namespace undergrowth
