#pragma once

#include "field/contact.hpp"
#include "plant_group.hpp"

#include <memory>
#include <vector>

namespace undergrowth {

/// Contact of plants that stand alone: the tips of those in one world push each other away, whatever their species and
/// winds are. Main thread.
class PlantContact {
public:
	/// Whenever plants that touch came or went: which they are.
	void follow(const std::vector<std::unique_ptr<PlantGroup>> &groups);
	bool is_needed() const { return !worlds.empty(); }
	/// Once after each step.
	void resolve();
	/// Whether so many tips touch that some pairs are left out.
	bool is_crowded() const;

private:
	struct World {
		uint64_t id;
		LonePages pages;
		TipContact tips;
	};

	std::vector<World> worlds;

	World &world_of(uint64_t id);
};

} // namespace undergrowth
