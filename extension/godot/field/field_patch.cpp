#include "field/field_patch.hpp"

#include <godot_cpp/classes/worker_thread_pool.hpp>

#include <chrono>
#include <utility>

using namespace godot;

namespace undergrowth {

FieldStyle outline_of(const FieldStyle &style) {
	FieldStyle outline;
	outline.levels = style.levels;
	outline.rule = style.rule;
	outline.tile_size = style.tile_size;
	outline.is_of_tiles = style.is_of_tiles;
	outline.needs_colors = style.needs_colors;
	for (const FieldLook &look : style.looks) {
		FieldLook some;
		some.variant_count = look.variant_count;
		some.detail = look.detail;
		some.is_by_error = look.is_by_error;
		some.levels = look.levels;
		some.variants = look.variants;
		some.meshes = look.meshes;
		some.motion = look.motion;
		some.width = look.width;
		some.nearest.assign(look.nearest.begin(), look.nearest.begin() + (look.nearest.empty() ? 0 : 1));
		outline.looks.push_back(std::move(some));
	}
	return outline;
}

FieldPatch::FieldPatch(PatchRecipe &&with) : recipe(std::move(with)) {}

FieldPatch::~FieldPatch() {
	wait();
}

void FieldPatch::wait() {
	if (task >= 0) {
		WorkerThreadPool::get_singleton()->wait_for_task_completion(task);
		task = -1;
	}
}

void FieldPatch::launch(Stage next) {
	wait();
	stage = next;
	task = WorkerThreadPool::get_singleton()->add_native_task(&FieldPatch::work, this);
}

void FieldPatch::place() {
	launch(Stage::placing);
}

void FieldPatch::go_on(std::vector<float> &&given_heights, std::vector<glm::vec3> &&given_normals) {
	heights = std::move(given_heights);
	normals = std::move(given_normals);
	launch(Stage::standing);
}

void FieldPatch::draw(FieldStyle &&with, std::vector<DrawnNewcomers> &&of) {
	style = std::move(with);
	blocks = std::move(of);
	launch(Stage::drawing);
}

void FieldPatch::work(void *self) {
	FieldPatch *patch = static_cast<FieldPatch *>(self);
	const Stage next = patch->do_stage();
	const std::lock_guard<std::mutex> lock(patch->telling);
	patch->stage = next;
	patch->told.notify_all();
}

FieldPatch::Stage FieldPatch::do_stage() {
	if (stage == Stage::drawing) {
		plan();
		return Stage::drawn;
	}
	if (stage == Stage::placing) {
		find_newcomers();
		if (recipe.ground.needs_survey() && newcomers.size() > 0) {
			return Stage::grounding;
		}
		recipe.ground.look_up(newcomers, heights, normals);
	}
	stand();
	return Stage::placed;
}

void FieldPatch::wait_a_little(double usec) {
	const Stage now = stage;
	if (now == Stage::placing || now == Stage::standing || now == Stage::drawing) {
		std::unique_lock<std::mutex> lock(telling);
		told.wait_for(lock, std::chrono::duration<double, std::micro>(usec), [&] { return stage.load() != now; });
	}
}

void FieldPatch::find_newcomers() {
	FieldPlants placed;
	for (const AreaBox &box : recipe.boxes) {
		recipe.request.within = box;
		FieldPlants some;
		place_plants(recipe.request, some);
		placed.append(some);
	}
	recipe.changes.take_out(placed);
	patch = std::make_unique<StandPatch>(std::move(recipe.standing), recipe.spacing);
	newcomers = patch->find_newcomers(placed);
}

void FieldPatch::stand() {
	if (heights.size() == size_t(newcomers.size()) && normals.size() == heights.size()) {
		apply_ground(newcomers, heights.data(), normals.data(), recipe.ground.limits);
	}
	edit = patch->make_edit(newcomers);
}

void FieldPatch::plan() {
	for (DrawnNewcomers &one : blocks) {
		one.plans = plan_clumps(style, { { one.texels, &one.block, one.number } });
	}
}

} // namespace undergrowth
