#include "driven_plant.hpp"

namespace undergrowth {

void DrivenPlant::advance(double delta, const FieldWind &air, double &time) {
	for (int steps = clock.advance(delta); steps > 0; steps--) {
		group.step(air, time);
		swings.step(clock.step());
		time += clock.step();
	}
	group.pose(clock.alpha(), swings.now(clock.alpha()));
}

} // namespace undergrowth
