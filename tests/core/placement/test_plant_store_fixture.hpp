#pragma once

#include "placement/plant_store.hpp"
#include "placement/test_placement_fixture.hpp"

#include <set>
#include <vector>

namespace undergrowth {

inline constexpr double SPACING = 0.5; // m, of the density 4.

inline StoreEdit replacing(const PlacementRequest &request, float tile_size = 16.0f) {
	StoreEdit edit;
	edit.replaces_all = true;
	edit.tile_size = tile_size;
	edit.spacing = Placement(request).cell_size();
	edit.generated = cut_into_chunks(placed(request), tile_size);
	return edit;
}

inline PlantStore filled_store(float side = 50.0f) {
	PlantStore store;
	store.apply(replacing(square_field(side, 4.0f, 2)));
	return store;
}

inline PlacedPlant plant_at(float x, float z, int species = 0) {
	PlacedPlant plant;
	plant.root = { x, 0.0f, z };
	plant.species = species;
	return plant;
}

inline std::set<PlantId> id_set(const PlantStore &store) {
	const std::vector<PlantId> ids = store.ids();
	return std::set<PlantId>(ids.begin(), ids.end());
}

} // namespace undergrowth
