#include "field/build/field_tiles.hpp"

#include "base/convert.hpp"
#include "field/build/build_input.hpp"
#include "field/view/cameras.hpp"
#include "field/view/listed_styles.hpp"
#include "field/build/region_build.hpp"
#include "placement/tile_choice.hpp"

#include <algorithm>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr int FRAMES_BETWEEN_CHOICES = 8;
// Time for ground queries per frame, by the number of tiles that need them.
static constexpr double GROUND_USEC_PER_TILE = 250.0, MIN_GROUND_USEC = 500.0, MAX_GROUND_USEC = 2000.0;

std::vector<glm::vec2> FieldTiles::places_of(const Scene &scene) {
	std::vector<Vector3> cameras = find_camera_positions(scene.field);
	for (int64_t i = 0; i < scene.properties.streaming_targets.size(); i++) {
		const Node3D *target =
				Object::cast_to<Node3D>(scene.field->get_node_or_null(scene.properties.streaming_targets[i]));
		if (target) {
			cameras.push_back(target->get_global_position());
		}
	}
	const Transform3D to_field = axes_of(scene.field).affine_inverse();
	std::vector<glm::vec2> places;
	for (const Vector3 &camera : cameras) {
		const Vector3 place = to_field.xform(camera);
		if (place.is_finite()) {
			places.push_back({ place.x, place.z });
		}
	}
	return places;
}

// The view distance in the field's axes. Under an uneven scale it is an upper bound.
static float distance_in(const FieldTiles::Scene &scene) {
	const Vector3 scale = axes_of(scene.field).basis.get_scale().abs();
	return float(scene.properties.view_distance) / std::min(scale.x, scale.z);
}

std::vector<TileKey> FieldTiles::choose_all(const Scene &scene, const PlacementRequest &request) const {
	const float size = float(scene.properties.tile_size);
	const std::vector<glm::vec2> places = places_of(scene);
	if (places.empty() && size == scene.store.tile_size()) {
		return std::vector<TileKey>(existing.begin(), existing.end());
	}
	return choose_tiles({}, places, distance_in(scene), size, placed_box(request)).to_load;
}

void FieldTiles::set_existing(const std::vector<TileKey> &tiles, const PlacementRequest &request) {
	clear();
	existing.insert(tiles.begin(), tiles.end());
	base = request;
	base.map.reset();
	area = placed_box(request);
}

void FieldTiles::clear() {
	existing.clear();
	to_build.clear();
	to_remove.clear();
	jobs.clear();
	querying = nullptr;
	outline.reset();
	frames_since_choice = 0;
	end_build();
}

void FieldTiles::begin_build() {
	has_build_to_choose = true;
}

void FieldTiles::end_build() {
	has_build_to_choose = false;
	due.clear();
	due_at_first = 0;
}

float FieldTiles::build_progress() const {
	return due_at_first > 0 ? 1.0f - float(due.size()) / float(due_at_first) : 0.0f;
}

void FieldTiles::wait_for_jobs() {
	std::for_each(jobs.begin(), jobs.end(), [](const std::unique_ptr<TileBuild> &job) { job->wait(); });
}

// Removes tiles from `due` that are too far from all cameras now.
void FieldTiles::choose_due() {
	if (std::exchange(has_build_to_choose, false)) {
		due.insert(to_build.begin(), to_build.end());
		due_at_first = due.size();
		return;
	}
	if (due.empty()) {
		return;
	}
	std::set<TileKey> left;
	const auto keep = [&](const TileKey &tile) {
		if (due.count(tile) > 0) {
			left.insert(tile);
		}
	};
	std::for_each(to_build.begin(), to_build.end(), keep);
	std::for_each(jobs.begin(), jobs.end(), [&](const std::unique_ptr<TileBuild> &job) { keep(job->tile()); });
	due = std::move(left);
}

void FieldTiles::choose(const Scene &scene) {
	if (frames_since_choice++ % FRAMES_BETWEEN_CHOICES != 0) {
		return;
	}
	const PlantMap *map = scene.properties.map.ptr();
	if (map && !map->density().painted().is_empty()) { // Empty areas may be painted now.
		area = map->density().box_of(map->density().painted());
	}
	TileChoice choice = choose_tiles(existing, places_of(scene), distance_in(scene), scene.store.tile_size(), area);
	to_build = std::move(choice.to_load);
	to_remove = std::move(choice.to_unload);
	choose_due();
	std::reverse(to_build.begin(), to_build.end());
	std::reverse(to_remove.begin(), to_remove.end());
}

void FieldTiles::leave(const Scene &scene, const TileKey &tile) {
	const auto is_of_tile = [&](const std::unique_ptr<TileBuild> &job) { return job->tile() == tile; };
	if (querying && querying->tile() == tile) {
		querying = nullptr; // A new job may have the same address.
	}
	jobs.erase(std::remove_if(jobs.begin(), jobs.end(), is_of_tile), jobs.end());
	existing.erase(tile);
	scene.view.drop_tile(tile);
	StoreEdit edit;
	edit.left_tiles = { tile };
	scene.apply(std::move(edit), nullptr);
}

void FieldTiles::interrupt(const Scene &scene) {
	while (!jobs.empty()) {
		leave(scene, TileKey(jobs.back()->tile()));
	}
	outline.reset();
	to_build.clear();
	frames_since_choice = 0;
}

void FieldTiles::interrupt(const Scene &scene, const AreaBox &box) {
	std::vector<TileKey> touched;
	for (const std::unique_ptr<TileBuild> &job : jobs) {
		const AreaBox both = common_box(box, tile_box(job->tile(), scene.store.tile_size()));
		if (both.low.x <= both.high.x && both.low.y <= both.high.y) {
			touched.push_back(job->tile());
		}
	}
	for (const TileKey &tile : touched) {
		leave(scene, tile);
		frames_since_choice = 0;
	}
}

bool FieldTiles::describe(const Scene &scene, const PlacementRequest &base, TileBuildInput &input) {
	input.tile_size = scene.store.tile_size();
	const AreaBox box = tile_box(input.tile, input.tile_size);
	input.request = base;
	input.request.within = box;
	if (scene.properties.map.is_valid()) { // The map may have changed.
		if (!is_listed_so(scene.setup, scene.properties)) {
			return false; // A build with the present species failed, and the request would contain their indices.
		}
		input.request = PlacementRequest();
		const String fault = read_request(scene.field, scene.properties, scene.setup, &box, input.request);
		if (!fault.is_empty()) {
			return false;
		}
	}
	input.ground = scene.ground;
	input.edits = scene.edits.cut(box);
	input.settings = scene.settings;
	return true;
}

// Returns false if no job may begin.
bool FieldTiles::begin(const Scene &scene) {
	const auto is_at_work = [](const std::unique_ptr<TileBuild> &job) { return job->is_at_work(); };
	if (to_build.empty() || jobs.size() >= TileBuild::MAX_JOBS ||
			std::count_if(jobs.begin(), jobs.end(), is_at_work) >= TileBuild::MAX_WORKING) {
		return false;
	}
	TileBuildInput input;
	input.tile = to_build.back();
	to_build.pop_back();
	if (!describe(scene, base, input)) {
		end_build(); // The rest cannot be built. The build has reported the fault.
		return false;
	}
	outline = outline ? outline : std::make_shared<const FieldRenderSetup>(outline_of(scene.setup));
	input.spacing = scene.store.spacing();
	input.setup = outline;
	existing.insert(input.tile);
	jobs.push_back(std::make_unique<TileBuild>(std::move(input)));
	jobs.back()->start();
	return true;
}

// One tile at a time.
void FieldTiles::poll_ground(const Scene &scene, bool physics) {
	const auto waits = [](const std::unique_ptr<TileBuild> &job) { return job->needs_ground(); };
	const auto first = std::find_if(jobs.begin(), jobs.end(), waits);
	if (first == jobs.end() || querying != first->get()) {
		ground_queue.forget();
		querying = first == jobs.end() ? nullptr : first->get();
	}
	const double usec = std::max(
			scene.budget_usec, std::clamp(GROUND_USEC_PER_TILE * waiting_count(), MIN_GROUND_USEC, MAX_GROUND_USEC));
	if (querying &&
			ground_queue.serve(**first, scene.field, scene.properties, usec, physics, false) ==
					GroundSampler::State::failed) {
		leave(scene, TileKey((*first)->tile()));
		end_build();
		scene.fault(ground_queue.fault());
	}
}

bool FieldTiles::resume(const Scene &scene, TileBuild &job, bool edits, double until_usec, const Stopwatch &watch) {
	while (job.is_placed() && job.has_more_chunks() && edits && watch.usec() < until_usec) {
		StoreEdit edit;
		ArrivingChunks arriving;
		edit.arriving.push_back(job.take_chunk(arriving.prepared.emplace_back()));
		const ChangeSet changes = scene.apply(std::move(edit), &arriving);
		job.set_texels(scene.motion.texels(changes.grown.front().chunk));
	}
	if (job.is_placed() && !job.has_more_chunks()) {
		if (!job.has_begun()) {
			return true; // The tile has no plants.
		}
		job.draw();
	}
	while (job.is_drawn() && watch.usec() < until_usec) {
		const BatchPlan *plan = job.next_plan();
		if (!plan) {
			return true;
		}
		scene.view.show(scene.setup, { *plan });
	}
	return false;
}

bool FieldTiles::resume(const Scene &scene, bool physics, bool edits) {
	const Stopwatch watch;
	poll_ground(scene, physics);
	if (physics) {
		return false;
	}
	choose(scene);
	while (edits && !to_remove.empty() && watch.usec() < scene.budget_usec) {
		leave(scene, TileKey(to_remove.back()));
		to_remove.pop_back();
	}
	while (watch.usec() < scene.budget_usec && begin(scene)) { // First, because workers run parallel to this thread.
	}
	const auto count = scene.store.plant_count();
	for (size_t i = 0; i < jobs.size();) {
		if (resume(scene, *jobs[i], edits, scene.budget_usec, watch)) {
			querying = querying == jobs[i].get() ? nullptr : querying;
			due.erase(jobs[i]->tile());
			jobs.erase(jobs.begin() + std::ptrdiff_t(i));
		} else {
			i++;
		}
	}
	return scene.store.plant_count() != count;
}

} // namespace undergrowth
