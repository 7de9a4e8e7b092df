#include "wind/world_air_sources.hpp"

#include "nodes/plant_wind_source_3d.hpp"

#include <algorithm>

namespace undergrowth {

void WorldAirSources::begin(double ago) {
	step_ago = ago;
	// Worlds without a use in the last step may be freed.
	const auto is_unused = [](const World &world) { return !world.is_read; };
	worlds.erase(std::remove_if(worlds.begin(), worlds.end(), is_unused), worlds.end());
	for (World &world : worlds) {
		world.is_read = false;
	}
}

const std::vector<AirSource> &WorldAirSources::in(uint64_t world) {
	auto found = std::find_if(worlds.begin(), worlds.end(), [world](const World &one) { return one.id == world; });
	if (found == worlds.end()) {
		worlds.push_back({ world, false, {} });
		found = worlds.end() - 1;
	}
	if (!found->is_read) {
		found->is_read = true;
		PlantWindSource3D::gather(world, step_ago, found->sources);
	}
	return found->sources;
}

} // namespace undergrowth
