// The part of PlantField3D that makes patches of plants which were added, and puts them into pages.

#include "field/plant_field_3d.hpp"

#include <algorithm>
#include <map>
#include <tuple>

using namespace godot;

namespace undergrowth {

static constexpr int MOST_ADDED_PATCHES = 8;

// A page of the species that has room, or -1.
static int find_open_page(const FieldSimulation &simulation, int species) {
	for (int page = simulation.page_count() - 1; page >= 0; page--) {
		const MotionPage &plants = simulation.page(page);
		if (plants.species() == species && plants.size() < MotionPage::PAGE_PLANTS) {
			return page;
		}
	}
	return -1;
}

// Puts some plants of a patch, all of one species, into the page of their species that has room, and into new ones.
void PlantField3D::take_into_pages(FieldPatch &patch, int species_index, const std::vector<int> &members) {
	size_t done = 0;
	while (done < members.size()) {
		int page = find_open_page(*simulation, species_index);
		const int before = page >= 0 ? simulation->page(page).size() : 0;
		const size_t count = std::min(members.size() - done, size_t(MotionPage::PAGE_PLANTS - before));
		std::vector<MotionPlant> simulated;
		for (size_t i = done; i < done + count; i++) {
			simulated.push_back(style.looks[size_t(species_index)].to_simulate(patch.plants.plant(members[i])));
		}
		if (page >= 0) {
			simulation->add_to_page(page, simulated.data(), int(count));
		} else {
			page = simulation->add_page(species_index, simulated.data(), int(count));
		}
		for (size_t i = 0; i < count; i++) {
			const uint32_t index = uint32_t(before) + uint32_t(i);
			patch.places[size_t(members[done + i])] = uint32_t(page) * MotionPage::PAGE_PLANTS + index;
		}
		done += count;
	}
}

// Many small patches become one, so that planting here and there does not end in thousands of multimeshes.
void PlantField3D::merge_added() {
	if (int(patches.size()) - filled_patches <= MOST_ADDED_PATCHES) {
		return;
	}
	release_added_skeletons();
	FieldPlants all;
	std::vector<std::pair<float, uint32_t>> unsorted;
	for (size_t i = size_t(filled_patches); i < patches.size(); i++) {
		const FieldPatch &patch = *patches[i];
		for (int plant = 0; plant < patch.plants.size(); plant++) {
			if (patch.places[size_t(plant)] != FieldPatch::GONE) {
				all.add(patch.plants.plant(plant));
				unsorted.push_back({ all.x.back(), patch.places[size_t(plant)] });
			}
		}
	}
	patches.resize(size_t(filled_patches));
	drawings.resize(size_t(filled_patches));
	const std::vector<float> reach = reaches(style);
	auto merged = std::make_unique<FieldPatch>();
	merged->plants = std::move(all);
	// The order of sorting is not told: a plant is found again by where its page says that it stands.
	merged->chunks = sort_into_chunks(merged->plants, float(options.chunk_size), reach.data(), int(reach.size()));
	std::map<std::tuple<float, float, float, int>, std::vector<uint32_t>> by_root;
	for (const auto &[x, place] : unsorted) {
		const MotionPage &page = simulation->page(int(place / MotionPage::PAGE_PLANTS));
		const glm::vec3 root = page.root(int(place % MotionPage::PAGE_PLANTS));
		by_root[{ root.x, root.y, root.z, page.species() }].push_back(place);
	}
	for (int plant = 0; plant < merged->plants.size(); plant++) {
		const PlacedPlant placed = merged->plants.plant(plant);
		std::vector<uint32_t> &there = by_root[{ placed.root.x, placed.root.y, placed.root.z, placed.species }];
		merged->places.push_back(there.back());
		there.pop_back();
	}
	drawings.push_back(std::make_unique<FieldDrawing>());
	restart_drawing(*drawings.back());
	drawings.back()->show(style, FieldDrawing::plan(style, *merged));
	patches.push_back(std::move(merged));
}

// Plants that were added since the last frame become a patch of their own.
void PlantField3D::flush_pending() {
	if (pending.empty() || !is_inside_tree()) {
		return;
	}
	finish_step();
	auto patch = std::make_unique<FieldPatch>();
	for (const Pending &group : pending) {
		const int species_index = species_for(group.function);
		for (PlacedPlant plant : group.plants) {
			plant.species = species_index;
			plant.variant %= options.variants;
			patch->plants.add(plant);
		}
	}
	pending.clear();
	const std::vector<float> reach = reaches(style);
	patch->chunks = sort_into_chunks(patch->plants, float(options.chunk_size), reach.data(), int(reach.size()));
	patch->places.assign(size_t(patch->plants.size()), FieldPatch::GONE);
	std::vector<std::vector<int>> members(style.looks.size());
	for (int plant = 0; plant < patch->plants.size(); plant++) {
		members[patch->plants.species[size_t(plant)]].push_back(plant);
	}
	for (int kind = 0; kind < int(members.size()); kind++) {
		take_into_pages(*patch, kind, members[size_t(kind)]);
	}
	show_bends();
	drawings.push_back(std::make_unique<FieldDrawing>());
	restart_drawing(*drawings.back());
	drawings.back()->show(style, FieldDrawing::plan(style, *patch));
	patches.push_back(std::move(patch));
	merge_added();
	if (options.contact) {
		touching.fit(*simulation);
	}
	upload();
	update_processing();
}

// After pages came or grew: into the textures that there are, or larger ones.
void PlantField3D::show_bends() {
	if (simulation->settings().prototypes > 0 && simulation->time() == 0.0) {
		simulation->step(); // It fills the prototypes' history.
	}
	if (!bends || !bends->has_room(*simulation)) {
		bends = std::make_unique<FieldBends>();
		bends->make_images(*simulation);
		hide_shown();
		bends->make_textures();
	} else {
		for (int page = 0; page < simulation->page_count(); page++) {
			bends->write_page(*simulation, page);
		}
	}
	dress();
}

} // namespace undergrowth
