#include "plants/driven_plant.hpp"

#include "nodes/plant_wind_source_3d.hpp"

namespace undergrowth {

void DrivenPlant::advance(double delta, const FieldWind &air, double &time) {
	std::vector<AirSource> stirring;
	PlantWindSource3D::gather(group.kind.forces.world, 0.0, stirring);
	for (int steps = clock.advance(delta); steps > 0; steps--) {
		group.step(air, time, stirring);
		swings.step(clock.step());
		time += clock.step();
	}
	group.pose(clock.alpha(), swings.now(clock.alpha()));
}

} // namespace undergrowth
