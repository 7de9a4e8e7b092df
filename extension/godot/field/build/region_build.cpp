#include "field/build/region_build.hpp"

#include <godot_cpp/classes/worker_thread_pool.hpp>

#include <chrono>
#include <utility>

using namespace godot;

namespace undergrowth {

FieldRenderSetup outline_of(const FieldRenderSetup &setup) {
	FieldRenderSetup outline;
	outline.levels = setup.levels;
	outline.rule = setup.rule;
	outline.tile_size = setup.tile_size;
	outline.is_of_tiles = setup.is_of_tiles;
	outline.needs_colors = setup.needs_colors;
	for (const SpeciesStyle &style : setup.styles) {
		SpeciesStyle some;
		some.variant_count = style.variant_count;
		some.detail = style.detail;
		some.is_by_error = style.is_by_error;
		some.levels = style.levels;
		some.variants = style.variants;
		some.meshes = style.meshes;
		some.motion = style.motion;
		some.width = style.width;
		some.nearest.assign(style.nearest.begin(), style.nearest.begin() + (style.nearest.empty() ? 0 : 1));
		outline.styles.push_back(std::move(some));
	}
	return outline;
}

RegionBuild::RegionBuild(RegionBuildInput &&with) : input(std::move(with)) {}

RegionBuild::~RegionBuild() {
	wait();
}

void RegionBuild::wait() {
	if (task >= 0) {
		WorkerThreadPool::get_singleton()->wait_for_task_completion(task);
		task = -1;
	}
}

void RegionBuild::launch(Stage next) {
	wait();
	stage = next;
	task = WorkerThreadPool::get_singleton()->add_native_task(&RegionBuild::work, this);
}

void RegionBuild::place() {
	launch(Stage::placing);
}

void RegionBuild::resume(std::vector<float> &&given_heights, std::vector<glm::vec3> &&given_normals) {
	heights = std::move(given_heights);
	normals = std::move(given_normals);
	launch(Stage::finishing);
}

void RegionBuild::draw(FieldRenderSetup &&with, std::vector<NewChunk> &&of) {
	setup = std::move(with);
	chunks = std::move(of);
	launch(Stage::drawing);
}

void RegionBuild::work(void *self) {
	RegionBuild *diff = static_cast<RegionBuild *>(self);
	const Stage next = diff->do_stage();
	const std::lock_guard<std::mutex> lock(diff->stage_mutex);
	diff->stage = next;
	diff->stage_ended.notify_all();
}

RegionBuild::Stage RegionBuild::do_stage() {
	if (stage == Stage::drawing) {
		plan();
		return Stage::drawn;
	}
	if (stage == Stage::placing) {
		find_new_plants();
		if (input.ground.needs_queries() && new_plants.size() > 0) {
			return Stage::grounding;
		}
		input.ground.look_up(new_plants, heights, normals);
	}
	make_edit();
	return Stage::placed;
}

void RegionBuild::wait_a_little(double usec) {
	const Stage now = stage;
	if (now == Stage::placing || now == Stage::finishing || now == Stage::drawing) {
		std::unique_lock<std::mutex> lock(stage_mutex);
		stage_ended.wait_for(
				lock, std::chrono::duration<double, std::micro>(usec), [&] { return stage.load() != now; });
	}
}

void RegionBuild::find_new_plants() {
	FieldPlants placed;
	for (const AreaBox &box : input.boxes) {
		input.request.within = box;
		FieldPlants some;
		place_plants(input.request, some);
		placed.append(some);
	}
	input.edits.take_out(placed);
	diff = std::make_unique<RegionDiff>(std::move(input.existing), input.spacing);
	new_plants = diff->find_new_plants(placed);
}

void RegionBuild::make_edit() {
	if (heights.size() == size_t(new_plants.size()) && normals.size() == heights.size()) {
		apply_ground(new_plants, heights.data(), normals.data(), input.ground.limits);
	}
	edit = diff->make_edit(new_plants);
}

void RegionBuild::plan() {
	for (NewChunk &one : chunks) {
		one.plans = plan_batches(setup, { { one.texels, &one.chunk, one.number } });
	}
}

} // namespace undergrowth
