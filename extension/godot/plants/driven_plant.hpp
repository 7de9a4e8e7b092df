#pragma once

#include "motion/fixed_step.hpp"
#include "motion/swing_clock.hpp"
#include "plants/plant_group.hpp"

namespace undergrowth {

/// A plant that code moves with advance(). It has a page and fixed steps of its own.
class DrivenPlant {
public:
	/// `step` in seconds.
	DrivenPlant(const PlantKind &kind, double step) : group(kind, float(step)), clock(step, MAX_STEPS_PER_CALL) {}

	PlantGroup group; ///< Contains this plant only.
	double step_length() const { return clock.step(); }
	/// Steps by `delta` seconds in `air` and poses the bones. Advances `time`, the clock of the wind (s), by the same
	/// steps.
	void advance(double delta, const FieldWind &air, double &time);

private:
	static constexpr int MAX_STEPS_PER_CALL = 128;

	FixedStep clock;
	SwingClock swings;
};

} // namespace undergrowth
