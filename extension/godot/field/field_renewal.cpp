#include "field/field_renewal.hpp"

#include "field/field_patch.hpp"
#include "field/field_recipe.hpp"
#include "stand/changes_finder.hpp"
#include "stand/tile_choice.hpp"

#include <algorithm>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr double MIN_GROUND_USEC = 1000.0; // Per frame.
static constexpr double MOST_TILES = 4096.0;
static constexpr double LEAST_PLANTS = 32.0; // In a full tile.
static constexpr double MOST_PLANTS = 2.0e6; // Graphics cards have texels for these plus the same number of old plants.

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
	if (double(last.column - first.column + 1) * double(last.row - first.row + 1) > MOST_TILES) {
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

std::vector<TileKey> FieldRenewal::list_first(const Scene &scene, const PlacementRequest &request) {
	const float size = float(scene.properties.tile_size);
	const double each = double(request.density) * double(size) * double(size);
	std::vector<TileKey> all;
	if (each < LEAST_PLANTS || !add_tiles_of_area(request, size, all) ||
			each * double(all.size()) > PlacementRequest::MOST_PLANTS) {
		return {};
	}
	sort_farthest_first(scene, size, all);
	return all;
}

std::vector<TileKey> FieldRenewal::list(const Scene &scene, const PlacementRequest &request, const FieldTiles &tiles) {
	const float size = scene.store.tile_size();
	const double each = double(request.density) * double(size) * double(size);
	std::vector<TileKey> all = scene.store.filled_tiles();
	if (all.empty() || each < LEAST_PLANTS || !scene.store.has_names_left(spacing_of(request))) {
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
	if (double(all.size()) > MOST_TILES || each * double(all.size()) > MOST_PLANTS) {
		return {};
	}
	sort_farthest_first(scene, size, all);
	return all;
}

void FieldRenewal::begin(std::vector<TileKey> &&tiles, const PlacementRequest &request) {
	waiting = std::move(tiles);
	tile_count = waiting.size();
	placed_at = spacing_of(request);
	base = request;
	base.map.reset();
}

float FieldRenewal::progress() const {
	const size_t left = waiting.size() + jobs.size();
	return tile_count > 0 ? float(tile_count - std::min(left, tile_count)) / float(tile_count) : 1.0f;
}

void FieldRenewal::give_up(const Scene &scene, FieldMotion &motion, size_t number, bool again) {
	const std::unique_ptr<TileJob> job = std::move(jobs[number].job);
	jobs.erase(jobs.begin() + std::ptrdiff_t(number));
	asking = asking == job.get() ? nullptr : asking; // A new job may have the same address.
	job->give_up(motion);
	scene.view.forget_tile(job->tile());
	if (again) {
		waiting.push_back(job->tile());
	}
}

void FieldRenewal::interrupt(const Scene &scene, FieldMotion &motion) {
	while (!jobs.empty()) {
		give_up(scene, motion, jobs.size() - 1, true);
	}
	outline.reset();
}

void FieldRenewal::interrupt(const Scene &scene, FieldMotion &motion, const AreaBox &box) {
	for (size_t i = jobs.size(); i-- > 0;) {
		const AreaBox both = common_box(box, tile_box(jobs[i].job->tile(), scene.store.tile_size()));
		if (both.low.x <= both.high.x && both.low.y <= both.high.y) {
			give_up(scene, motion, i, true);
		}
	}
}

void FieldRenewal::stop(const Scene &scene, FieldMotion &motion) {
	interrupt(scene, motion);
	waiting.clear();
}

void FieldRenewal::wait_for_jobs() {
	std::for_each(jobs.begin(), jobs.end(), [](const Coming &coming) { coming.job->wait(); });
}

void FieldRenewal::note_removed(const TileKey &tile) {
	for (Coming &coming : jobs) {
		coming.lost_some = coming.lost_some || coming.job->tile() == tile;
	}
}

// Returns false if no job may begin.
bool FieldRenewal::begin_one(const Scene &scene) {
	const auto is_at_work = [](const Coming &coming) { return coming.job->is_at_work(); };
	if (waiting.empty() || jobs.size() >= TileJob::MAX_JOBS ||
			std::count_if(jobs.begin(), jobs.end(), is_at_work) >= TileJob::MAX_WORKING) {
		return false;
	}
	TileRecipe recipe;
	recipe.tile = waiting.back();
	waiting.pop_back();
	if (!FieldTiles::describe(scene, base, recipe)) {
		return true; // The fault was reported for the whole field. This tile stays unchanged.
	}
	if (!outline) {
		FieldStyle some = outline_of(scene.style);
		some.is_of_tiles = true;
		outline = std::make_shared<const FieldStyle>(std::move(some));
	}
	recipe.spacing = placed_at;
	recipe.standing = copy_filled_in(scene.store, recipe.tile);
	recipe.style = outline;
	jobs.push_back({ std::make_unique<TileJob>(std::move(recipe)) });
	jobs.back().job->start();
	return true;
}

// One tile at a time.
void FieldRenewal::ask_ground(const Scene &scene, bool physics) {
	const auto waits = [](const Coming &coming) { return coming.job->wants_ground(); };
	const auto first = std::find_if(jobs.begin(), jobs.end(), waits);
	const TileJob *wanted = first == jobs.end() ? nullptr : first->job.get();
	if (asking != wanted) {
		asker.forget();
		asking = wanted;
	}
	if (asking &&
			asker.serve(*first->job, scene.field, scene.properties, std::max(MIN_GROUND_USEC, scene.budget_usec),
					physics, false) == GroundSurvey::State::failed) {
		waiting.clear();
		asking = nullptr;
		jobs.erase(first); // It has no texels yet. The plants that it would replace stay.
		scene.fault(asker.fault());
	}
}

void FieldRenewal::exchange(const Scene &scene, const Way &way, Coming &coming) {
	const TileKey tile = coming.job->tile();
	StandEdit edit;
	ArrivingBlocks arriving;
	edit.left_tiles = { tile };
	edit.spacing = placed_at;
	coming.job->take_all(edit, arriving);
	arriving.leaves_texels = way.joins;
	const ChangeSet changes = scene.apply(std::move(edit), &arriving);
	scene.view.drop_tile(tile);
	scene.view.show_tile(scene.style, tile);
	std::vector<PlantPlace> gone;
	ChangesFinder finder(scene.changes);
	for (size_t i = 0; i < changes.grown.size() && coming.lost_some; i++) {
		const PlantBlock &block = scene.store.block(changes.grown[i].block);
		for (int slot = 0; slot < block.size(); slot++) {
			if (finder.is_gone(block.plants.x[size_t(slot)], block.plants.z[size_t(slot)])) {
				gone.push_back({ changes.grown[i].block, slot });
			}
		}
	}
	if (!gone.empty()) {
		StandEdit removing;
		removing.removed = std::move(gone);
		scene.apply(std::move(removing), nullptr);
	}
}

bool FieldRenewal::go_on(
		const Scene &scene, const Way &way, Coming &coming, double until_usec, const Stopwatch &watch) {
	TileJob &job = *coming.job;
	if (job.is_placed() && !coming.is_planned) {
		coming.is_planned = true;
		job.reserve(way.motion);
		job.draw();
	}
	while (job.is_drawn() && watch.usec() < until_usec) {
		if (const ClumpPlan *plan = job.next_plan()) {
			scene.view.prepare(scene.style, *plan);
			continue;
		}
		exchange(scene, way, coming);
		return true;
	}
	return false;
}

void FieldRenewal::go_on(const Scene &scene, const Way &way, bool physics) {
	const Stopwatch watch;
	ask_ground(scene, physics);
	if (physics) {
		return;
	}
	// First, because workers run parallel to this thread.
	while (watch.usec() < scene.budget_usec && begin_one(scene)) {
	}
	for (size_t i = 0; i < jobs.size();) {
		if (go_on(scene, way, jobs[i], scene.budget_usec, watch)) {
			asking = asking == jobs[i].job.get() ? nullptr : asking;
			jobs.erase(jobs.begin() + std::ptrdiff_t(i));
		} else {
			i++;
		}
	}
}

} // namespace undergrowth
