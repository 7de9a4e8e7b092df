#include "field/build/tile_rebuild.hpp"

#include "field/build/build_input.hpp"
#include "field/build/region_build.hpp"
#include "placement/edit_finder.hpp"
#include "placement/tile_choice.hpp"

#include <algorithm>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr double MIN_GROUND_USEC = 1000.0; // Per frame.
static constexpr double MAX_TILES = 4096.0;
static constexpr double MIN_PLANTS = 32.0; // In a full tile.
static constexpr double MAX_PLANTS = 2.0e6; // Graphics cards have texels for these plus the same number of old plants.

static double spacing_of(const PlacementRequest &request) {
	PlacementRequest nothing = request;
	nothing.within = AreaBox();
	return Placement(nothing).cell_size();
}

// Appends the tiles that meet the area of a request. Returns false if they are too many.
static bool add_tiles_of_area(const PlacementRequest &request, float size, std::vector<TileKey> &all) {
	const AreaBox box = placed_box(request);
	const TileKey first = tile_at(box.low.x, box.low.y, size);
	const TileKey last = tile_at(box.high.x, box.high.y, size);
	if (double(last.column - first.column + 1) * double(last.row - first.row + 1) > MAX_TILES) {
		return false;
	}
	for (int column = first.column; column <= last.column; column++) {
		for (int row = first.row; row <= last.row; row++) {
			all.push_back({ column, row });
		}
	}
	return true;
}

static void sort_farthest_first(const FieldTiles::Scene &scene, float size, std::vector<TileKey> &tiles) {
	std::vector<glm::vec2> places = FieldTiles::places_of(scene);
	places.resize(std::max(places.size(), size_t(1)), glm::vec2(0.0f));
	std::vector<std::pair<float, TileKey>> sorted;
	sorted.reserve(tiles.size());
	for (const TileKey &tile : tiles) {
		sorted.emplace_back(-distance_to_tile(tile, size, places), tile);
	}
	std::sort(sorted.begin(), sorted.end());
	std::transform(sorted.begin(), sorted.end(), tiles.begin(), [](const auto &entry) { return entry.second; });
}

std::vector<TileKey> TileRebuild::list_first(const Scene &scene, const PlacementRequest &request) {
	const float size = float(scene.properties.tile_size);
	const double each = double(request.density) * double(size) * double(size);
	std::vector<TileKey> all;
	if (each < MIN_PLANTS || !add_tiles_of_area(request, size, all) ||
			each * double(all.size()) > PlacementRequest::MAX_PLANTS) {
		return {};
	}
	sort_farthest_first(scene, size, all);
	return all;
}

std::vector<TileKey> TileRebuild::list(const Scene &scene, const PlacementRequest &request, const FieldTiles &tiles) {
	const float size = scene.store.tile_size();
	const double each = double(request.density) * double(size) * double(size);
	std::vector<TileKey> all = scene.store.generated_tiles();
	if (all.empty() || each < MIN_PLANTS || !scene.store.has_unused_ids(spacing_of(request))) {
		return {};
	}
	if (scene.properties.view_distance > 0.0) {
		const std::vector<TileKey> near = tiles.choose_all(scene, request);
		all.insert(all.end(), near.begin(), near.end());
	} else if (!add_tiles_of_area(request, size, all)) {
		return {};
	}
	std::sort(all.begin(), all.end());
	all.erase(std::unique(all.begin(), all.end()), all.end());
	if (double(all.size()) > MAX_TILES || each * double(all.size()) > MAX_PLANTS) {
		return {};
	}
	sort_farthest_first(scene, size, all);
	return all;
}

void TileRebuild::begin(std::vector<TileKey> &&tiles, const PlacementRequest &request) {
	waiting = std::move(tiles);
	tile_count = waiting.size();
	placed_at = spacing_of(request);
	base = request;
	base.map.reset();
}

float TileRebuild::progress() const {
	const size_t left = waiting.size() + jobs.size();
	return tile_count > 0 ? float(tile_count - std::min(left, tile_count)) / float(tile_count) : 1.0f;
}

void TileRebuild::cancel(const Scene &scene, FieldMotion &motion, size_t number, bool again) {
	const std::unique_ptr<TileBuild> job = std::move(jobs[number].job);
	jobs.erase(jobs.begin() + std::ptrdiff_t(number));
	querying = querying == job.get() ? nullptr : querying; // A new job may have the same address.
	job->release_texels(motion);
	scene.view.forget_tile(job->tile());
	if (again) {
		waiting.push_back(job->tile());
	}
}

void TileRebuild::interrupt(const Scene &scene, FieldMotion &motion) {
	while (!jobs.empty()) {
		cancel(scene, motion, jobs.size() - 1, true);
	}
	outline.reset();
}

void TileRebuild::interrupt(const Scene &scene, FieldMotion &motion, const AreaBox &box) {
	for (size_t i = jobs.size(); i-- > 0;) {
		const AreaBox both = common_box(box, tile_box(jobs[i].job->tile(), scene.store.tile_size()));
		if (both.low.x <= both.high.x && both.low.y <= both.high.y) {
			cancel(scene, motion, i, true);
		}
	}
}

void TileRebuild::stop(const Scene &scene, FieldMotion &motion) {
	interrupt(scene, motion);
	waiting.clear();
}

void TileRebuild::wait_for_jobs() {
	std::for_each(jobs.begin(), jobs.end(), [](const PendingTile &pending) { pending.job->wait(); });
}

void TileRebuild::note_removed(const TileKey &tile) {
	for (PendingTile &pending : jobs) {
		pending.lost_some = pending.lost_some || pending.job->tile() == tile;
	}
}

// Returns false if no job may begin.
bool TileRebuild::begin_one(const Scene &scene) {
	const auto is_at_work = [](const PendingTile &pending) { return pending.job->is_at_work(); };
	if (waiting.empty() || jobs.size() >= TileBuild::MAX_JOBS ||
			std::count_if(jobs.begin(), jobs.end(), is_at_work) >= TileBuild::MAX_WORKING) {
		return false;
	}
	TileBuildInput input;
	input.tile = waiting.back();
	waiting.pop_back();
	if (!FieldTiles::describe(scene, base, input)) {
		return true; // The fault was reported for the whole field. This tile stays unchanged.
	}
	if (!outline) {
		FieldRenderSetup some = outline_of(scene.setup);
		some.is_of_tiles = true;
		outline = std::make_shared<const FieldRenderSetup>(std::move(some));
	}
	input.spacing = placed_at;
	input.existing = copy_generated_in(scene.store, input.tile);
	input.setup = outline;
	jobs.push_back({ std::make_unique<TileBuild>(std::move(input)) });
	jobs.back().job->start();
	return true;
}

// One tile at a time.
void TileRebuild::poll_ground(const Scene &scene, bool physics) {
	const auto waits = [](const PendingTile &pending) { return pending.job->needs_ground(); };
	const auto first = std::find_if(jobs.begin(), jobs.end(), waits);
	const TileBuild *wanted = first == jobs.end() ? nullptr : first->job.get();
	if (querying != wanted) {
		ground_queue.forget();
		querying = wanted;
	}
	if (querying &&
			ground_queue.serve(*first->job, scene.field, scene.properties, std::max(MIN_GROUND_USEC, scene.budget_usec),
					physics, false) == GroundSampler::State::failed) {
		waiting.clear();
		querying = nullptr;
		jobs.erase(first); // It has no texels yet. The plants that it would replace stay.
		scene.fault(ground_queue.fault());
	}
}

void TileRebuild::exchange(const Scene &scene, const Way &way, PendingTile &pending) {
	const TileKey tile = pending.job->tile();
	StoreEdit edit;
	ArrivingChunks arriving;
	edit.left_tiles = { tile };
	edit.spacing = placed_at;
	pending.job->take_all(edit, arriving);
	arriving.leaves_texels = way.joins;
	const ChangeSet changes = scene.apply(std::move(edit), &arriving);
	scene.view.drop_tile(tile);
	scene.view.show_tile(scene.setup, tile);
	std::vector<PlantRef> gone;
	EditFinder finder(scene.edits);
	for (size_t i = 0; i < changes.grown.size() && pending.lost_some; i++) {
		const PlantChunk &chunk = scene.store.chunk(changes.grown[i].chunk);
		for (int slot = 0; slot < chunk.size(); slot++) {
			if (finder.is_gone(chunk.plants.x[size_t(slot)], chunk.plants.z[size_t(slot)])) {
				gone.push_back({ changes.grown[i].chunk, slot });
			}
		}
	}
	if (!gone.empty()) {
		StoreEdit removing;
		removing.removed = std::move(gone);
		scene.apply(std::move(removing), nullptr);
	}
}

bool TileRebuild::resume(
		const Scene &scene, const Way &way, PendingTile &pending, double until_usec, const Stopwatch &watch) {
	TileBuild &job = *pending.job;
	if (job.is_placed() && !pending.is_planned) {
		pending.is_planned = true;
		job.reserve(way.motion);
		job.draw();
	}
	while (job.is_drawn() && watch.usec() < until_usec) {
		if (const BatchPlan *plan = job.next_plan()) {
			scene.view.prepare(scene.setup, *plan);
			continue;
		}
		exchange(scene, way, pending);
		return true;
	}
	return false;
}

void TileRebuild::resume(const Scene &scene, const Way &way, bool physics) {
	const Stopwatch watch;
	poll_ground(scene, physics);
	if (physics) {
		return;
	}
	// First, because workers run parallel to this thread.
	while (watch.usec() < scene.budget_usec && begin_one(scene)) {
	}
	for (size_t i = 0; i < jobs.size();) {
		if (resume(scene, way, jobs[i], scene.budget_usec, watch)) {
			querying = querying == jobs[i].job.get() ? nullptr : querying;
			jobs.erase(jobs.begin() + std::ptrdiff_t(i));
		} else {
			i++;
		}
	}
}

} // namespace undergrowth
