#pragma once

#include "field/contact.hpp"
#include "plants/plant_group.hpp"

#include <memory>
#include <vector>

namespace undergrowth {

/// Contact between `Plant3D`s: the tips of one world push each other away, across species and winds. Main thread.
class PlantContact {
public:
	/// Rebuilds the list of plants in contact. Call when such plants are added or removed.
	void follow(const std::vector<std::unique_ptr<PlantGroup>> &groups);
	bool is_needed() const { return !worlds.empty(); }
	/// Call once after each step.
	void resolve();
	/// True if the number of touching tips is above the limit, so that some pairs are skipped.
	bool is_crowded() const;

private:
	struct World {
		uint64_t id;
		PageRefs pages;
		TipContact tips;
	};

	std::vector<World> worlds;

	World &world_of(uint64_t id);
};

} // namespace undergrowth
