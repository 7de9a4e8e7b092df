#include "field/build/field_build.hpp"

#include "field/view/field_fitting.hpp"
#include "placement/plant_removal.hpp"

#include <glm/common.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
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
		return "needs more texture layers than graphics cards support. Reduce the density, use fewer species with "
			   "prototypes, or use several fields.";
	}
	return String();
}

FieldBuild::FieldBuild(BuildInput &&with) : input(std::move(with)) {
	result.setup = std::move(input.setup);
}

FieldBuild::~FieldBuild() {
	cancel();
	wait();
}

void FieldBuild::wait() {
	Workers::wait(task);
}

void FieldBuild::launch(Stage next) {
	wait();
	stage = next;
	task = Workers::start(&FieldBuild::work, this);
}

void FieldBuild::start() {
	launch(Stage::placing);
}

void FieldBuild::resume(std::vector<float> &&given_heights, std::vector<glm::vec3> &&given_normals) {
	heights = std::move(given_heights);
	normals = std::move(given_normals);
	launch(Stage::building);
}

FieldResult &FieldBuild::finish() {
	wait();
	return result;
}

std::function<void()> FieldBuild::take_garbage() {
	auto chunks = std::make_shared<GeneratedChunks>(std::move(input.existing));
	garbage.push_back(std::move(chunks));
	garbage.push_back(std::make_shared<std::vector<PlantMatch>>(std::move(result.matches)));
	return [all = std::move(garbage)]() mutable { all.clear(); };
}

void FieldBuild::work(void *self) {
	FieldBuild *build = static_cast<FieldBuild *>(self);
	if (build->stage == Stage::placing) {
		if (build->places()) {
			build->place();
		} else {
			build->placed = gather_plants(build->input.existing, build->input.species_numbers);
			build->result.spacing = build->input.existing.spacing;
		}
		if (build->places() && build->input.ground.needs_queries() && build->placed.size() > 0) {
			build->stage = Stage::placed;
			return;
		}
		if (build->places()) {
			build->input.ground.look_up(build->placed, build->heights, build->normals);
		}
	}
	build->apply_heights();
	build->build();
	build->stage = Stage::done;
}

void FieldBuild::place() {
	PlacementRequest request = input.request;
	if (input.is_of_tiles) {
		request.within = AreaBox(); // Only for faults and the spacing.
	}
	const Placement whole(request);
	result.fault = request.species.empty() ? PlacementFault::none : whole.fault();
	result.spacing = whole.cell_size();
	place_rows(whole, 0.0f, PLACED_SHARE);
	const float each = PLACED_SHARE / float(std::max(input.tiles.size(), size_t(1)));
	for (size_t i = 0; i < input.tiles.size() && result.fault == PlacementFault::none; i++) {
		request.within = tile_box(input.tiles[i], input.tile_size);
		const Placement tile(request);
		result.fault = tile.fault();
		place_rows(tile, each * float(i), each * float(i + 1));
	}
	if (input.request.competition.is_on()) {
		place_around();
	}
	if (placed.size() > int(PlacementRequest::MAX_PLANTS)) {
		result.fault = PlacementFault::too_many_plants;
		placed.clear();
	}
	if (!input.request.competition.is_on()) {
		input.edits.take_out(placed);
	}
	done = PLACED_SHARE;
}

void FieldBuild::place_rows(const Placement &placement, float share_before, float share_after) {
	for (int row = 0; row < placement.row_count() && !is_cancelled; row += ROWS_AT_ONCE) {
		placement.place_rows(row, std::min(row + ROWS_AT_ONCE, placement.row_count()), placed);
		done = share_before + (share_after - share_before) * float(row) / float(placement.row_count());
	}
}

// Competition needs the plants around the tiles, which are placed with them.
void FieldBuild::place_around() {
	const float reach = input.request.competition.reach();
	const std::set<TileKey> tiles(input.tiles.begin(), input.tiles.end());
	std::map<TileKey, AreaBox> around;
	for (const TileKey &tile : input.tiles) {
		const AreaBox box = tile_box(tile, input.tile_size);
		for (int i = 0; i < 9; i++) {
			const TileKey other = { tile.column + i % 3 - 1, tile.row + i / 3 - 1 };
			const AreaBox both =
					common_box(tile_box(other, input.tile_size), { box.low - reach, box.high + reach });
			if (tiles.count(other) == 0 && both.low.x < both.high.x && both.low.y < both.high.y) {
				const AreaBox known = around.emplace(other, both).first->second;
				around[other] = { glm::min(known.low, both.low), glm::max(known.high, both.high) };
			}
		}
	}
	PlacementRequest request = input.request;
	for (const auto &[tile, box] : around) {
		request.within = box;
		const Placement beside(request);
		beside.place_rows(0, beside.row_count(), placed);
	}
}

void FieldBuild::compete_around() {
	if (!input.request.competition.is_on()) {
		return;
	}
	compete(input.request.competition, placed, heights, normals);
	if (input.is_of_tiles) {
		const std::set<TileKey> tiles(input.tiles.begin(), input.tiles.end());
		std::vector<int> outside;
		for (int i = 0; i < placed.size(); i++) {
			if (tiles.count(tile_at(placed.x[size_t(i)], placed.z[size_t(i)], input.tile_size)) == 0) {
				outside.push_back(i);
			}
		}
		remove_plants(outside, placed, heights, normals);
	}
}

void FieldBuild::apply_heights() {
	if (places()) {
		thin_by_habitats(input.request.habitats, input.ground.survey.get(), placed, heights, normals);
		compete_around();
	}
	if (heights.size() == size_t(placed.size()) && normals.size() == heights.size()) {
		apply_ground(placed, heights.data(), normals.data(), input.ground.limits);
		heights = {};
		normals = {};
	}
	if (places() && input.request.competition.is_on()) {
		input.edits.take_out(placed); // Now, because removed plants competed, too.
	}
	done = STANDING_SHARE;
}

void FieldBuild::fit() {
	result.setup.is_draft = input.is_draft;
	if (input.is_draft) {
		fit_drafts(result.setup);
		return;
	}
	for (SpeciesStyle &style : result.setup.styles) {
		if (is_cancelled) {
			return;
		}
		style.measure();
	}
	fit_levels(result.setup);
}

void FieldBuild::build() {
	fit();
	for (SpeciesStyle &style : result.setup.styles) {
		if (is_cancelled) {
			return;
		}
		style.build();
		if (input.makes_meshes) {
			style.make_meshes(std::numeric_limits<double>::infinity());
		}
	}
	done = MESHES_SHARE;
	result.chunks = cut_into_chunks(placed, input.tile_size);
	for (PlantChunk &chunk : result.chunks) {
		chunk.spacing = result.spacing;
	}
	placed = FieldPlants();
	result.motion = std::make_unique<PreparedMotion>(result.chunks, result.setup, input.settings, input.wind);
	result.setup.tile_size = input.tile_size;
	result.setup.is_of_tiles = input.draws_tiles;
	std::vector<DrawnChunk> drawn;
	for (size_t i = 0; i < result.chunks.size() && !is_cancelled; i++) {
		drawn.push_back({ result.motion->texels(int(i)), &result.chunks[i] });
	}
	result.plans = plan_batches(result.setup, drawn);
	done = PLANNED_SHARE;
	stage = Stage::planned;
	if (is_cancelled) {
		return;
	}
	result.motion->build(result.chunks, result.setup);
	if (is_cancelled) {
		return;
	}
	result.matches = match_plants(input.existing, result.chunks, result.spacing);
	done = 1.0f;
}

} // namespace undergrowth
