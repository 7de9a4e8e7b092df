#include "field/field_tiles.hpp"

#include "convert.hpp"
#include "field/eyes.hpp"
#include "field/field_patch.hpp"
#include "field/field_recipe.hpp"
#include "field/listed_looks.hpp"
#include "stand/tile_choice.hpp"

#include <algorithm>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr int FRAMES_BETWEEN_CHOICES = 8;
// Time for ground queries per frame, by the number of tiles that need them.
static constexpr double GROUND_USEC_PER_TILE = 250.0, MIN_GROUND_USEC = 500.0, MAX_GROUND_USEC = 2000.0;

std::vector<glm::vec2> FieldTiles::places_of(const Scene &scene) {
	std::vector<Vector3> eyes = find_eyes(scene.field);
	for (int64_t i = 0; i < scene.properties.streaming_targets.size(); i++) {
		const Node3D *target =
				Object::cast_to<Node3D>(scene.field->get_node_or_null(scene.properties.streaming_targets[i]));
		if (target) {
			eyes.push_back(target->get_global_position());
		}
	}
	const Transform3D to_field = axes_of(scene.field).affine_inverse();
	std::vector<glm::vec2> places;
	for (const Vector3 &eye : eyes) {
		const Vector3 place = to_field.xform(eye);
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
		return std::vector<TileKey>(standing.begin(), standing.end());
	}
	return choose_tiles({}, places, distance_in(scene), size, placed_box(request)).coming;
}

void FieldTiles::stand(const std::vector<TileKey> &tiles, const PlacementRequest &request) {
	clear();
	standing.insert(tiles.begin(), tiles.end());
	base = request;
	base.map.reset();
	area = placed_box(request);
}

void FieldTiles::clear() {
	standing.clear();
	coming.clear();
	going.clear();
	jobs.clear();
	asking = nullptr;
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
	std::for_each(jobs.begin(), jobs.end(), [](const std::unique_ptr<TileJob> &job) { job->wait(); });
}

// Removes tiles from `due` that are too far from all cameras now.
void FieldTiles::choose_due() {
	if (std::exchange(has_build_to_choose, false)) {
		due.insert(coming.begin(), coming.end());
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
	std::for_each(coming.begin(), coming.end(), keep);
	std::for_each(jobs.begin(), jobs.end(), [&](const std::unique_ptr<TileJob> &job) { keep(job->tile()); });
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
	TileChoice choice = choose_tiles(standing, places_of(scene), distance_in(scene), scene.store.tile_size(), area);
	coming = std::move(choice.coming);
	going = std::move(choice.going);
	choose_due();
	std::reverse(coming.begin(), coming.end());
	std::reverse(going.begin(), going.end());
}

void FieldTiles::leave(const Scene &scene, const TileKey &tile) {
	const auto is_of_tile = [&](const std::unique_ptr<TileJob> &job) { return job->tile() == tile; };
	if (asking && asking->tile() == tile) {
		asking = nullptr; // A new job may have the same address.
	}
	jobs.erase(std::remove_if(jobs.begin(), jobs.end(), is_of_tile), jobs.end());
	standing.erase(tile);
	scene.view.drop_tile(tile);
	StandEdit edit;
	edit.left_tiles = { tile };
	scene.apply(std::move(edit), nullptr);
}

void FieldTiles::interrupt(const Scene &scene) {
	while (!jobs.empty()) {
		leave(scene, TileKey(jobs.back()->tile()));
	}
	outline.reset();
	coming.clear();
	frames_since_choice = 0;
}

void FieldTiles::interrupt(const Scene &scene, const AreaBox &box) {
	std::vector<TileKey> touched;
	for (const std::unique_ptr<TileJob> &job : jobs) {
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

bool FieldTiles::describe(const Scene &scene, const PlacementRequest &base, TileRecipe &recipe) {
	recipe.tile_size = scene.store.tile_size();
	const AreaBox box = tile_box(recipe.tile, recipe.tile_size);
	recipe.request = base;
	recipe.request.within = box;
	if (scene.properties.map.is_valid()) { // The map may have changed.
		if (!is_listed_so(scene.style, scene.properties)) {
			return false; // A build with the present species failed, and the request would contain their indices.
		}
		recipe.request = PlacementRequest();
		const String fault = read_request(scene.field, scene.properties, scene.style, &box, recipe.request);
		if (!fault.is_empty()) {
			return false;
		}
	}
	recipe.ground = scene.ground;
	recipe.changes = scene.changes.cut(box);
	recipe.prepare = scene.motion.prepare_block();
	recipe.settings = scene.settings;
	return true;
}

// Returns false if no job may begin.
bool FieldTiles::begin(const Scene &scene) {
	const auto is_at_work = [](const std::unique_ptr<TileJob> &job) { return job->is_at_work(); };
	if (coming.empty() || jobs.size() >= TileJob::MAX_JOBS ||
			std::count_if(jobs.begin(), jobs.end(), is_at_work) >= TileJob::MAX_WORKING) {
		return false;
	}
	TileRecipe recipe;
	recipe.tile = coming.back();
	coming.pop_back();
	if (!describe(scene, base, recipe)) {
		end_build(); // The rest cannot be built. The build has reported the fault.
		return false;
	}
	outline = outline ? outline : std::make_shared<const FieldStyle>(outline_of(scene.style));
	recipe.spacing = scene.store.spacing();
	recipe.style = outline;
	standing.insert(recipe.tile);
	jobs.push_back(std::make_unique<TileJob>(std::move(recipe)));
	jobs.back()->start();
	return true;
}

// One tile at a time.
void FieldTiles::ask_ground(const Scene &scene, bool physics) {
	const auto waits = [](const std::unique_ptr<TileJob> &job) { return job->wants_ground(); };
	const auto first = std::find_if(jobs.begin(), jobs.end(), waits);
	if (first == jobs.end() || asking != first->get()) {
		asker.forget();
		asking = first == jobs.end() ? nullptr : first->get();
	}
	const double usec = std::max(
			scene.budget_usec, std::clamp(GROUND_USEC_PER_TILE * waiting_count(), MIN_GROUND_USEC, MAX_GROUND_USEC));
	if (asking &&
			asker.serve(**first, scene.field, scene.properties, usec, physics, false) == GroundSurvey::State::failed) {
		leave(scene, TileKey((*first)->tile()));
		end_build();
		scene.fault(asker.fault());
	}
}

bool FieldTiles::go_on(const Scene &scene, TileJob &job, bool edits, double until_usec, const Stopwatch &watch) {
	while (job.is_placed() && job.has_more_blocks() && edits && watch.usec() < until_usec) {
		StandEdit edit;
		ArrivingBlocks arriving;
		edit.stood.push_back(job.take_block(arriving.prepared.emplace_back()));
		const ChangeSet changes = scene.apply(std::move(edit), &arriving);
		job.set_texels(scene.motion.texels(changes.grown.front().block));
	}
	if (job.is_placed() && !job.has_more_blocks()) {
		if (!job.has_begun()) {
			return true; // The tile has no plants.
		}
		job.draw();
	}
	while (job.is_drawn() && watch.usec() < until_usec) {
		const ClumpPlan *plan = job.next_plan();
		if (!plan) {
			return true;
		}
		scene.view.show(scene.style, { *plan });
	}
	return false;
}

void FieldTiles::go_on(const Scene &scene, bool physics, bool edits) {
	const Stopwatch watch;
	ask_ground(scene, physics);
	if (physics) {
		return;
	}
	choose(scene);
	while (edits && !going.empty() && watch.usec() < scene.budget_usec) {
		leave(scene, TileKey(going.back()));
		going.pop_back();
	}
	while (watch.usec() < scene.budget_usec && begin(scene)) { // First, because workers run parallel to this thread.
	}
	for (size_t i = 0; i < jobs.size();) {
		if (go_on(scene, *jobs[i], edits, scene.budget_usec, watch)) {
			asking = asking == jobs[i].get() ? nullptr : asking;
			due.erase(jobs[i]->tile());
			jobs.erase(jobs.begin() + std::ptrdiff_t(i));
		} else {
			i++;
		}
	}
}

} // namespace undergrowth
