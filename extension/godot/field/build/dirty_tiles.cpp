#include "field/build/dirty_tiles.hpp"

#include "base/convert.hpp"
#include "field/build/build_input.hpp"
#include "field/build/field_habitats.hpp"
#include "field/view/cameras.hpp"
#include "field/view/listed_styles.hpp"
#include "placement/edit_finder.hpp"
#include "placement/tile_choice.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

using namespace godot;

namespace undergrowth {

// Tasks of whole tiles, or of parts, on worker threads at the same time, and including those that wait for the main
// thread.
static constexpr int MAX_WORKING = 4;
static constexpr int MAX_JOBS = 16;
static constexpr int FRAMES_BETWEEN_CHOICES = 8;
// Time for ground queries of whole tiles per frame, by the number of tiles that need them.
static constexpr double GROUND_USEC_PER_TILE = 250.0, MIN_GROUND_USEC = 500.0, MAX_GROUND_USEC = 2000.0;
static constexpr double MAX_WAIT_USEC = 500.0; // Per frame, so that a frame shows what was painted just before it.
static constexpr size_t MAX_COPIED_PLANTS = 6000; // Per frame, for parts: this takes a fraction of a millisecond.
// Limits of builds tile by tile.
static constexpr double MAX_TILES = 4096.0;
static constexpr double MIN_PLANTS = 32.0; // In a full tile.
static constexpr double MAX_PLANTS = 2.0e6; // Graphics cards have texels for these plus the same number of old plants.

// Returns a box with everything that plants in `box` compete with.
static AreaBox area_of_competition(const DirtyTiles::Scene &scene, const AreaBox &box) {
	const float reach = read_competition(scene.properties).reach();
	return { box.low - reach, box.high + reach };
}

static double spacing_of(const PlacementRequest &request) {
	PlacementRequest nothing = request;
	nothing.within = AreaBox();
	return Placement(nothing).cell_size();
}

static bool is_empty(const AreaBox &box) {
	return box.low.x >= box.high.x || box.low.y >= box.high.y;
}

static double plants_per_tile(const PlacementRequest &request, float size) {
	return double(request.density) * double(size) * double(size);
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

std::vector<glm::vec2> DirtyTiles::places_of(const Scene &scene) {
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
static float distance_in(const DirtyTiles::Scene &scene) {
	const Vector3 scale = axes_of(scene.field).basis.get_scale().abs();
	return float(scene.properties.view_distance) / std::min(scale.x, scale.z);
}

std::vector<TileKey> DirtyTiles::choose_all(const Scene &scene, const PlacementRequest &request) const {
	const float tile_size = float(scene.properties.tile_size);
	const std::vector<glm::vec2> places = places_of(scene);
	if (places.empty() && tile_size == scene.store.tile_size()) {
		return std::vector<TileKey>(existing.begin(), existing.end());
	}
	return choose_tiles({}, places, distance_in(scene), tile_size, placed_box(request)).to_load;
}

std::vector<TileKey> DirtyTiles::list_first(const Scene &scene, const PlacementRequest &request) {
	const float tile_size = float(scene.properties.tile_size);
	const double each = plants_per_tile(request, tile_size);
	std::vector<TileKey> all;
	if (each < MIN_PLANTS || !add_tiles_of_area(request, tile_size, all) ||
			each * double(all.size()) > PlacementRequest::MAX_PLANTS) {
		return {};
	}
	TileQueue sorted;
	sorted.set_places(places_of(scene), tile_size);
	std::for_each(all.begin(), all.end(), [&](const TileKey &tile) { sorted.insert(tile); });
	std::generate(all.begin(), all.end(), [&] { return sorted.take(); });
	return all;
}

std::vector<TileKey> DirtyTiles::list_again(const Scene &scene, const PlacementRequest &request) const {
	const float tile_size = scene.store.tile_size();
	const double each = plants_per_tile(request, tile_size);
	std::vector<TileKey> all = scene.store.generated_tiles();
	if (all.empty() || each < MIN_PLANTS || !scene.store.has_unused_ids(spacing_of(request))) {
		return {};
	}
	if (scene.streams()) {
		const std::vector<TileKey> near = choose_all(scene, request);
		all.insert(all.end(), near.begin(), near.end());
	} else if (!add_tiles_of_area(request, tile_size, all)) {
		return {};
	}
	std::sort(all.begin(), all.end());
	all.erase(std::unique(all.begin(), all.end()), all.end());
	return double(all.size()) > MAX_TILES || each * double(all.size()) > MAX_PLANTS ? std::vector<TileKey>() : all;
}

void DirtyTiles::set_base(const PlacementRequest &request) {
	spacing = spacing_of(request);
	base = request;
	base.map.reset();
	area = placed_box(request);
}

void DirtyTiles::set_existing(const Scene &scene, const std::vector<TileKey> &tiles, const PlacementRequest &request) {
	interrupt(scene);
	end_build(scene);
	queue.clear();
	to_remove.clear();
	existing = std::set<TileKey>(tiles.begin(), tiles.end());
	size = scene.store.tile_size();
	set_base(request);
}

void DirtyTiles::begin_build(
		const Scene &scene, const std::vector<TileKey> &tiles, const PlacementRequest &request) {
	queue.clear();
	due = std::set<TileKey>(tiles.begin(), tiles.end());
	due_at_first = due.size();
	is_list = true;
	has_build_to_choose = false;
	size = scene.store.tile_size();
	set_base(request);
	queue.set_places(places_of(scene), size);
	for (const TileKey &tile : tiles) {
		queue.insert(tile);
		parts.erase(tile);
	}
	for (auto tile = existing.begin(); tile != existing.end();) { // An empty tile may have plants now.
		tile = due.count(*tile) > 0 ? std::next(tile) : existing.erase(tile);
	}
}

// Tiles of a list that are not built yet keep their old plants.
void DirtyTiles::end_build(const Scene &scene) {
	if (is_list) {
		interrupt(scene);
		queue.clear();
	}
	is_list = has_build_to_choose = false;
	due.clear();
	due_at_first = 0;
}

void DirtyTiles::stop_list(const Scene &scene) {
	if (is_list) {
		end_build(scene);
	}
}

float DirtyTiles::progress() const {
	return due_at_first > 0 ? 1.0f - float(due.size()) / float(due_at_first) : 0.0f;
}

int DirtyTiles::waiting_count() const {
	return int(queue.size()) + int(std::count_if(jobs.begin(), jobs.end(), [](const Job &job) {
		return !job.is_part();
	}));
}

void DirtyTiles::wait_for_tasks() {
	std::for_each(jobs.begin(), jobs.end(), [](const Job &job) { job.task->wait(); });
	if (drawing) {
		drawing->wait();
	}
}

DirtyTiles::Job *DirtyTiles::job_of(const TileKey &tile) {
	const auto found =
			std::find_if(jobs.begin(), jobs.end(), [&](const Job &job) { return job.task->tile() == tile; });
	return found == jobs.end() ? nullptr : &*found;
}

DirtyTiles::Job DirtyTiles::take_job(size_t number) {
	Job job = std::move(jobs[number]);
	jobs.erase(jobs.begin() + std::ptrdiff_t(number));
	// A new task may have the same address.
	querying = querying == job.task.get() ? nullptr : querying;
	querying_part = querying_part == job.task.get() ? nullptr : querying_part;
	return job;
}

void DirtyTiles::cancel(const Scene &scene, Job &which, bool again) {
	const Job job = take_job(size_t(&which - jobs.data()));
	job.task->release_texels(scene.motion);
	scene.view.forget_tile(job.task->tile());
	if (again) {
		queue.insert(job.task->tile());
	}
}

void DirtyTiles::interrupt(const Scene &scene) {
	for (size_t i = jobs.size(); i-- > 0;) {
		if (!jobs[i].is_part()) {
			cancel(scene, jobs[i], true);
		}
	}
	outline.reset();
	frames_since_choice = 0;
}

void DirtyTiles::note_removed(const TileKey &tile) {
	if (Job *job = job_of(tile)) {
		job->lost_some = true;
	}
}

// Forgets missing tiles that are too far from all cameras now.
void DirtyTiles::choose_due() {
	if (std::exchange(has_build_to_choose, false)) {
		const std::vector<TileKey> all = queue.tiles();
		due.insert(all.begin(), all.end());
		due_at_first = due.size();
	}
	for (auto tile = due.begin(); tile != due.end();) {
		tile = queue.contains(*tile) || job_of(*tile) ? std::next(tile) : due.erase(tile);
	}
}

void DirtyTiles::choose(const Scene &scene) {
	if (frames_since_choice++ % FRAMES_BETWEEN_CHOICES != 0) {
		return;
	}
	const std::vector<glm::vec2> places = places_of(scene);
	queue.set_places(places, size);
	if (!scene.streams()) {
		return;
	}
	const PlantMap *map = scene.properties.map.ptr();
	if (map && !map->density().painted().is_empty()) { // Empty areas may be painted now.
		area = map->density().box_of(map->density().painted());
	}
	TileChoice choice = choose_tiles(existing, places, distance_in(scene), size, area);
	const std::set<TileKey> missing(choice.to_load.begin(), choice.to_load.end());
	for (const TileKey &tile : queue.tiles()) {
		if (existing.count(tile) == 0 && missing.count(tile) == 0) {
			queue.erase(tile);
		}
	}
	for (const TileKey &tile : missing) {
		if (!job_of(tile)) {
			queue.insert(tile);
		}
	}
	to_remove = std::move(choice.to_unload);
	std::reverse(to_remove.begin(), to_remove.end());
	choose_due();
}

void DirtyTiles::leave(const Scene &scene, const TileKey &tile) {
	if (Job *job = job_of(tile)) {
		cancel(scene, *job, false);
	}
	queue.erase(tile);
	due.erase(tile);
	parts.erase(tile);
	existing.erase(tile);
	scene.view.drop_tile(tile);
	StoreEdit edit;
	edit.left_tiles = { tile };
	scene.apply(std::move(edit), nullptr);
}

bool DirtyTiles::may_begin(bool is_part) const {
	int count = 0, working_count = 0;
	for (const Job &job : jobs) {
		count += job.is_part() == is_part ? 1 : 0;
		working_count += job.is_part() == is_part && job.task->is_at_work() ? 1 : 0;
	}
	return count < MAX_JOBS && working_count < MAX_WORKING;
}

const std::shared_ptr<const FieldRenderSetup> &DirtyTiles::need_outline(const Scene &scene) {
	if (!outline) {
		FieldRenderSetup some = outline_of(scene.setup);
		some.is_of_tiles = true;
		outline = std::make_shared<const FieldRenderSetup>(std::move(some));
	}
	return outline;
}

bool DirtyTiles::describe(const Scene &scene, TileBuildInput &input) const {
	const AreaBox box = tile_box(input.tile, size);
	input.tile_size = size;
	input.request = base;
	input.request.within = box;
	if (scene.properties.map.is_valid()) { // The map may have changed.
		if (!is_listed_so(scene.setup, scene.properties)) {
			return false; // A build with the present species failed, and the request would contain their indices.
		}
		input.request = PlacementRequest();
		const AreaBox wide = area_of_competition(scene, box);
		if (!read_request(scene.field, scene.properties, scene.setup, &wide, input.request).is_empty()) {
			return false;
		}
		input.request.within = box;
	}
	input.ground = scene.ground;
	input.spacing = spacing;
	input.edits = scene.edits.cut(box);
	input.settings = scene.settings;
	input.existing = share_generated_in(scene.store, input.tile);
	return true;
}

bool DirtyTiles::begin(const Scene &scene) {
	if (queue.is_empty() || !may_begin(false)) {
		return false;
	}
	TileBuildInput input;
	input.tile = queue.take();
	if (!describe(scene, input)) {
		if (!is_list) {
			end_build(scene); // The rest cannot be built. The build of the whole field has reported the fault.
			return false;
		}
		due.erase(input.tile); // This tile stays unchanged.
		return true;
	}
	parts.erase(input.tile);
	input.setup = need_outline(scene);
	jobs.push_back({ std::make_unique<TileBuildTask>(std::move(input)) });
	jobs.back().task->start();
	return true;
}

DirtyTiles::Job *DirtyTiles::find_job_for_ground(bool is_part) {
	const auto found = std::find_if(jobs.begin(), jobs.end(),
			[is_part](const Job &job) { return job.is_part() == is_part && job.task->needs_ground(); });
	return found == jobs.end() ? nullptr : &*found;
}

// One tile at a time.
void DirtyTiles::poll_ground(const Scene &scene, bool physics) {
	Job *job = find_job_for_ground(false);
	const TileBuildTask *next = job ? job->task.get() : nullptr;
	if (std::exchange(querying, next) != next) {
		ground_queue.forget();
	}
	const double usec = std::max(
			scene.budget_usec, std::clamp(GROUND_USEC_PER_TILE * waiting_count(), MIN_GROUND_USEC, MAX_GROUND_USEC));
	if (job &&
			ground_queue.serve(*job->task, scene.field, scene.properties, usec, physics, false) ==
					GroundSampler::State::failed) {
		cancel(scene, *job, false);
		end_build(scene);
		scene.fault(ground_queue.fault());
	}
}

bool DirtyTiles::resume(const Scene &scene, Job &job, Pace &pace) {
	TileBuildTask &task = *job.task;
	const bool is_empty = task.chunks().empty();
	if (task.is_placed() && !is_empty && !std::exchange(job.is_planned, true)) {
		task.reserve(scene.motion);
		task.draw();
	}
	while (const BatchPlan *plan = task.is_drawn() ? task.next_plan() : nullptr) {
		if (!pace.allows(scene.view.expected_usec(*plan))) {
			return false;
		}
		scene.view.prepare(scene.setup, *plan);
		task.leave_plan();
	}
	return (task.is_drawn() || (task.is_placed() && is_empty)) &&
			pace.allows(exchanging.expected_usec(task.plant_count()));
}

void DirtyTiles::exchange(const Scene &scene, Job &&job) {
	const Stopwatch watch;
	const TileKey tile = job.task->tile();
	const int plant_count = job.task->plant_count();
	ArrivingChunks arriving;
	StoreEdit edit = job.task->take_edit(arriving);
	arriving.leaves_texels = !scene.streams(); // Multimeshes wider than a tile stay until all tiles are joined.
	const ChangeSet changes = scene.apply(std::move(edit), &arriving);
	scene.view.drop_tile(tile);
	scene.view.show_tile(scene.setup, tile);
	due.erase(tile);
	if (scene.streams()) {
		existing.insert(tile);
	}
	if (job.lost_some) {
		remove_gone(scene, changes);
	}
	exchanging.note(plant_count, watch.usec());
}

// Removes new plants that were removed while their tile was in progress.
void DirtyTiles::remove_gone(const Scene &scene, const ChangeSet &changes) {
	StoreEdit edit;
	EditFinder finder(scene.edits);
	for (const ChangeSet::Grown &grown : changes.grown) {
		const PlantChunk &chunk = scene.store.chunk(grown.chunk);
		for (int slot = 0; slot < chunk.size(); slot++) {
			if (finder.is_gone(chunk.plants.x[size_t(slot)], chunk.plants.z[size_t(slot)])) {
				edit.removed.push_back({ grown.chunk, slot });
			}
		}
	}
	scene.apply(std::move(edit), nullptr);
}

bool DirtyTiles::resume(const Scene &scene, bool physics) {
	Pace pace = { Stopwatch(), scene.budget_usec };
	poll_ground(scene, physics);
	if (physics) {
		return false;
	}
	choose(scene);
	while (!to_remove.empty() && pace.watch.usec() < scene.budget_usec) {
		leave(scene, TileKey(to_remove.back()));
		to_remove.pop_back();
	}
	while (pace.watch.usec() < scene.budget_usec && begin(scene)) { // First, because workers run parallel to this thread.
	}
	bool is_any = false;
	for (size_t i = 0; i < jobs.size();) {
		if (!jobs[i].is_part() && resume(scene, jobs[i], pace)) {
			exchange(scene, take_job(i)); // It may restart other jobs.
			is_any = true;
		} else {
			i++;
		}
	}
	return is_any;
}

bool DirtyTiles::is_building_parts() const {
	return !parts.empty() || drawing || !undrawn.empty() ||
			std::any_of(jobs.begin(), jobs.end(), [](const Job &job) { return job.is_part(); });
}

void DirtyTiles::add_part(const TileKey &tile, const AreaBox &box) {
	const auto [known, is_new] = parts.emplace(tile, box);
	if (!is_new) {
		known->second = { glm::min(known->second.low, box.low), glm::max(known->second.high, box.high) };
	}
}

// A whole tile that has not begun reads the map later.
void DirtyTiles::touch(const Scene &scene, const AreaBox &changed, float tile_size) {
	size = tile_size;
	const AreaBox box = area_of_competition(scene, changed);
	const TileKey first = tile_at(box.low.x, box.low.y, size);
	const TileKey last = tile_at(box.high.x, box.high.y, size);
	for (int column = first.column; column <= last.column; column++) {
		for (int row = first.row; row <= last.row && parts.size() <= MAX_PARTS; row++) {
			const TileKey tile = { column, row };
			const AreaBox part = common_box(box, tile_box(tile, size));
			if (is_empty(part) || queue.contains(tile)) {
				continue;
			}
			Job *job = job_of(tile);
			if (job && !job->is_part()) {
				cancel(scene, *job, true);
			} else {
				add_part(tile, part);
			}
		}
	}
}

void DirtyTiles::interrupt_parts() {
	for (size_t i = jobs.size(); i-- > 0;) {
		if (jobs[i].is_part()) {
			const Job job = take_job(i);
			add_part(job.task->tile(), *job.task->part());
		}
	}
	if (drawing) {
		for (const ChunkToDraw &one : drawing->chunks()) {
			if (dropped.count(one.number) == 0) {
				undrawn.insert(one.number);
			}
		}
		drawing.reset();
	}
}

void DirtyTiles::begin_parts(const Scene &scene) {
	size_t copied_count = 0;
	for (auto entry = parts.begin(); entry != parts.end() && copied_count < MAX_COPIED_PLANTS && may_begin(true);) {
		const auto [tile, box] = *entry;
		if (job_of(tile)) {
			++entry;
		} else {
			begin_part(scene, tile, box, copied_count);
			entry = parts.erase(entry);
		}
	}
}

void DirtyTiles::begin_part(
		const Scene &scene, const TileKey &tile, const AreaBox &box, size_t &copied_count) {
	TileBuildInput input;
	const bool are_known = scene.setup.listed_count == int(scene.properties.species.size());
	const AreaBox wide = area_of_competition(scene, box);
	const String fault = read_request(scene.field, scene.properties, scene.setup, &wide, input.request);
	input.request.within = box;
	input.tile = tile;
	input.part = box;
	input.ground = scene.ground;
	input.edits = scene.edits.cut(box);
	input.spacing = scene.store.spacing();
	if (!fault.is_empty() || !are_known || 1.0 / std::sqrt(double(input.request.density)) != input.spacing) {
		return; // A build starts soon.
	}
	input.existing_in_part = scene.store.generated_in(box);
	copied_count += input.existing_in_part.refs.size();
	jobs.push_back({ std::make_unique<TileBuildTask>(std::move(input)) });
	jobs.back().task->start();
}

void DirtyTiles::poll_part_ground(const Scene &scene, bool physics, double usec) {
	Job *job = find_job_for_ground(true);
	const TileBuildTask *next = job ? job->task.get() : nullptr;
	if (std::exchange(querying_part, next) != next) {
		part_ground_queue.forget();
	}
	if (job &&
			part_ground_queue.serve(*job->task, scene.field, scene.properties, usec, physics, false) ==
					GroundSampler::State::failed) {
		take_job(size_t(job - jobs.data()));
		scene.fault(part_ground_queue.fault());
	}
}

template <class Value> static void append(std::vector<Value> &&from, std::vector<Value> &into) {
	into.insert(into.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

bool DirtyTiles::apply_parts(const Scene &scene) {
	StoreEdit edit;
	bool is_any = false;
	for (size_t i = 0; i < jobs.size();) {
		if (!jobs[i].is_part() || !jobs[i].task->is_placed()) {
			i++;
			continue;
		}
		is_any = true;
		ArrivingChunks none;
		StoreEdit own = take_job(i).task->take_edit(none);
		append(std::move(own.grown), edit.grown);
		append(std::move(own.grown_from), edit.grown_from);
		append(std::move(own.removed), edit.removed);
	}
	if (double(scene.store.plant_count()) + double(edit.grown.size()) > PlacementRequest::MAX_PLANTS) {
		scene.fault(undergrowth::describe(PlacementFault::too_many_plants));
		return false;
	}
	scene.apply(std::move(edit), nullptr);
	return is_any;
}

// Draws all plants of the changed chunks.
void DirtyTiles::draw_parts(const Scene &scene) {
	if (undrawn.empty()) {
		return;
	}
	std::vector<ChunkToDraw> chunks;
	for (const int number : undrawn) {
		chunks.push_back({ number, scene.store.chunk(number), scene.motion.texels(number) });
	}
	undrawn.clear();
	dropped.clear();
	drawing = std::make_unique<TileBuildTask>(need_outline(scene), std::move(chunks));
	drawing->draw();
}

void DirtyTiles::show_parts(const Scene &scene) {
	std::vector<BatchPlan> plans = drawing->take_plans();
	const auto is_dropped = [this](const BatchPlan &plan) { return dropped.count(plan.place.new_chunk) > 0; };
	plans.erase(std::remove_if(plans.begin(), plans.end(), is_dropped), plans.end());
	for (const ChunkToDraw &one : drawing->chunks()) {
		if (dropped.count(one.number) == 0) {
			scene.view.replace_new_chunk(one.chunk.tile, one.number);
		}
	}
	scene.view.show(scene.setup, plans);
	drawing.reset();
}

bool DirtyTiles::resume_parts(const Scene &scene, Moment moment, double ground_usec) {
	for (auto entry = parts.begin(); scene.streams() && entry != parts.end();) {
		entry = existing.count(entry->first) > 0 ? std::next(entry) : parts.erase(entry);
	}
	if (drawing && moment == Moment::ending) {
		drawing->wait_a_little(MAX_WAIT_USEC);
	}
	if (moment != Moment::ending) {
		poll_part_ground(scene, moment == Moment::physics, ground_usec);
	}
	const bool is_applied = moment == Moment::begun && apply_parts(scene);
	if (moment == Moment::physics) {
		return false;
	}
	if (drawing && drawing->is_drawn()) {
		show_parts(scene);
	}
	if (!drawing) {
		draw_parts(scene);
	}
	begin_parts(scene);
	return is_applied;
}

void DirtyTiles::follow(const ChangeSet &changes, const PlantStore &store) {
	std::set<int> changed(changes.dropped.begin(), changes.dropped.end());
	for (const int chunk : changes.dropped) {
		undrawn.erase(chunk);
		dropped.insert(chunk);
	}
	for (const PlantRef &ref : changes.gone) {
		changed.insert(ref.chunk);
	}
	for (const ChangeSet::Grown &grown : changes.grown) {
		if (store.chunk(grown.chunk).is_new) {
			undrawn.insert(grown.chunk);
		}
	}
	for (size_t i = jobs.size(); i-- > 0;) {
		const auto is_compared = [&](int chunk) { return jobs[i].task->compares_with(chunk); };
		if (jobs[i].is_part() && std::any_of(changed.begin(), changed.end(), is_compared)) {
			const Job job = take_job(i);
			add_part(job.task->tile(), *job.task->part());
		}
	}
}

} // namespace undergrowth
