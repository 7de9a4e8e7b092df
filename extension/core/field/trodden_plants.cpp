#include "field/trodden_plants.hpp"

#include <glm/geometric.hpp>

#include <algorithm>

namespace undergrowth {

glm::vec2 TroddenPlants::present(const Trodden &plant) const {
	Trampling trampling;
	trampling.recovery = plant.recovery;
	const glm::vec2 bend = plant.bend * trampling.kept(static_cast<float>(now - plant.since));
	return glm::length(bend) < LastingBends::MIN ? glm::vec2(0.0f) : bend;
}

void TroddenPlants::put(PlantId id, const glm::vec2 &bend, float recovery) {
	const Trodden plant = { bend, recovery, now };
	if (present(plant) == glm::vec2(0.0f)) {
		plants.erase(id);
		return;
	}
	plants[id] = plant;
	if (plants.size() >= next_check) {
		remove_recovered();
	}
}

void TroddenPlants::remove_recovered() {
	for (auto plant = plants.begin(); plant != plants.end();) {
		plant = present(plant->second) == glm::vec2(0.0f) ? plants.erase(plant) : std::next(plant);
	}
	next_check = std::max(2 * plants.size(), MIN_CHECK);
}

glm::vec2 TroddenPlants::take(PlantId id) {
	const auto found = plants.find(id);
	if (found == plants.end()) {
		return { 0.0f, 0.0f };
	}
	const glm::vec2 bend = present(found->second);
	plants.erase(found);
	return bend;
}

std::vector<TroddenPlant> TroddenPlants::all() const {
	std::vector<TroddenPlant> list;
	for (const auto &[id, plant] : plants) {
		const glm::vec2 bend = present(plant);
		if (bend != glm::vec2(0.0f)) {
			list.push_back({ id, bend });
		}
	}
	return list;
}

} // namespace undergrowth
