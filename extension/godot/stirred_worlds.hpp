#pragma once

#include "wind/air_sources.hpp"

#include <cstdint>
#include <vector>

namespace undergrowth {

/// What stirs the air of each world in one step, read when it is first needed. Main thread.
class StirredWorlds {
public:
	/// A step whose time is `ago` seconds before this frame.
	void begin(double ago);
	/// In world axes. It holds until the next call.
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
