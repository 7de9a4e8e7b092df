#include "field/field_patches.hpp"

#include "field/field_recipe.hpp"

#include <glm/common.hpp>

#include <cmath>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr double MOST_WAITING_USEC = 500.0; // Per frame, so that a frame shows what was painted just before it.
static constexpr size_t MOST_STANDING = 6000; // Plants per job: copying them takes a fraction of a millisecond.

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
				return; // This many tiles cause a build of the whole field.
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
		if (dropped.count(one.number) == 0) {
			unseen.insert(one.number);
		}
	}
	job.reset();
	asker.forget();
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

void FieldPatches::begin(const FieldTiles::Scene &scene) {
	PatchRecipe recipe;
	recipe.boxes = take_boxes(scene.store, recipe.standing);
	if (recipe.boxes.empty()) {
		draw(scene);
		return;
	}
	AreaBox around = recipe.boxes.front();
	for (const AreaBox &box : recipe.boxes) {
		around = { glm::min(around.low, box.low), glm::max(around.high, box.high) };
	}
	const bool are_known = scene.style.listed_count == int(scene.properties.species.size());
	const String fault = read_request(scene.field, scene.properties, scene.style, &around, recipe.request);
	recipe.ground = scene.ground;
	recipe.changes = scene.changes.cut(around);
	recipe.spacing = scene.store.spacing();
	const double spacing = 1.0 / std::sqrt(double(recipe.request.density));
	if (fault.is_empty() && are_known && spacing == recipe.spacing) { // If false, a build starts soon.
		job = std::make_unique<FieldPatch>(std::move(recipe));
		job->place();
	}
}

void FieldPatches::ask_ground(const FieldTiles::Scene &scene, bool physics, double usec) {
	if (asker.serve(*job, scene.field, scene.properties, usec, physics, false) == GroundSurvey::State::failed) {
		scene.fault(asker.fault());
		job.reset();
	}
}

void FieldPatches::stand(const FieldTiles::Scene &scene) {
	StandEdit edit = job->take_edit();
	job.reset();
	if (double(scene.store.plant_count()) + double(edit.grown.size()) > PlacementRequest::MOST_PLANTS) {
		scene.fault(undergrowth::describe(PlacementFault::too_many_plants));
		return;
	}
	scene.apply(std::move(edit), nullptr);
	draw(scene);
}

// Draws all plants of the changed blocks, in a job of its own.
void FieldPatches::draw(const FieldTiles::Scene &scene) {
	if (unseen.empty()) {
		return;
	}
	std::vector<DrawnNewcomers> blocks;
	for (const int number : unseen) {
		blocks.push_back({ number, scene.store.block(number), scene.motion.texels(number), {} });
	}
	unseen.clear();
	dropped.clear();
	job = std::make_unique<FieldPatch>();
	job->draw(outline_of(scene.style), std::move(blocks));
}

void FieldPatches::show(const FieldTiles::Scene &scene) {
	for (const DrawnNewcomers &one : job->drawn()) {
		if (dropped.count(one.number) == 0) {
			scene.view.show_newcomers(scene.style, one.block.tile, one.number, one.plans);
		}
	}
	job.reset();
}

bool FieldPatches::go_on(const FieldTiles::Scene &scene, Moment moment, double ground_usec) {
	const bool may_show = moment != Moment::physics;
	if (job && job->is_drawing() && moment == Moment::ending) {
		job->wait_a_little(MOST_WAITING_USEC);
	}
	if (job && job->wants_ground() && moment != Moment::ending) {
		ask_ground(scene, moment == Moment::physics, ground_usec);
	}
	const bool stands = moment == Moment::begun && job && job->is_placed();
	if (stands) {
		stand(scene);
	}
	if (may_show && job && job->is_drawn()) {
		show(scene);
	}
	if (may_show && !job) {
		begin(scene);
	}
	return stands;
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
	if (job && !job->is_drawing()) {
		interrupt(); // Its input is out of date.
	}
}

} // namespace undergrowth
