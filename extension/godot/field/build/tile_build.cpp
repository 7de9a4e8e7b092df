#include "field/build/tile_build.hpp"

#include <godot_cpp/classes/worker_thread_pool.hpp>

#include <utility>

using namespace godot;

namespace undergrowth {

TileBuild::TileBuild(TileBuildInput &&with) : input(std::move(with)) {}

TileBuild::~TileBuild() {
	wait();
}

void TileBuild::wait() {
	if (task >= 0) {
		WorkerThreadPool::get_singleton()->wait_for_task_completion(task);
		task = -1;
	}
}

bool TileBuild::is_at_work() const {
	const Stage now = stage.load();
	return now == Stage::placing || now == Stage::finishing || now == Stage::drawing;
}

void TileBuild::launch(Stage next) {
	wait();
	stage = next;
	task = WorkerThreadPool::get_singleton()->add_native_task(&TileBuild::work, this);
}

void TileBuild::start() {
	launch(Stage::placing);
}

void TileBuild::resume(std::vector<float> &&given_heights, std::vector<glm::vec3> &&given_normals) {
	heights = std::move(given_heights);
	normals = std::move(given_normals);
	launch(Stage::finishing);
}

void TileBuild::draw() {
	launch(Stage::drawing);
}

PlantChunk TileBuild::take_chunk(std::unique_ptr<PreparedChunk> &made) {
	made = std::move(prepared[taken]);
	return std::move(chunks[taken++]);
}

void TileBuild::reserve(FieldMotion &motion) {
	for (const std::unique_ptr<PreparedChunk> &chunk : prepared) {
		places.push_back(motion.reserve(*chunk));
	}
}

void TileBuild::release_texels(FieldMotion &motion) {
	wait();
	for (size_t i = 0; i < places.size() && i < prepared.size(); i++) {
		motion.release_texels(*prepared[i]);
	}
}

void TileBuild::take_all(StoreEdit &edit, ArrivingChunks &arriving) {
	edit.arriving = std::move(chunks);
	arriving.prepared = std::move(prepared);
	arriving.matches = std::move(matches);
	prepared.clear();
}

void TileBuild::work(void *self) {
	TileBuild *job = static_cast<TileBuild *>(self);
	const Stage now = job->stage;
	if (now == Stage::drawing) {
		job->plan();
		job->stage = Stage::drawn;
		return;
	}
	if (now == Stage::placing) {
		place_plants(job->input.request, job->placed);
		job->input.edits.take_out(job->placed);
		if (job->input.ground.needs_queries() && job->placed.size() > 0) {
			job->stage = Stage::grounding;
			return;
		}
		job->input.ground.look_up(job->placed, job->heights, job->normals);
	}
	job->make_chunks();
	job->stage = Stage::placed;
}

void TileBuild::make_chunks() {
	if (heights.size() == size_t(placed.size()) && normals.size() == heights.size()) {
		apply_ground(placed, heights.data(), normals.data(), input.ground.limits);
	}
	chunks = cut_into_chunks(placed, input.tile_size);
	placed.clear();
	for (PlantChunk &chunk : chunks) {
		chunk.spacing = input.spacing;
		prepared.push_back(std::make_unique<PreparedChunk>(chunk, *input.setup, input.settings));
	}
	copies = chunks;
	matches = match_plants(input.existing, chunks, input.spacing);
}

void TileBuild::plan() {
	std::vector<DrawnChunk> drawn;
	for (size_t i = 0; i < copies.size(); i++) {
		drawn.push_back({ places[i], &copies[i] });
	}
	plans = plan_batches(*input.setup, drawn);
}

} // namespace undergrowth
