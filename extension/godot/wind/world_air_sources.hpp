#pragma once

#include "wind/air_sources.hpp"

#include <cstdint>
#include <vector>

namespace undergrowth {

/// The sources that stir the air of each world in one step. A world is read at its first use in the step. Main thread.
class WorldAirSources {
public:
	/// Begins a step at `ago` seconds before this frame.
	void begin(double ago);
	/// Returns the sources in world axes. Valid until the next call.
	const std::vector<AirSource> &in(uint64_t world);

private:
	struct World {
		uint64_t id;
		bool is_read;
		std::vector<AirSource> sources;
	};

	std::vector<World> worlds;
	double step_ago = 0.0; ///< s.
};

} // namespace undergrowth
