#pragma once

#include "wind/air_tiles.hpp"

#include <memory>

namespace undergrowth {

/// The maps of turbulence, which all winds share. A worker thread builds them once, while the game runs.
class AirTilesCache {
public:
	/// Starts the build, unless it has started.
	static void begin();
	/// Waits for the end of the build.
	static std::shared_ptr<const AirTiles> get();
};

} // namespace undergrowth
