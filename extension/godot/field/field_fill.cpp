#include "field/field_fill.hpp"

#include <godot_cpp/classes/worker_thread_pool.hpp>

#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr int ROWS_AT_ONCE = 16;
// Shares of the whole time, about, at which each part of the work is done.
static constexpr float PLACED_SHARE = 0.3f;
static constexpr float STANDING_SHARE = 0.5f;
static constexpr float MESHES_SHARE = 0.6f;
static constexpr float SIMULATED_SHARE = 0.8f;

std::vector<float> reaches(const FieldStyle &style) {
	std::vector<float> reach;
	for (const FieldLook &look : style.looks) {
		reach.push_back(look.motion.longest + look.width);
	}
	return reach;
}

static void add_page(
		const FieldStyle &style, FieldSimulation &simulation, const PagePlan &plan, int number, FieldPatch &patch) {
	const std::vector<int> members = plan.plants(number);
	const int species = plan.pages[size_t(number)].species;
	std::vector<FieldPlant> simulated;
	simulated.reserve(members.size());
	for (const int plant : members) {
		simulated.push_back(style.looks[size_t(species)].to_simulate(patch.plants.plant(plant)));
	}
	const int page = simulation.add_page(species, simulated.data(), int(simulated.size()));
	for (size_t i = 0; page >= 0 && i < members.size(); i++) {
		patch.places[size_t(members[i])] = uint32_t(page) * FieldPage::PAGE_PLANTS + uint32_t(i);
	}
}

// Sorts plants into chunks, adds them to the simulation as pages and notes where each is.
static void take_in(const FieldStyle &style, FieldSimulation &simulation, float chunk_size, FieldPatch &patch) {
	const std::vector<float> reach = reaches(style);
	patch.chunks = sort_into_chunks(patch.plants, chunk_size, reach.data(), int(reach.size()));
	patch.places.assign(size_t(patch.plants.size()), FieldPatch::GONE);
	const PagePlan plan = plan_pages(patch.chunks, FieldPage::PAGE_PLANTS);
	for (int page = 0; page < int(plan.pages.size()); page++) {
		add_page(style, simulation, plan, page, patch);
	}
}

FieldFill::FieldFill(FieldRecipe &&with) : recipe(std::move(with)) {
	result.style = std::move(recipe.style);
}

FieldFill::~FieldFill() {
	is_cancelled = true;
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

void FieldFill::work(void *self) {
	FieldFill *fill = static_cast<FieldFill *>(self);
	if (fill->stage == Stage::placing) {
		fill->place();
		if (fill->recipe.ground.needs_rays()) {
			fill->stage = Stage::placed;
			return;
		}
		fill->recipe.ground.look_up(fill->result.patch.plants, fill->heights, fill->normals);
	}
	fill->stand();
	fill->build();
	fill->stage = Stage::done;
}

void FieldFill::place() {
	const Placement placement(recipe.request);
	for (int row = 0; row < placement.row_count() && !is_cancelled; row += ROWS_AT_ONCE) {
		placement.place_rows(row, std::min(row + ROWS_AT_ONCE, placement.row_count()), result.patch.plants);
		done = PLACED_SHARE * float(row) / float(placement.row_count());
	}
	done = PLACED_SHARE;
}

void FieldFill::stand() {
	if (heights.size() == size_t(result.patch.plants.size()) && normals.size() == heights.size()) {
		apply_ground(result.patch.plants, heights.data(), normals.data(), recipe.ground.limits);
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
		look.build();
	}
	done = MESHES_SHARE;
	result.simulation = std::make_unique<FieldSimulation>(recipe.settings);
	result.simulation->set_wind(recipe.wind);
	for (const FieldLook &look : result.style.looks) {
		result.simulation->add_species(look.motion);
	}
	take_in(result.style, *result.simulation, recipe.chunk_size, result.patch);
	if (recipe.settings.prototypes > 0) {
		result.simulation->step(); // It fills the prototypes' history.
	}
	result.bends = std::make_unique<FieldBends>();
	result.bends->make_images(*result.simulation);
	done = SIMULATED_SHARE;
	if (!is_cancelled) {
		result.plans = FieldDrawing::plan(result.style, result.patch);
	}
	done = 1.0f;
}

} // namespace undergrowth
