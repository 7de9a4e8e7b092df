#include "stand/kept_plants.hpp"

#include <algorithm>

namespace undergrowth {

namespace {

/// Whether the same plants stand as before, as after most changes: no names need be compared then.
bool are_the_same(const std::vector<NumberedBlock> &before, const std::vector<PlantBlock> &now) {
	return std::equal(
			before.begin(), before.end(), now.begin(), now.end(), [](const auto &old, const PlantBlock &block) {
				return old.second.gone == 0 && old.second.plants.x == block.plants.x &&
						old.second.plants.z == block.plants.z;
			});
}

std::vector<KeptPlant> keep_all(const std::vector<NumberedBlock> &before) {
	std::vector<KeptPlant> kept;
	for (std::size_t i = 0; i < before.size(); i++) {
		for (int slot = 0; slot < before[i].second.size(); slot++) {
			kept.push_back({ { before[i].first, slot }, { static_cast<int>(i), slot } });
		}
	}
	return kept;
}

using NamedPlace = std::pair<PlantId, PlantPlace>;

bool is_less(const NamedPlace &a, const NamedPlace &b) {
	return a.first < b.first;
}

NamedPlace name(const PlantBlock &block, int number, int slot, double spacing) {
	const glm::vec3 root = block.root(slot);
	return { filled_plant_id(root.x, root.z, spacing), { number, slot } };
}

} // namespace

std::vector<KeptPlant> find_kept(const std::vector<NumberedBlock> &before, double old_spacing,
		const std::vector<PlantBlock> &now, double spacing) {
	if (spacing == old_spacing && are_the_same(before, now)) {
		return keep_all(before);
	}
	std::vector<NamedPlace> names;
	for (const auto &[number, block] : before) {
		for (int slot = 0; slot < block.size(); slot++) {
			if (!block.is_gone(slot)) {
				names.push_back(name(block, number, slot, old_spacing));
			}
		}
	}
	std::sort(names.begin(), names.end(), is_less);
	std::vector<KeptPlant> kept;
	for (std::size_t i = 0; i < now.size() && !names.empty(); i++) {
		for (int slot = 0; slot < now[i].size(); slot++) {
			const NamedPlace wanted = name(now[i], static_cast<int>(i), slot, spacing);
			const auto found = std::lower_bound(names.begin(), names.end(), wanted, is_less);
			if (found != names.end() && found->first == wanted.first) {
				kept.push_back({ found->second, wanted.second });
			}
		}
	}
	return kept;
}

} // namespace undergrowth
