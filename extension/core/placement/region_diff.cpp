#include "placement/region_diff.hpp"

#include <utility>

namespace undergrowth {

namespace {

bool are_alike(const FieldPlants &some, std::size_t i, const FieldPlants &others, std::size_t j) {
	return some.species[i] == others.species[j] && some.variant[i] == others.variant[j] &&
			some.height[i] == others.height[j] && some.scale[i] == others.scale[j] && some.x[i] == others.x[j] &&
			some.z[i] == others.z[j] && some.lightness[i] == others.lightness[j] && some.warmth[i] == others.warmth[j];
}

} // namespace

RegionDiff::RegionDiff(ExistingPlants &&existing, double cell_size) : before(std::move(existing)), spacing(cell_size) {
	by_id.reserve(before.refs.size());
	for (std::size_t i = 0; i < before.refs.size(); i++) {
		by_id[id_of(before.plants, i)] = i;
	}
}

PlantId RegionDiff::id_of(const FieldPlants &plants, std::size_t i) const {
	return generated_plant_id(plants.x[i], plants.z[i], spacing);
}

FieldPlants RegionDiff::find_new_plants(const FieldPlants &placed) {
	FieldPlants new_plants;
	std::vector<uint8_t> stays(before.refs.size(), 0);
	for (std::size_t i = 0; i < placed.x.size(); i++) {
		const PlantId id = id_of(placed, i);
		const auto found = by_id.find(id);
		const bool exists = found != by_id.end();
		if (exists && are_alike(placed, i, before.plants, found->second)) {
			stays[found->second] = 1;
			continue;
		}
		if (exists) {
			changed[id] = before.refs[found->second];
			stays[found->second] = 1; // make_edit() decides after the ground query.
		}
		new_plants.add(placed.plant(static_cast<int>(i)));
	}
	for (std::size_t i = 0; i < stays.size(); i++) {
		if (stays[i] == 0) {
			gone.push_back(before.refs[i]);
		}
	}
	return new_plants;
}

StoreEdit RegionDiff::make_edit(const FieldPlants &new_plants) const {
	StoreEdit edit;
	edit.removed = gone;
	std::unordered_map<PlantId, PlantRef> left = changed;
	for (std::size_t i = 0; i < new_plants.x.size(); i++) {
		const auto was = left.find(id_of(new_plants, i));
		edit.grown.push_back(new_plants.plant(static_cast<int>(i)));
		edit.grown_from.push_back(was == left.end() ? PlantRef() : was->second);
		if (was != left.end()) {
			left.erase(was);
		}
	}
	for (const auto &entry : left) {
		edit.removed.push_back(entry.second);
	}
	return edit;
}

} // namespace undergrowth
