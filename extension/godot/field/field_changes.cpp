#include "field/field_changes.hpp"

#include "stand/changes_finder.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace undergrowth {

static constexpr size_t SHOWN_AT_ONCE = 2000; // Plants per frame. If there are more, each is updated every few frames.

static bool is_there(const PlantStore &store, const PlantPlace &place) {
	const PlantBlock &block = store.block(place.block);
	return place.slot < block.size() && !block.is_gone(place.slot);
}

void FieldChanges::note_removed(const PlantStore &store, const std::vector<PlantPlace> &places) {
	std::map<double, std::vector<PlantId>> gone; // By spacing.
	for (const PlantPlace &place : places) {
		gone[store.block(place.block).spacing].push_back(store.id(place));
	}
	for (const auto &[spacing, ids] : gone) {
		changes.remove(ids, spacing);
	}
}

float FieldChanges::share_of(const PlantStore &store, const PlantPlace &place) const {
	if (changes.is_empty()) {
		return 1.0f;
	}
	const glm::vec3 root = store.block(place.block).root(place.slot);
	return changes.share_of(store.id(place), root.x, root.z);
}

void FieldChanges::show(
		const Growing &plant, const PlantStore &store, const FieldStyle &style, FieldMotion &motion) const {
	const PlacedPlant placed = store.block(plant.place.block).plants.plant(plant.place.slot);
	const float share = changes.share_of(plant.base);
	MotionPlant moved = style.looks[size_t(placed.species)].to_simulate(placed);
	moved.length *= share;
	motion.set_height(plant.place, share, moved);
}

void FieldChanges::mow(const std::vector<PlantPlace> &places, const std::vector<float> &shares, const PlantStore &store,
		const FieldStyle &style, FieldMotion &motion) {
	std::map<double, std::pair<std::vector<PlantId>, std::vector<float>>> by_spacing;
	for (size_t i = 0; i < places.size(); i++) {
		auto &[ids, of_them] = by_spacing[store.block(places[i].block).spacing];
		ids.push_back(store.id(places[i]));
		of_them.push_back(shares[i]);
	}
	for (const auto &[spacing, those] : by_spacing) {
		changes.mow(those.first, those.second, spacing);
	}
	std::vector<PlantPlace> mown = places;
	std::sort(mown.begin(), mown.end());
	const auto is_mown_anew = [&](const Growing &plant) {
		return std::binary_search(mown.begin(), mown.end(), plant.place);
	};
	growing.erase(std::remove_if(growing.begin(), growing.end(), is_mown_anew), growing.end());
	for (size_t i = 0; i < places.size(); i++) {
		const Growing plant = { places[i],
			double(std::max(shares[i], StandChanges::LEAST_SHARE)) - changes.grown_back() };
		show(plant, store, style, motion);
		if (shares[i] < 1.0f) {
			growing.push_back(plant);
		}
	}
}

void FieldChanges::forget_blocks(const std::vector<int> &blocks) {
	const auto is_of_them = [&](const Growing &plant) {
		return std::find(blocks.begin(), blocks.end(), plant.place.block) != blocks.end();
	};
	if (!blocks.empty() && !growing.empty()) {
		growing.erase(std::remove_if(growing.begin(), growing.end(), is_of_them), growing.end());
	}
}

// Also needed for a grown block, because its texels may be new.
void FieldChanges::look_at(int number, const PlantStore &store, const FieldStyle &style, FieldMotion &motion) {
	const PlantBlock &block = store.block(number);
	const bool may_be = block.is_added
			? !changes.of_added().empty()
			: changes.has_mown({ { block.low.x, block.low.z }, { block.high.x, block.high.z } });
	ChangesFinder finder(changes);
	for (int slot = 0; may_be && slot < block.size(); slot++) {
		const PlantPlace place = { number, slot };
		const float x = block.plants.x[size_t(slot)];
		const float z = block.plants.z[size_t(slot)];
		const double *base = block.is_added ? changes.find_mown(store.id(place), x, z) : finder.find_mown(x, z);
		if (base && !block.is_gone(slot)) {
			growing.push_back({ place, *base });
			show(growing.back(), store, style, motion);
		}
	}
}

void FieldChanges::follow(
		const ChangeSet &edit, const PlantStore &store, const FieldStyle &style, FieldMotion &motion) {
	forget_blocks(edit.dropped);
	std::vector<int> grown;
	for (const ChangeSet::Grown &block : edit.grown) {
		grown.push_back(block.block);
	}
	if (changes.is_empty()) {
		return;
	}
	forget_blocks(grown);
	for (const int block : grown) {
		look_at(block, store, style, motion);
	}
}

void FieldChanges::replace(
		StandChanges &&others, const PlantStore &store, const FieldStyle &style, FieldMotion &motion) {
	for (const Growing &plant : growing) {
		if (is_there(store, plant.place)) {
			show({ plant.place, 1.0 - changes.grown_back() }, store, style, motion);
		}
	}
	changes = std::move(others);
	follow_all(store, style, motion);
}

void FieldChanges::follow_all(const PlantStore &store, const FieldStyle &style, FieldMotion &motion) {
	growing.clear();
	for (int block = 0; block < store.block_count() && !changes.is_empty(); block++) {
		look_at(block, store, style, motion);
	}
}

bool FieldChanges::grow_back(double share, const PlantStore &store, const FieldStyle &style, FieldMotion &motion) {
	changes.grow_back(share);
	if (growing.empty() || share <= 0.0) {
		return false;
	}
	for (size_t left = std::min(growing.size(), SHOWN_AT_ONCE); left > 0 && !growing.empty(); left--) {
		next = next < growing.size() ? next : 0;
		const Growing plant = growing[next];
		const bool stands = is_there(store, plant.place);
		if (stands) {
			show(plant, store, style, motion);
		}
		if (stands && changes.share_of(plant.base) < 1.0f) {
			next++;
		} else {
			growing[next] = growing.back();
			growing.pop_back();
		}
	}
	return true;
}

} // namespace undergrowth
