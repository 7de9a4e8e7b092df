// Changes and queries of CpuMotion. cpu_motion_steps.cpp has the steps.

#include "field/motion/cpu_motion.hpp"

#include "plants/plant_simulation.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr double USUAL_STEP = 1.0 / 60.0; // s.

CpuMotion::CpuMotion() : clock(USUAL_STEP) {}

CpuMotion::~CpuMotion() {
	steps.wait();
}

void CpuMotion::wait() {
	steps.wait();
	transfer.wait();
	for (const Height &one : std::exchange(heights, {})) {
		const int page = rows_of(one.ref.chunk).page;
		if (!simulation->page(page).is_gone(row_of(one.ref))) {
			simulation->page(page).set_plant(row_of(one.ref), one.plant);
			textures->set_height(page, row_of(one.ref), one.share);
		}
	}
	if (pending_removals.empty()) {
		return;
	}
	for (const PlantRef &ref : std::exchange(pending_removals, {})) {
		drop(rows_of(ref.chunk).page, row_of(ref));
	}
	textures->write_history(*simulation, false);
	fit_contact(touches);
}

FieldMotion::Prepare CpuMotion::prepare() const {
	return &prepare_on_cpu;
}

FieldMotion::PrepareChunk CpuMotion::prepare_chunk() const {
	return &prepare_chunk_on_cpu;
}

void CpuMotion::start(const FieldSettings &settings) {
	wait();
	is_transferred = false;
	simulation = std::make_unique<FieldSimulation>(settings);
	textures = std::make_unique<PoseTexture>(settings.prototypes > 0);
	rows.clear();
	begin_clock();
}

void CpuMotion::begin_clock() {
	clock = FixedStep(PlantSimulation::get_singleton()->get_step_length());
	wind_clock.forget();
	dirty_pages.clear();
}

void CpuMotion::begin_transfer(PreparedMotion &prepared, const std::vector<PlantMatch> &matches) {
	static constexpr size_t FEW = 2000; // Fewer cost less than waking a thread.
	wait();
	is_transferred = true;
	auto &own = static_cast<PreparedCpuMotion &>(prepared);
	if (matches.size() < FEW) {
		own.transfer_motion(simulation.get(), rows, matches);
	} else {
		transfer.start([this, &own, &matches] { own.transfer_motion(simulation.get(), rows, matches); });
	}
}

void CpuMotion::cancel_transfer() {
	transfer.wait();
	is_transferred = false;
}

void CpuMotion::adopt(PreparedMotion &prepared, const std::vector<PlantMatch> &matches, const ChangeSet &changes,
		const PlantStore &store, const FieldRenderSetup &setup) {
	wait();
	auto &own = static_cast<PreparedCpuMotion &>(prepared);
	if (!std::exchange(is_transferred, false)) {
		own.transfer_motion(simulation.get(), rows, matches);
	}
	const std::unique_ptr<FieldSimulation> old = std::exchange(simulation, std::move(own.simulation));
	const std::vector<PageRows> old_rows = std::move(rows);
	textures = std::move(own.textures);
	rows.assign(size_t(store.chunk_count()), {});
	for (size_t i = 0; i < own.rows.size(); i++) {
		rows[size_t(changes.grown[i].chunk)] = own.rows[i];
	}
	for (int i = 0; i < int(setup.styles.size()); i++) {
		simulation->set_species(i, setup.styles[size_t(i)].motion);
	}
	textures->give_history(*simulation); // Stems may have more modes than when the build began.
	take_added(store, setup, old.get(), old_rows);
	begin_clock();
	write_all();
	fit_contact(touches);
}

// Added plants and their motion survive a build.
void CpuMotion::take_added(const PlantStore &store, const FieldRenderSetup &setup, const FieldSimulation *old,
		const std::vector<PageRows> &old_rows) {
	for (int chunk = 0; chunk < store.chunk_count(); chunk++) {
		if (!store.chunk(chunk).is_added) {
			continue;
		}
		grow({ chunk, 0 }, store, setup);
		const PageRows from = size_t(chunk) < old_rows.size() ? old_rows[size_t(chunk)] : PageRows();
		const PageRows &to = rows_of(chunk);
		const MotionPage &now = simulation->page(to.page);
		for (int slot = 0; old && from.page >= 0 && slot < std::min(from.count, to.count); slot++) {
			const MotionPage &before = old->page(from.page);
			if (!now.is_gone(to.first + slot) && before.root(from.first + slot) == now.root(to.first + slot)) {
				simulation->transfer_motion(to.page, to.first + slot, *old, from.page, from.first + slot);
			}
		}
	}
}

// Without new plants the running step continues: removed plants wait for the next wait().
void CpuMotion::apply(
		const ChangeSet &changes, const PlantStore &store, const FieldRenderSetup &setup, ArrivingChunks *arriving) {
	if (changes.dropped.empty() && changes.grown.empty()) {
		pending_removals.insert(pending_removals.end(), changes.gone.begin(), changes.gone.end());
		return;
	}
	wait();
	rows.resize(size_t(store.chunk_count()));
	if (arriving) {
		exchange_chunks(changes, *arriving);
		fit_contact(touches);
		return;
	}
	const auto grow_those = [&](bool late) {
		for (const ChangeSet::Grown &grown : changes.grown) {
			if (store.chunk(grown.chunk).is_new == late) {
				grow(grown, store, setup);
			}
		}
	};
	grow_those(true);
	for (const ChangeSet::Moved &plant : changes.moved) {
		const int to = rows_of(plant.to.chunk).page;
		const MotionPage &before = simulation->page(rows_of(plant.from.chunk).page);
		simulation->page(to).transfer_motion(row_of(plant.to), before, row_of(plant.from));
		dirty_pages.push_back(to);
	}
	for (const int chunk : changes.dropped) {
		drop_rows(std::exchange(rows[size_t(chunk)], {}), false);
	}
	grow_those(false);
	for (const PlantRef &ref : changes.gone) {
		drop(rows_of(ref.chunk).page, row_of(ref));
	}
	textures->write_history(*simulation, false);
	fit_contact(touches);
}

void CpuMotion::drop(int page, int row) {
	simulation->drop(page, row);
	textures->hide(page, row);
}

// Only chunks of added or new plants grow; each has a page of its own. New plants keep their texels. All plants of
// to_simulate() are valid, as the page requires.
void CpuMotion::grow(const ChangeSet::Grown &grown, const PlantStore &store, const FieldRenderSetup &setup) {
	const PlantChunk &chunk = store.chunk(grown.chunk);
	const SpeciesStyle &style = setup.styles[size_t(chunk.species)];
	std::vector<MotionPlant> plants;
	for (int slot = grown.first; slot < chunk.size(); slot++) {
		PlacedPlant plant = chunk.plants.plant(slot);
		plant.scale = chunk.is_gone(slot) ? 1.0f : plant.scale; // A removed plant needs a row, which is dropped below.
		plants.push_back(style.to_simulate(plant));
	}
	PageRows &own = rows[size_t(grown.chunk)];
	if (own.page < 0) {
		own.page = simulation->add_page(chunk.species, plants.data(), int(plants.size()));
	} else {
		simulation->add_to_page(own.page, plants.data(), int(plants.size()));
	}
	own.count = chunk.size();
	textures->give_rows(own.page, chunk.is_new ? chunk.room() : own.count);
	for (int slot = grown.first; slot < chunk.size(); slot++) {
		if (chunk.is_gone(slot)) {
			drop(own.page, slot);
		}
	}
	if (simulation->settings().prototypes > 0 && simulation->time() == 0.0) {
		simulation->step(); // Fills the history of the prototypes.
		textures->write_history(*simulation, true);
	}
	textures->write_page(*simulation, own.page);
	textures->write_beside(*simulation, own.page);
}

void CpuMotion::write_all() {
	textures->write_pages(*simulation);
	textures->write_history(*simulation, true);
}

bool CpuMotion::has_room_for_species() {
	wait();
	return textures->has_room_for_species();
}

void CpuMotion::add_species(const SpeciesStyle &style) {
	wait();
	simulation->add_species(style.motion);
	textures->give_history(*simulation);
	if (simulation->time() > 0.0) {
		textures->write_history_of(*simulation, simulation->species_count() - 1);
	}
}

int CpuMotion::modes_of_prototypes(int species) const {
	const Prototypes *models = simulation->prototypes(species);
	return models ? models->modes() : 0;
}

void CpuMotion::set_species(int index, const SpeciesStyle &style, const PlantStore &store, bool is_still) {
	wait();
	const int modes_before = modes_of_prototypes(index);
	simulation->set_species(index, style.motion);
	if (modes_of_prototypes(index) != modes_before) {
		textures->give_history(*simulation);
		textures->write_history(*simulation, true);
	}
	for (int number = 0; number < store.chunk_count(); number++) {
		const PlantChunk &chunk = store.chunk(number);
		if (chunk.size() == 0 || chunk.species != index) {
			continue;
		}
		std::vector<MotionPlant> plants;
		style.to_simulate(chunk.plants, plants);
		std::vector<glm::vec3> rests;
		for (const MotionPlant &plant : plants) {
			rests.push_back(plant.rest);
		}
		set_rests(rows_of(number), rests, is_still);
	}
	fit_contact(touches);
	if (is_still) {
		write_all();
	}
}

void CpuMotion::set_rests(const PageRows &own, const std::vector<glm::vec3> &rests, bool is_still) {
	static constexpr float STILL = 1e-3f; // rad, and 1/s.
	MotionPage &plants = simulation->page(own.page);
	std::vector<std::pair<int, glm::vec3>> at_rest;
	for (int i = own.first; is_still && plants.swings() && i < own.first + own.count; i++) {
		const TipState state = plants.state(i);
		if (glm::distance(state.direction, plants.rest(i)) < STILL && glm::length(state.rate) < STILL) {
			at_rest.emplace_back(i, plants.rest(i));
		}
	}
	simulation->set_rests(own.page, own.first, rests.data(), own.count);
	textures->write_beside(*simulation, own.page);
	for (const auto &[i, was] : at_rest) {
		if (plants.rest(i) == was) {
			continue; // With the same rest, the plant may be passing through it.
		}
		plants.set_state(i, { plants.rest(i), {} });
		plants.set_before(i, plants.rest(i));
	}
}

} // namespace undergrowth
