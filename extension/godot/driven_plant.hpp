#pragma once

#include "motion/fixed_step.hpp"
#include "motion/swing_clock.hpp"
#include "plant_group.hpp"

namespace undergrowth {

/// A plant that is driven by hand: a page of its own, and its own fixed steps.
class DrivenPlant {
public:
	/// `step`: s.
	DrivenPlant(const PlantKind &kind, double step) : group(kind, float(step)), clock(step, MOST_STEPS_OF_CALL) {}

	PlantGroup group; ///< Of this plant alone.
	double step_length() const { return clock.step(); }
	/// Goes on by `delta` seconds in `air` and poses the bones. `time` is the wind's clock (s), which goes on with the
	/// steps.
	void advance(double delta, const FieldWind &air, double &time);

private:
	static constexpr int MOST_STEPS_OF_CALL = 128;

	FixedStep clock;
	SwingClock swings;
};

} // namespace undergrowth
