#include "field/field_fill.hpp"

#include "field/field_fitting.hpp"

#include <godot_cpp/classes/worker_thread_pool.hpp>

#include <algorithm>
#include <limits>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr int ROWS_AT_ONCE = 16;
// Approximate fractions of the whole time at which each part of the work ends.
static constexpr float PLACED_SHARE = 0.3f;
static constexpr float STANDING_SHARE = 0.5f;
static constexpr float MESHES_SHARE = 0.6f;
static constexpr float PLANNED_SHARE = 0.8f;

String FieldResult::describe_fault() const {
	if (fault != PlacementFault::none) {
		return undergrowth::describe(fault);
	}
	if (motion->is_too_large()) {
		return "needs more texture layers than graphics cards have. Set a lower density, fewer species where there are "
			   "prototypes, or divide it among several fields.";
	}
	return String();
}

FieldFill::FieldFill(FieldRecipe &&with) : recipe(std::move(with)) {
	result.style = std::move(recipe.style);
}

FieldFill::~FieldFill() {
	cancel();
	wait();
}

void FieldFill::wait() {
	if (task >= 0) {
		WorkerThreadPool::get_singleton()->wait_for_task_completion(task);
		task = -1;
	}
}

void FieldFill::launch(Stage next) {
	wait();
	stage = next;
	task = WorkerThreadPool::get_singleton()->add_native_task(&FieldFill::work, this);
}

void FieldFill::start() {
	launch(Stage::placing);
}

void FieldFill::go_on(std::vector<float> &&given_heights, std::vector<glm::vec3> &&given_normals) {
	heights = std::move(given_heights);
	normals = std::move(given_normals);
	launch(Stage::building);
}

FieldResult &FieldFill::finish() {
	wait();
	return result;
}

std::unique_ptr<ClumpPlan> FieldFill::take_plan() {
	if (result.plans.empty()) {
		return nullptr;
	}
	auto plan = std::make_unique<ClumpPlan>(std::move(result.plans.back()));
	result.plans.pop_back();
	return plan;
}

std::function<void()> FieldFill::take_rubbish() {
	auto blocks = std::make_shared<FilledBlocks>(std::move(recipe.standing));
	auto kept = std::make_shared<std::vector<KeptPlant>>(std::move(result.kept));
	return [blocks = std::move(blocks), kept = std::move(kept)]() mutable {
		blocks.reset();
		kept.reset();
	};
}

void FieldFill::work(void *self) {
	FieldFill *fill = static_cast<FieldFill *>(self);
	if (fill->stage == Stage::placing) {
		if (fill->recipe.places) {
			fill->place();
		} else {
			fill->placed = gather_plants(fill->recipe.standing, fill->recipe.species_numbers);
			fill->result.spacing = fill->recipe.standing.spacing;
		}
		if (fill->recipe.places && fill->recipe.ground.needs_survey() && fill->placed.size() > 0) {
			fill->stage = Stage::placed;
			return;
		}
		if (fill->recipe.places) {
			fill->recipe.ground.look_up(fill->placed, fill->heights, fill->normals);
		}
	}
	fill->stand_on_ground();
	fill->build();
	fill->stage = Stage::done;
}

void FieldFill::place() {
	PlacementRequest request = recipe.request;
	if (recipe.is_of_tiles) {
		request.within = AreaBox(); // Only for faults and the spacing.
	}
	const Placement whole(request);
	result.fault = request.species.empty() ? PlacementFault::none : whole.fault();
	result.spacing = whole.cell_size();
	place_rows(whole, 0.0f, PLACED_SHARE);
	const float each = PLACED_SHARE / float(std::max(recipe.tiles.size(), size_t(1)));
	for (size_t i = 0; i < recipe.tiles.size() && result.fault == PlacementFault::none; i++) {
		request.within = tile_box(recipe.tiles[i], recipe.tile_size);
		const Placement tile(request);
		result.fault = tile.fault();
		place_rows(tile, each * float(i), each * float(i + 1));
	}
	if (placed.size() > int(PlacementRequest::MOST_PLANTS)) {
		result.fault = PlacementFault::too_many_plants;
		placed.clear();
	}
	recipe.changes.take_out(placed);
	done = PLACED_SHARE;
}

void FieldFill::place_rows(const Placement &placement, float share_before, float share_after) {
	for (int row = 0; row < placement.row_count() && !is_cancelled; row += ROWS_AT_ONCE) {
		placement.place_rows(row, std::min(row + ROWS_AT_ONCE, placement.row_count()), placed);
		done = share_before + (share_after - share_before) * float(row) / float(placement.row_count());
	}
}

void FieldFill::stand_on_ground() {
	if (heights.size() == size_t(placed.size()) && normals.size() == heights.size()) {
		apply_ground(placed, heights.data(), normals.data(), recipe.ground.limits);
		heights = {};
		normals = {};
	}
	done = STANDING_SHARE;
}

void FieldFill::build() {
	for (FieldLook &look : result.style.looks) {
		if (is_cancelled) {
			return;
		}
		look.measure();
	}
	fit_levels(result.style);
	for (FieldLook &look : result.style.looks) {
		if (is_cancelled) {
			return;
		}
		look.build();
		if (recipe.makes_meshes) {
			look.make_meshes(std::numeric_limits<double>::infinity());
		}
	}
	done = MESHES_SHARE;
	result.blocks = cut_into_blocks(placed, recipe.tile_size);
	for (PlantBlock &block : result.blocks) {
		block.spacing = result.spacing;
	}
	placed = FieldPlants();
	result.motion = recipe.prepare(result.blocks, result.style, recipe.settings, recipe.wind);
	result.style.tile_size = recipe.tile_size;
	result.style.is_of_tiles = recipe.draws_tiles;
	std::vector<DrawnBlock> drawn;
	for (size_t i = 0; i < result.blocks.size() && !is_cancelled; i++) {
		drawn.push_back({ result.motion->texels(int(i)), &result.blocks[i] });
	}
	result.plans = plan_clumps(result.style, drawn);
	done = PLANNED_SHARE;
	stage = Stage::planned;
	if (is_cancelled) {
		return;
	}
	result.motion->fill(result.blocks, result.style);
	if (is_cancelled) {
		return;
	}
	result.kept = find_kept(recipe.standing, result.blocks, result.spacing);
	done = 1.0f;
}

} // namespace undergrowth
