#include "field/motion/prepared_motion.hpp"

#include <algorithm>
#include <utility>

namespace undergrowth {

// Adds the chunks page by page; several chunks may share a page.
void PreparedMotion::add_pages(const std::vector<PlantChunk> &chunks, const FieldRenderSetup &setup) {
	std::vector<std::vector<size_t>> members;
	for (size_t i = 0; i < chunks.size(); i++) {
		members.resize(std::max(members.size(), size_t(rows[i].page) + 1));
		members[size_t(rows[i].page)].push_back(i);
	}
	std::vector<MotionPlant> plants;
	for (const std::vector<size_t> &of_page : members) {
		plants.clear();
		for (const size_t i : of_page) {
			setup.styles[size_t(chunks[i].species)].to_simulate(chunks[i].plants, plants);
		}
		const int species = chunks[of_page.front()].species;
		const int page = simulation->add_page(species, plants.data(), int(plants.size()));
		// Pages of a layer are uploaded together, so they step together.
		simulation->set_page_phase(page, textures->layer_of(page));
	}
}

void PreparedMotion::transfer_motion(
		const FieldSimulation *old, const std::vector<PageRows> &old_rows, const std::vector<PlantMatch> &matches) {
	for (size_t i = 0; old && i < matches.size(); i++) {
		const PlantRef &was = matches[i].from;
		const PageRows from = size_t(was.chunk) < old_rows.size() ? old_rows[size_t(was.chunk)] : PageRows();
		if (from.page < 0 || was.slot >= from.count) {
			continue;
		}
		const PageRows &into = rows[size_t(matches[i].to.chunk)];
		const int row = into.first + matches[i].to.slot;
		// Another chunk may have the number now, so the position identifies the plant.
		const glm::vec3 before = old->page(from.page).root(from.first + was.slot);
		const glm::vec3 now = simulation->page(into.page).root(row);
		if (before.x == now.x && before.z == now.z) {
			simulation->transfer_motion(into.page, row, *old, from.page, from.first + was.slot);
		}
	}
}

void PreparedMotion::build(const std::vector<PlantChunk> &chunks, const FieldRenderSetup &setup) {
	add_pages(chunks, setup);
	textures->give_history(*simulation);
	if (textures->follows()) {
		simulation->step(); // Fills the history of the prototypes.
		textures->write_history(*simulation, true);
	}
	textures->write_pages(*simulation);
	for (int page = 0; page < simulation->page_count(); page++) {
		textures->write_beside(*simulation, page);
	}
}

static std::vector<MotionPlant> plants_of(const PlantChunk &chunk, const SpeciesStyle &style) {
	std::vector<MotionPlant> plants;
	style.to_simulate(chunk.plants, plants);
	return plants;
}

PreparedChunk::PreparedChunk(const PlantChunk &chunk, const FieldRenderSetup &setup, const FieldSettings &settings) :
		PreparedChunk(chunk.species, setup.styles[size_t(chunk.species)].motion,
				plants_of(chunk, setup.styles[size_t(chunk.species)]), settings) {}

PreparedChunk::PreparedChunk(
		int species, const MotionSpecies &kind, std::vector<MotionPlant> &&placed, const FieldSettings &settings) :
		page(species, kind, placed.data(), int(placed.size()), settings.step * float(settings.update_interval),
				settings.prototypes <= 0),
		plants(std::move(placed)) {}

PreparedMotion::PreparedMotion(const std::vector<PlantChunk> &chunks, const FieldRenderSetup &setup,
		const FieldSettings &settings, const FieldWind &wind) :
		simulation(std::make_unique<FieldSimulation>(settings)),
		textures(std::make_unique<PoseTexture>(settings.prototypes > 0)),
		rows(join_into_pages(chunks)) {
	simulation->set_wind(wind);
	for (const SpeciesStyle &style : setup.styles) {
		simulation->add_species(style.motion);
	}
	std::vector<int> plants;
	for (const PageRows &own : rows) {
		plants.resize(std::max(plants.size(), size_t(own.page) + 1));
		plants[size_t(own.page)] += own.count;
	}
	for (size_t page = 0; page < plants.size(); page++) {
		textures->give_rows(int(page), plants[page]);
	}
}

} // namespace undergrowth
