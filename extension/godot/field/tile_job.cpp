#include "field/tile_job.hpp"

#include <godot_cpp/classes/worker_thread_pool.hpp>

#include <utility>

using namespace godot;

namespace undergrowth {

TileJob::TileJob(TileRecipe &&with) : recipe(std::move(with)) {}

TileJob::~TileJob() {
	wait();
}

void TileJob::wait() {
	if (task >= 0) {
		WorkerThreadPool::get_singleton()->wait_for_task_completion(task);
		task = -1;
	}
}

bool TileJob::is_at_work() const {
	const Stage now = stage.load();
	return now == Stage::placing || now == Stage::standing || now == Stage::drawing;
}

void TileJob::launch(Stage next) {
	wait();
	stage = next;
	task = WorkerThreadPool::get_singleton()->add_native_task(&TileJob::work, this);
}

void TileJob::start() {
	launch(Stage::placing);
}

void TileJob::go_on(std::vector<float> &&given_heights, std::vector<glm::vec3> &&given_normals) {
	heights = std::move(given_heights);
	normals = std::move(given_normals);
	launch(Stage::standing);
}

void TileJob::draw() {
	launch(Stage::drawing);
}

PlantBlock TileJob::take_block(std::unique_ptr<PreparedBlock> &made) {
	made = std::move(prepared[taken]);
	return std::move(blocks[taken++]);
}

void TileJob::reserve(FieldMotion &motion) {
	for (const std::unique_ptr<PreparedBlock> &block : prepared) {
		places.push_back(motion.reserve(*block));
	}
}

void TileJob::give_up(FieldMotion &motion) {
	wait();
	for (size_t i = 0; i < places.size() && i < prepared.size(); i++) {
		motion.give_up(*prepared[i]);
	}
}

void TileJob::take_all(StandEdit &edit, ArrivingBlocks &arriving) {
	edit.stood = std::move(blocks);
	arriving.prepared = std::move(prepared);
	arriving.kept = std::move(kept);
	prepared.clear();
}

void TileJob::work(void *self) {
	TileJob *job = static_cast<TileJob *>(self);
	const Stage now = job->stage;
	if (now == Stage::drawing) {
		job->plan();
		job->stage = Stage::drawn;
		return;
	}
	if (now == Stage::placing) {
		place_plants(job->recipe.request, job->placed);
		job->recipe.changes.take_out(job->placed);
		if (job->recipe.ground.needs_survey() && job->placed.size() > 0) {
			job->stage = Stage::grounding;
			return;
		}
		job->recipe.ground.look_up(job->placed, job->heights, job->normals);
	}
	job->stand();
	job->stage = Stage::placed;
}

void TileJob::stand() {
	if (heights.size() == size_t(placed.size()) && normals.size() == heights.size()) {
		apply_ground(placed, heights.data(), normals.data(), recipe.ground.limits);
	}
	blocks = cut_into_blocks(placed, recipe.tile_size);
	placed.clear();
	for (PlantBlock &block : blocks) {
		block.spacing = recipe.spacing;
		prepared.push_back(recipe.prepare(block, *recipe.style, recipe.settings));
	}
	copies = blocks;
	kept = find_kept(recipe.standing, blocks, recipe.spacing);
}

void TileJob::plan() {
	std::vector<DrawnBlock> drawn;
	for (size_t i = 0; i < copies.size(); i++) {
		drawn.push_back({ places[i], &copies[i] });
	}
	plans = plan_clumps(*recipe.style, drawn);
}

} // namespace undergrowth
