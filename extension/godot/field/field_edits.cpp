#include "field/field_edits.hpp"

#include "placement/edit_finder.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace undergrowth {

static constexpr size_t SHOWN_AT_ONCE = 2000; // Plants per frame. If there are more, each is updated every few frames.

static bool is_there(const PlantStore &store, const PlantRef &ref) {
	const PlantChunk &chunk = store.chunk(ref.chunk);
	return ref.slot < chunk.size() && !chunk.is_gone(ref.slot);
}

void FieldEdits::note_removed(const PlantStore &store, const std::vector<PlantRef> &refs) {
	std::map<double, std::vector<PlantId>> gone; // By spacing.
	for (const PlantRef &ref : refs) {
		gone[store.chunk(ref.chunk).spacing].push_back(store.id(ref));
	}
	for (const auto &[spacing, ids] : gone) {
		edits.remove(ids, spacing);
	}
}

float FieldEdits::share_of(const PlantStore &store, const PlantRef &ref) const {
	if (edits.is_empty()) {
		return 1.0f;
	}
	const glm::vec3 root = store.chunk(ref.chunk).root(ref.slot);
	return edits.share_of(store.id(ref), root.x, root.z);
}

void FieldEdits::show(
		const Growing &plant, const PlantStore &store, const FieldRenderSetup &setup, FieldMotion &motion) const {
	const PlacedPlant placed = store.chunk(plant.ref.chunk).plants.plant(plant.ref.slot);
	const float share = edits.share_of(plant.base);
	MotionPlant moved = setup.styles[size_t(placed.species)].to_simulate(placed);
	moved.length *= share;
	motion.set_height(plant.ref, share, moved);
}

void FieldEdits::mow(const std::vector<PlantRef> &refs, const std::vector<float> &shares, const PlantStore &store,
		const FieldRenderSetup &setup, FieldMotion &motion) {
	std::map<double, std::pair<std::vector<PlantId>, std::vector<float>>> by_spacing;
	for (size_t i = 0; i < refs.size(); i++) {
		auto &[ids, of_them] = by_spacing[store.chunk(refs[i].chunk).spacing];
		ids.push_back(store.id(refs[i]));
		of_them.push_back(shares[i]);
	}
	for (const auto &[spacing, those] : by_spacing) {
		edits.mow(those.first, those.second, spacing);
	}
	std::vector<PlantRef> mown = refs;
	std::sort(mown.begin(), mown.end());
	const auto is_mown_again = [&](const Growing &plant) {
		return std::binary_search(mown.begin(), mown.end(), plant.ref);
	};
	growing.erase(std::remove_if(growing.begin(), growing.end(), is_mown_again), growing.end());
	for (size_t i = 0; i < refs.size(); i++) {
		const Growing plant = { refs[i], double(std::max(shares[i], EditLog::MIN_SHARE)) - edits.grown_back() };
		show(plant, store, setup, motion);
		if (shares[i] < 1.0f) {
			growing.push_back(plant);
		}
	}
}

void FieldEdits::forget_chunks(const std::vector<int> &chunks) {
	const auto is_of_them = [&](const Growing &plant) {
		return std::find(chunks.begin(), chunks.end(), plant.ref.chunk) != chunks.end();
	};
	if (!chunks.empty() && !growing.empty()) {
		growing.erase(std::remove_if(growing.begin(), growing.end(), is_of_them), growing.end());
	}
}

// Also needed for a grown chunk, because its texels may be new.
void FieldEdits::read_chunk(int number, const PlantStore &store, const FieldRenderSetup &setup, FieldMotion &motion) {
	const PlantChunk &chunk = store.chunk(number);
	const bool may_be = chunk.is_added
			? !edits.of_added().empty()
			: edits.has_mown({ { chunk.low.x, chunk.low.z }, { chunk.high.x, chunk.high.z } });
	EditFinder finder(edits);
	for (int slot = 0; may_be && slot < chunk.size(); slot++) {
		const PlantRef ref = { number, slot };
		const float x = chunk.plants.x[size_t(slot)];
		const float z = chunk.plants.z[size_t(slot)];
		const double *base = chunk.is_added ? edits.find_mown(store.id(ref), x, z) : finder.find_mown(x, z);
		if (base && !chunk.is_gone(slot)) {
			growing.push_back({ ref, *base });
			show(growing.back(), store, setup, motion);
		}
	}
}

void FieldEdits::follow(
		const ChangeSet &edit, const PlantStore &store, const FieldRenderSetup &setup, FieldMotion &motion) {
	forget_chunks(edit.dropped);
	std::vector<int> grown;
	for (const ChangeSet::Grown &chunk : edit.grown) {
		grown.push_back(chunk.chunk);
	}
	if (edits.is_empty()) {
		return;
	}
	forget_chunks(grown);
	for (const int chunk : grown) {
		read_chunk(chunk, store, setup, motion);
	}
}

void FieldEdits::replace(
		EditLog &&others, const PlantStore &store, const FieldRenderSetup &setup, FieldMotion &motion) {
	for (const Growing &plant : growing) {
		if (is_there(store, plant.ref)) {
			show({ plant.ref, 1.0 - edits.grown_back() }, store, setup, motion);
		}
	}
	edits = std::move(others);
	follow_all(store, setup, motion);
}

void FieldEdits::follow_all(const PlantStore &store, const FieldRenderSetup &setup, FieldMotion &motion) {
	growing.clear();
	for (int chunk = 0; chunk < store.chunk_count() && !edits.is_empty(); chunk++) {
		read_chunk(chunk, store, setup, motion);
	}
}

bool FieldEdits::grow_back(double share, const PlantStore &store, const FieldRenderSetup &setup, FieldMotion &motion) {
	edits.grow_back(share);
	if (growing.empty() || share <= 0.0) {
		return false;
	}
	for (size_t left = std::min(growing.size(), SHOWN_AT_ONCE); left > 0 && !growing.empty(); left--) {
		next = next < growing.size() ? next : 0;
		const Growing plant = growing[next];
		const bool exists = is_there(store, plant.ref);
		if (exists) {
			show(plant, store, setup, motion);
		}
		if (exists && edits.share_of(plant.base) < 1.0f) {
			next++;
		} else {
			growing[next] = growing.back();
			growing.pop_back();
		}
	}
	return true;
}

} // namespace undergrowth
