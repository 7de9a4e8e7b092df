#include "field/build/tile_join.hpp"

#include <utility>

namespace undergrowth {

void TileJoin::enter(Stage into) {
	stage = into;
	next = 0;
}

void TileJoin::begin(const Scene &scene) {
	stop(scene);
	enter(Stage::copying);
}

void TileJoin::stop(const Scene &scene) {
	if (stage != Stage::idle) {
		task.reset();
		copies.clear();
		scene.view.forget_prepared();
		enter(Stage::idle);
	}
}

float TileJoin::progress() const {
	static constexpr float STAGES = 4.0f;
	return stage == Stage::idle ? 1.0f : float(int(stage) - 1) / STAGES;
}

// All chunks at once would take longer than the budget of a frame.
bool TileJoin::copy_some(const Scene &scene, const Stopwatch &watch) {
	for (; next < scene.store.chunk_count() && watch.usec() < scene.budget_usec; next++) {
		const PlantChunk &chunk = scene.store.chunk(next);
		if (chunk.live_count() > 0 && !chunk.is_added && !chunk.is_new) {
			copies.push_back({ -1, chunk, scene.motion.texels(next) });
		}
	}
	if (next < scene.store.chunk_count()) {
		return false;
	}
	FieldRenderSetup outline = outline_of(scene.setup);
	outline.is_of_tiles = false;
	task = std::make_unique<TileBuildTask>(
			std::make_shared<const FieldRenderSetup>(std::move(outline)), std::exchange(copies, {}));
	task->draw();
	enter(Stage::planning);
	return true;
}

bool TileJoin::prepare_some(const Scene &scene, const Stopwatch &watch) {
	while (watch.usec() < scene.budget_usec) {
		const BatchPlan *plan = task->next_plan();
		if (!plan) {
			task.reset();
			enter(Stage::exchanging);
			return true;
		}
		if (plan->place.factor > 1) {
			scene.view.prepare(scene.setup, *plan);
		}
	}
	return false;
}

bool TileJoin::exchange_some(const Scene &scene, const Stopwatch &watch) {
	const int species_count = int(scene.setup.styles.size());
	const int count = int(scene.setup.levels.size()) * species_count;
	for (; next < count && watch.usec() < scene.budget_usec; next++) {
		scene.view.join_level(scene.setup, next / species_count, next % species_count);
	}
	return next == count;
}

bool TileJoin::resume(const Scene &scene) {
	const Stopwatch watch;
	if (stage == Stage::copying && !copy_some(scene, watch)) {
		return false;
	}
	if (stage == Stage::planning && task->is_drawn()) {
		enter(Stage::preparing);
	}
	if (stage == Stage::preparing) {
		prepare_some(scene, watch);
	}
	if (stage != Stage::exchanging || !exchange_some(scene, watch)) {
		return false;
	}
	scene.motion.release_left_texels();
	enter(Stage::idle);
	return true;
}

} // namespace undergrowth
