#pragma once

#include "wind/air_tiles.hpp"

#include <memory>

namespace undergrowth {

/// The maps of turbulence, which all winds share: made once, beside the game.
class AirTilesCache {
public:
	/// Begins to make them, where nobody has.
	static void begin();
	/// Waits for them where they are not done.
	static std::shared_ptr<const AirTiles> get();
};

} // namespace undergrowth
