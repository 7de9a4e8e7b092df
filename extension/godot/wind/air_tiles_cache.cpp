#include "wind/air_tiles_cache.hpp"

#include "base/workers.hpp"

#include <future>
#include <mutex>

namespace undergrowth {

static constexpr uint64_t SEED = 0;

using Tiles = std::shared_ptr<const AirTiles>;

// The destructor of the static object waits for the thread when the library is unloaded.
static std::shared_future<Tiles> &making() {
	static std::shared_future<Tiles> one;
	return one;
}

void AirTilesCache::begin() {
	static std::mutex only_once;
	const std::lock_guard<std::mutex> lock(only_once);
	if (!making().valid()) {
		// Without threads the first get() builds them.
		const std::launch when = Workers::are_used() ? std::launch::async : std::launch::deferred;
		making() = std::async(when, make_air_tiles, SEED).share();
	}
}

Tiles AirTilesCache::get() {
	begin();
	return making().get();
}

} // namespace undergrowth
