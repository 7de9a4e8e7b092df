#include "field/build/tile_build_task.hpp"

#include "placement/plant_removal.hpp"

#include <chrono>
#include <utility>

using namespace godot;

namespace undergrowth {

TileBuildTask::TileBuildTask(TileBuildInput &&with) : input(std::move(with)) {
	for (const PlantRef &ref : input.existing_in_part.refs) {
		compared_chunks.insert(ref.chunk);
	}
}

TileBuildTask::TileBuildTask(
		std::shared_ptr<const FieldRenderSetup> setup, std::vector<ChunkToDraw> &&new_chunks) :
		copies(std::move(new_chunks)) {
	input.setup = std::move(setup);
}

void TileBuildTask::wait() {
	Workers::wait(task);
}

void TileBuildTask::wait_a_little(double usec) {
	if (is_at_work()) {
		std::unique_lock<std::mutex> lock(stage_mutex);
		stage_ended.wait_for(lock, std::chrono::duration<double, std::micro>(usec), [this] { return !is_at_work(); });
	}
}

bool TileBuildTask::is_at_work() const {
	const Stage now = stage.load();
	return now == Stage::placing || now == Stage::finishing || now == Stage::drawing;
}

void TileBuildTask::launch(Stage next) {
	wait();
	stage = next;
	task = Workers::start(&TileBuildTask::work, this);
}

void TileBuildTask::resume(std::vector<float> &&given_heights, std::vector<glm::vec3> &&given_normals) {
	heights = std::move(given_heights);
	normals = std::move(given_normals);
	launch(Stage::finishing);
}

void TileBuildTask::work(void *self) {
	TileBuildTask *build = static_cast<TileBuildTask *>(self);
	const Stage next = build->do_stage();
	const std::lock_guard<std::mutex> lock(build->stage_mutex);
	build->stage = next;
	build->stage_ended.notify_all();
}

TileBuildTask::Stage TileBuildTask::do_stage() {
	if (stage == Stage::drawing) {
		plan();
		return Stage::drawn;
	}
	if (stage == Stage::placing) {
		place();
		if (input.ground.needs_queries() && placed.size() > 0) {
			return Stage::grounding;
		}
		input.ground.look_up(placed, heights, normals);
	}
	finish_placing();
	return Stage::placed;
}

// Competition needs the plants around the tile, and the ground under all of them.
void TileBuildTask::place() {
	PlacementRequest wide = input.request;
	const float reach = wide.competition.reach();
	wide.within = AreaBox{ wide.within->low - reach, wide.within->high + reach };
	place_plants(wide, placed);
	if (!wide.competition.is_on()) {
		input.edits.take_out(placed);
	}
	if (input.part) {
		diff = std::make_unique<RegionDiff>(std::move(input.existing_in_part), input.spacing);
		placed = wide.competition.is_on() ? placed : diff->find_new_plants(placed);
	}
}

void TileBuildTask::finish_placing() {
	thin_by_habitats(input.request.habitats, input.ground.survey.get(), placed, heights, normals);
	if (input.request.competition.is_on()) {
		compete(input.request.competition, placed, heights, normals);
		crop_plants(*input.request.within, placed, heights, normals);
	}
	if (heights.size() == size_t(placed.size()) && normals.size() == heights.size()) {
		apply_ground(placed, heights.data(), normals.data(), input.ground.limits);
	}
	if (input.request.competition.is_on()) {
		input.edits.take_out(placed); // Now, because removed plants competed, too.
	}
	if (diff && input.request.competition.is_on()) {
		placed = diff->find_new_plants(placed);
	}
	if (diff) {
		edit = diff->make_edit(placed);
	} else {
		make_chunks();
	}
}

void TileBuildTask::make_chunks() {
	edit.left_tiles = { input.tile };
	edit.spacing = input.spacing;
	built_count = placed.size();
	edit.arriving = cut_into_chunks(placed, input.tile_size);
	placed.clear();
	for (PlantChunk &chunk : edit.arriving) {
		chunk.spacing = input.spacing;
		prepared.push_back(std::make_unique<PreparedChunk>(chunk, *input.setup, input.settings));
		copies.push_back({ -1, chunk, {} });
	}
	matches = match_plants(input.existing, edit.arriving, input.spacing);
}

void TileBuildTask::plan() {
	std::vector<DrawnChunk> drawn;
	for (const ChunkToDraw &one : copies) {
		drawn.push_back({ one.texels, &one.chunk, one.number });
	}
	plans = plan_batches(*input.setup, drawn);
	for (ChunkToDraw &one : copies) { // Here, because freeing them takes time.
		one.chunk.plants = FieldPlants();
	}
}

void TileBuildTask::leave_plan() {
	plans[shown++].buffer = PackedFloat32Array(); // All of them at once would take long.
}

void TileBuildTask::reserve(FieldMotion &motion) {
	for (size_t i = 0; i < copies.size(); i++) {
		copies[i].texels = motion.reserve(*prepared[i]);
	}
}

void TileBuildTask::release_texels(FieldMotion &motion) {
	wait();
	for (const std::unique_ptr<PreparedChunk> &chunk : prepared) {
		motion.release_texels(*chunk);
	}
}

StoreEdit TileBuildTask::take_edit(ArrivingChunks &arriving) {
	arriving.prepared = std::move(prepared);
	arriving.matches = std::move(matches);
	prepared.clear();
	return std::move(edit);
}

} // namespace undergrowth
