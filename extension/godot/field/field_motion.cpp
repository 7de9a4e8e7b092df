// How FieldMotion follows what stands, and what it is asked. field_motion_steps.cpp moves it.

#include "field/field_motion.hpp"

#include "plant_simulation.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr double USUAL_STEP = 1.0 / 60.0; // s.

FieldMotion::FieldMotion() : clock(USUAL_STEP) {}

FieldMotion::~FieldMotion() {
	wait();
}

void FieldMotion::wait() {
	steps.wait();
}

void FieldMotion::start(const FieldSettings &settings) {
	wait();
	simulation = std::make_unique<FieldSimulation>(settings);
	textures = std::make_unique<PoseTexture>(settings.prototypes > 0);
	pages.clear();
	block_of_page.clear();
	clock = FixedStep(PlantSimulation::get_singleton()->get_step_length());
	seen_wind_time = -1.0;
}

void FieldMotion::adopt(
		FieldResult &result, const ChangeSet &changes, const PlantStore &store, const FieldStyle &style) {
	wait();
	const std::unique_ptr<FieldSimulation> old = std::move(simulation);
	const std::vector<int> old_pages = std::move(pages);
	simulation = std::move(result.simulation);
	textures = std::move(result.poses);
	pages.assign(size_t(store.block_count()), -1);
	block_of_page.clear();
	std::vector<int> numbers;
	for (size_t i = 0; i < size_t(simulation->page_count()); i++) {
		numbers.push_back(changes.grown[i].block);
		give_page(numbers.back(), int(i));
	}
	textures->renumber(numbers);
	for (int i = 0; i < int(style.looks.size()); i++) {
		simulation->set_species(i, style.looks[size_t(i)].motion);
	}
	if (old) {
		keep_states(result, changes, store, *old, old_pages);
	}
	take_added(store, style, old.get(), old_pages);
	write_all();
	clock = FixedStep(PlantSimulation::get_singleton()->get_step_length());
	seen_wind_time = -1.0;
	fit_contact(touches);
}

void FieldMotion::keep_states(const FieldResult &result, const ChangeSet &changes, const PlantStore &store,
		FieldSimulation &old, const std::vector<int> &old_pages) {
	for (const KeptPlant &kept : result.kept) {
		const size_t before = size_t(kept.from.block);
		const int old_page = before < old_pages.size() ? old_pages[before] : -1;
		const int block = changes.grown[size_t(kept.to.block)].block;
		MotionPage &now = simulation->page(page_of(block));
		if (old_page < 0 || kept.from.slot >= old.page(old_page).size()) {
			continue;
		}
		// The number of a block may have gone to another one meanwhile: a plant is known by where it stands.
		const glm::vec3 was = old.page(old_page).root(kept.from.slot);
		const glm::vec3 is = store.block(block).root(kept.to.slot);
		if (was.x == is.x && was.z == is.z) {
			now.take_motion(kept.to.slot, old.page(old_page), kept.from.slot);
		}
	}
}

// Plants that code added outlive a new filling, and so does their motion.
void FieldMotion::take_added(const PlantStore &store, const FieldStyle &style, const FieldSimulation *old,
		const std::vector<int> &old_pages) {
	for (int block = 0; block < store.block_count(); block++) {
		if (!store.block(block).is_added) {
			continue;
		}
		grow({ block, 0 }, store, style);
		const int old_page = size_t(block) < old_pages.size() ? old_pages[size_t(block)] : -1;
		MotionPage &now = simulation->page(page_of(block));
		for (int slot = 0; old && old_page >= 0 && slot < now.size(); slot++) {
			const MotionPage &before = old->page(old_page);
			if (slot < before.size() && !now.is_gone(slot) && before.root(slot) == now.root(slot)) {
				now.take_motion(slot, before, slot);
			}
		}
	}
}

void FieldMotion::apply(const ChangeSet &changes, const PlantStore &store, const FieldStyle &style) {
	wait();
	pages.resize(size_t(store.block_count()), -1);
	for (const int block : changes.dropped) {
		drop_page(block);
		textures->take_rows(block);
	}
	for (const ChangeSet::Grown &grown : changes.grown) {
		grow(grown, store, style);
	}
	for (const PlantPlace &place : changes.gone) {
		simulation->drop(page_of(place.block), place.slot);
		textures->hide(place.block, place.slot);
		if (simulation->page(page_of(place.block)).standing() == 0) {
			drop_page(place.block);
		}
	}
	textures->write_history(*simulation, false);
	fit_contact(touches);
}

void FieldMotion::give_page(int block, int page) {
	pages[size_t(block)] = page;
	block_of_page.resize(std::max(block_of_page.size(), size_t(page) + 1), -1);
	block_of_page[size_t(page)] = block;
}

void FieldMotion::drop_page(int block) {
	int &page = pages[size_t(block)];
	if (page >= 0) {
		simulation->remove_page(page);
		block_of_page[size_t(page)] = -1;
		page = -1;
	}
}

void FieldMotion::grow(const ChangeSet::Grown &grown, const PlantStore &store, const FieldStyle &style) {
	const PlantBlock &block = store.block(grown.block);
	const FieldLook &look = style.looks[size_t(block.species)];
	std::vector<MotionPlant> plants;
	for (int slot = grown.first; slot < block.size(); slot++) {
		PlacedPlant plant = block.plants.plant(slot);
		plant.scale = block.is_gone(slot) ? 1.0f : plant.scale; // Its row has to be there, and is dropped at once.
		plants.push_back(look.to_simulate(plant));
	}
	if (page_of(grown.block) < 0) {
		give_page(grown.block, simulation->add_page(block.species, plants.data(), int(plants.size())));
	} else {
		simulation->add_to_page(page_of(grown.block), plants.data(), int(plants.size()));
	}
	textures->give_rows(grown.block, block.size());
	for (int slot = grown.first; slot < block.size(); slot++) {
		if (block.is_gone(slot)) {
			simulation->drop(page_of(grown.block), slot);
			textures->hide(grown.block, slot);
		}
	}
	if (simulation->settings().prototypes > 0 && simulation->time() == 0.0) {
		simulation->step(); // It fills the prototypes' history.
		textures->write_history(*simulation, true);
	}
	textures->write_block(*simulation, page_of(grown.block), grown.block);
}

void FieldMotion::write_all() {
	for (size_t block = 0; block < pages.size(); block++) {
		if (pages[block] >= 0) {
			textures->write_block(*simulation, pages[block], int(block));
		}
	}
	textures->write_history(*simulation, true);
}

void FieldMotion::add_species(const FieldLook &look) {
	wait();
	simulation->add_species(look.motion);
	textures->give_history(simulation->species_count());
	if (simulation->time() > 0.0) {
		textures->write_history(*simulation, true);
	}
}

void FieldMotion::set_species(int index, const FieldLook &look, const PlantStore &store, bool is_still) {
	wait();
	simulation->set_species(index, look.motion);
	for (int block = 0; block < store.block_count(); block++) {
		const PlantBlock &plants = store.block(block);
		if (plants.size() == 0 || plants.species != index || page_of(block) < 0) {
			continue;
		}
		std::vector<glm::vec3> rests;
		for (int slot = 0; slot < plants.size(); slot++) {
			rests.push_back(look.to_simulate(plants.plants.plant(slot)).rest);
		}
		set_rests(page_of(block), rests, is_still);
	}
	fit_contact(touches);
}

void FieldMotion::set_rests(int page, const std::vector<glm::vec3> &rests, bool is_still) {
	static constexpr float STILL = 1e-3f; // rad, and 1/s.
	MotionPage &plants = simulation->page(page);
	std::vector<std::pair<int, glm::vec3>> at_rest;
	for (int i = 0; is_still && plants.swings() && i < plants.size(); i++) {
		const TipState state = plants.state(i);
		if (glm::distance(state.direction, plants.rest(i)) < STILL && glm::length(state.rate) < STILL) {
			at_rest.emplace_back(i, plants.rest(i));
		}
	}
	simulation->set_rests(page, rests.data());
	for (const auto &[i, was] : at_rest) {
		if (plants.rest(i) == was) {
			continue; // It may only pass there, of another mass than before.
		}
		plants.set_state(i, { plants.rest(i), {} });
		plants.set_before(i, plants.rest(i));
	}
}

void FieldMotion::set_update_interval(int step_count) {
	if (simulation) {
		wait();
		simulation->set_update_interval(step_count);
	}
}

void FieldMotion::fit_contact(bool on) {
	touches = on;
	if (on && simulation) {
		wait();
		touching.fit(*simulation);
	}
}

void FieldMotion::settle() {
	wait();
	simulation->settle();
	write_all();
}

TipState FieldMotion::read_state_now(const PlantPlace &place) {
	wait();
	return simulation->state(page_of(place.block), place.slot);
}

void FieldMotion::write_state(const PlantPlace &place, const TipState &state) {
	wait();
	simulation->page(page_of(place.block)).set_state(place.slot, state);
}

void FieldMotion::apply_impulse(const PlantPlace &place, const glm::vec3 &impulse) {
	wait();
	simulation->apply_impulse(page_of(place.block), place.slot, impulse);
}

bool FieldMotion::is_point_in_plants_now(const glm::vec3 &point, float margin) {
	wait();
	return simulation && simulation->is_point_in_plants(point, margin);
}

void FieldMotion::set_hidden(const PlantPlace &place, bool hidden) {
	if (hidden) {
		textures->hide(place.block, place.slot);
	} else {
		textures->show(place.block, place.slot);
		stale_blocks.push_back(place.block);
	}
}

} // namespace undergrowth
