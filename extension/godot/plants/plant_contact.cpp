#include "plants/plant_contact.hpp"

#include <algorithm>

namespace undergrowth {

void PlantContact::follow(const std::vector<std::unique_ptr<PlantGroup>> &groups) {
	for (World &world : worlds) {
		world.pages.clear();
	}
	for (const std::unique_ptr<PlantGroup> &group : groups) {
		if (group->kind.forces.has_contact) {
			world_of(group->kind.forces.world).pages.add(group->page, group->turned_axes());
		}
	}
	const auto is_empty = [](const World &world) { return world.pages.page_count() == 0; };
	worlds.erase(std::remove_if(worlds.begin(), worlds.end(), is_empty), worlds.end());
	for (World &world : worlds) {
		world.tips.fit(world.pages);
	}
}

PlantContact::World &PlantContact::world_of(uint64_t id) {
	const auto found = std::find_if(worlds.begin(), worlds.end(), [id](const World &world) { return world.id == id; });
	return found != worlds.end() ? *found : worlds.emplace_back(World{ id, {}, {} });
}

void PlantContact::resolve() {
	for (World &world : worlds) {
		world.tips.resolve(world.pages);
	}
}

bool PlantContact::is_crowded() const {
	return std::any_of(worlds.begin(), worlds.end(), [](const World &world) { return world.tips.is_crowded(); });
}

} // namespace undergrowth
