#include "field/field_patches.hpp"

#include <glm/common.hpp>

#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr size_t MOST_STANDING = 6000; // Plants of a job: copying them takes part of a millisecond.

static AreaBox common(const AreaBox &box, const TileKey &tile, float size) {
	return common_box(box, tile_box(tile, size));
}

void FieldPatches::touch(const AreaBox &box, float tile_size) {
	tile = tile_size;
	const TileKey first = tile_at(box.low.x, box.low.y, tile);
	const TileKey last = tile_at(box.high.x, box.high.y, tile);
	for (int column = first.column; column <= last.column; column++) {
		for (int row = first.row; row <= last.row; row++) {
			const AreaBox part = common(box, { column, row }, tile);
			if (part.low.x >= part.high.x || part.low.y >= part.high.y) {
				continue;
			}
			const auto known = touched.find({ column, row });
			if (known == touched.end()) {
				touched[{ column, row }] = part;
			} else {
				known->second = { glm::min(known->second.low, part.low), glm::max(known->second.high, part.high) };
			}
			if (touched.size() > MOST_TILES) {
				return; // The field is filled then.
			}
		}
	}
}

void FieldPatches::interrupt() {
	if (!job) {
		return;
	}
	for (const AreaBox &box : job->boxes()) {
		touch(box, tile);
	}
	for (const DrawnNewcomers &one : job->drawn()) {
		if (is_there(one.number)) {
			unseen.insert(one.number);
		}
	}
	job.reset();
}

std::vector<AreaBox> FieldPatches::take_boxes(const PlantStore &store, StandingPlants &standing) {
	std::vector<AreaBox> boxes;
	while (!touched.empty() && standing.places.size() < MOST_STANDING) {
		const AreaBox box = touched.begin()->second;
		touched.erase(touched.begin());
		const StandingPlants some = store.filled_in(box);
		standing.plants.append(some.plants);
		standing.places.insert(standing.places.end(), some.places.begin(), some.places.end());
		boxes.push_back(box);
	}
	return boxes;
}

void FieldPatches::start(PatchRecipe &&recipe) {
	job = std::make_unique<FieldPatch>(std::move(recipe));
	job->place();
}

void FieldPatches::follow(const ChangeSet &changes, const PlantStore &store) {
	for (const int block : changes.dropped) {
		unseen.erase(block);
		dropped.insert(block);
	}
	for (const ChangeSet::Grown &grown : changes.grown) {
		if (store.block(grown.block).is_late) {
			unseen.insert(grown.block);
		}
	}
	if (job && job->drawn().empty()) {
		interrupt(); // It knows others than those who stand now.
	}
}

bool FieldPatches::draw(const FieldStyle &style, const PlantStore &store, const FieldMotion &motion) {
	if (unseen.empty()) {
		return false;
	}
	std::vector<DrawnNewcomers> blocks;
	for (const int number : unseen) {
		blocks.push_back({ number, store.block(number), motion.texels(number), {} });
	}
	unseen.clear();
	dropped.clear();
	if (!job) {
		job = std::make_unique<FieldPatch>();
	}
	job->draw(outline_of(style), std::move(blocks));
	return true;
}

} // namespace undergrowth
