#include "stand/stand_patch.hpp"

#include <utility>

namespace undergrowth {

namespace {

bool are_alike(const FieldPlants &some, std::size_t i, const FieldPlants &others, std::size_t j) {
	return some.species[i] == others.species[j] && some.variant[i] == others.variant[j] &&
			some.height[i] == others.height[j] && some.scale[i] == others.scale[j] && some.x[i] == others.x[j] &&
			some.z[i] == others.z[j];
}

} // namespace

StandPatch::StandPatch(StandingPlants &&standing, double cell_size) : before(std::move(standing)), spacing(cell_size) {
	named.reserve(before.places.size());
	for (std::size_t i = 0; i < before.places.size(); i++) {
		named[name_of(before.plants, i)] = i;
	}
}

PlantId StandPatch::name_of(const FieldPlants &plants, std::size_t i) const {
	return filled_plant_id(plants.x[i], plants.z[i], spacing);
}

FieldPlants StandPatch::find_newcomers(const FieldPlants &placed) {
	FieldPlants newcomers;
	std::vector<uint8_t> stays(before.places.size(), 0);
	for (std::size_t i = 0; i < placed.x.size(); i++) {
		const PlantId name = name_of(placed, i);
		const auto found = named.find(name);
		const bool stands = found != named.end();
		if (stands && are_alike(placed, i, before.plants, found->second)) {
			stays[found->second] = 1;
			continue;
		}
		if (stands) {
			changed[name] = before.places[found->second];
			stays[found->second] = 1; // make_edit() decides after the ground query.
		}
		newcomers.add(placed.plant(static_cast<int>(i)));
	}
	for (std::size_t i = 0; i < stays.size(); i++) {
		if (stays[i] == 0) {
			gone.push_back(before.places[i]);
		}
	}
	return newcomers;
}

StandEdit StandPatch::make_edit(const FieldPlants &newcomers) const {
	StandEdit edit;
	edit.removed = gone;
	std::unordered_map<PlantId, PlantPlace> left = changed;
	for (std::size_t i = 0; i < newcomers.x.size(); i++) {
		const auto was = left.find(name_of(newcomers, i));
		edit.grown.push_back(newcomers.plant(static_cast<int>(i)));
		edit.grown_from.push_back(was == left.end() ? PlantPlace() : was->second);
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
