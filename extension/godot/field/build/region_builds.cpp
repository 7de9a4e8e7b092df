#include "field/build/region_builds.hpp"

#include "field/build/build_input.hpp"

#include <glm/common.hpp>

#include <cmath>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr double MAX_WAIT_USEC = 500.0; // Per frame, so that a frame shows what was painted just before it.
static constexpr size_t MAX_EXISTING_PLANTS = 6000; // Plants per job: copying them takes a fraction of a millisecond.

static AreaBox common(const AreaBox &box, const TileKey &tile, float size) {
	return common_box(box, tile_box(tile, size));
}

void RegionBuilds::touch(const AreaBox &box, float tile_size) {
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
			if (touched.size() > MAX_TILES) {
				return; // This many tiles cause a build of the whole field.
			}
		}
	}
}

void RegionBuilds::interrupt() {
	if (!job) {
		return;
	}
	for (const AreaBox &box : job->boxes()) {
		touch(box, tile);
	}
	for (const NewChunk &one : job->drawn()) {
		if (dropped.count(one.number) == 0) {
			unseen.insert(one.number);
		}
	}
	job.reset();
	ground_queue.forget();
}

std::vector<AreaBox> RegionBuilds::take_boxes(const PlantStore &store, ExistingPlants &existing) {
	std::vector<AreaBox> boxes;
	while (!touched.empty() && existing.refs.size() < MAX_EXISTING_PLANTS) {
		const AreaBox box = touched.begin()->second;
		touched.erase(touched.begin());
		const ExistingPlants some = store.generated_in(box);
		existing.plants.append(some.plants);
		existing.refs.insert(existing.refs.end(), some.refs.begin(), some.refs.end());
		boxes.push_back(box);
	}
	return boxes;
}

void RegionBuilds::begin(const FieldTiles::Scene &scene) {
	RegionBuildInput input;
	input.boxes = take_boxes(scene.store, input.existing);
	if (input.boxes.empty()) {
		draw(scene);
		return;
	}
	AreaBox around = input.boxes.front();
	for (const AreaBox &box : input.boxes) {
		around = { glm::min(around.low, box.low), glm::max(around.high, box.high) };
	}
	const bool are_known = scene.setup.listed_count == int(scene.properties.species.size());
	const String fault = read_request(scene.field, scene.properties, scene.setup, &around, input.request);
	input.ground = scene.ground;
	input.edits = scene.edits.cut(around);
	input.spacing = scene.store.spacing();
	const double spacing = 1.0 / std::sqrt(double(input.request.density));
	if (fault.is_empty() && are_known && spacing == input.spacing) { // If false, a build starts soon.
		job = std::make_unique<RegionBuild>(std::move(input));
		job->place();
	}
}

void RegionBuilds::poll_ground(const FieldTiles::Scene &scene, bool physics, double usec) {
	if (ground_queue.serve(*job, scene.field, scene.properties, usec, physics, false) == GroundSampler::State::failed) {
		scene.fault(ground_queue.fault());
		job.reset();
	}
}

void RegionBuilds::apply_edit(const FieldTiles::Scene &scene) {
	StoreEdit edit = job->take_edit();
	job.reset();
	if (double(scene.store.plant_count()) + double(edit.grown.size()) > PlacementRequest::MAX_PLANTS) {
		scene.fault(undergrowth::describe(PlacementFault::too_many_plants));
		return;
	}
	scene.apply(std::move(edit), nullptr);
	draw(scene);
}

// Draws all plants of the changed chunks, in a job of its own.
void RegionBuilds::draw(const FieldTiles::Scene &scene) {
	if (unseen.empty()) {
		return;
	}
	std::vector<NewChunk> chunks;
	for (const int number : unseen) {
		chunks.push_back({ number, scene.store.chunk(number), scene.motion.texels(number), {} });
	}
	unseen.clear();
	dropped.clear();
	job = std::make_unique<RegionBuild>();
	job->draw(outline_of(scene.setup), std::move(chunks));
}

void RegionBuilds::show(const FieldTiles::Scene &scene) {
	for (const NewChunk &one : job->drawn()) {
		if (dropped.count(one.number) == 0) {
			scene.view.show_new_chunk(scene.setup, one.chunk.tile, one.number, one.plans);
		}
	}
	job.reset();
}

bool RegionBuilds::resume(const FieldTiles::Scene &scene, Moment moment, double ground_usec) {
	const bool may_show = moment != Moment::physics;
	if (job && job->is_drawing() && moment == Moment::ending) {
		job->wait_a_little(MAX_WAIT_USEC);
	}
	if (job && job->needs_ground() && moment != Moment::ending) {
		poll_ground(scene, moment == Moment::physics, ground_usec);
	}
	const bool is_applied = moment == Moment::begun && job && job->is_placed();
	if (is_applied) {
		apply_edit(scene);
	}
	if (may_show && job && job->is_drawn()) {
		show(scene);
	}
	if (may_show && !job) {
		begin(scene);
	}
	return is_applied;
}

void RegionBuilds::follow(const ChangeSet &changes, const PlantStore &store) {
	for (const int chunk : changes.dropped) {
		unseen.erase(chunk);
		dropped.insert(chunk);
	}
	for (const ChangeSet::Grown &grown : changes.grown) {
		if (store.chunk(grown.chunk).is_new) {
			unseen.insert(grown.chunk);
		}
	}
	if (job && !job->is_drawing()) {
		interrupt(); // Its input is out of date.
	}
}

} // namespace undergrowth
