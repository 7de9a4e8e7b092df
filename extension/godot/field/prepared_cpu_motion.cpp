#include "field/prepared_cpu_motion.hpp"

#include <algorithm>
#include <utility>

namespace undergrowth {

// Adds the blocks page by page; several blocks may share a page.
static void add_pages(const std::vector<PlantBlock> &blocks, const FieldStyle &style, PreparedCpuMotion &into) {
	std::vector<std::vector<size_t>> members;
	for (size_t i = 0; i < blocks.size(); i++) {
		members.resize(std::max(members.size(), size_t(into.rows[i].page) + 1));
		members[size_t(into.rows[i].page)].push_back(i);
	}
	std::vector<MotionPlant> plants;
	for (const std::vector<size_t> &of_page : members) {
		plants.clear();
		for (const size_t i : of_page) {
			style.looks[size_t(blocks[i].species)].to_simulate(blocks[i].plants, plants);
		}
		const int species = blocks[of_page.front()].species;
		const int page = into.simulation->add_page(species, plants.data(), int(plants.size()));
		// Pages of a layer are uploaded together, so they step together.
		into.simulation->set_page_phase(page, into.textures->layer_of(page));
	}
}

void PreparedCpuMotion::keep_motion(
		const FieldSimulation *old, const std::vector<PageRows> &old_rows, const std::vector<KeptPlant> &kept) {
	for (size_t i = 0; old && i < kept.size(); i++) {
		const PlantPlace &was = kept[i].from;
		const PageRows from = size_t(was.block) < old_rows.size() ? old_rows[size_t(was.block)] : PageRows();
		if (from.page < 0 || was.slot >= from.count) {
			continue;
		}
		const PageRows &into = rows[size_t(kept[i].to.block)];
		const int row = into.first + kept[i].to.slot;
		// Another block may have the number now, so the position identifies the plant.
		const glm::vec3 before = old->page(from.page).root(from.first + was.slot);
		const glm::vec3 now = simulation->page(into.page).root(row);
		if (before.x == now.x && before.z == now.z) {
			simulation->take_motion(into.page, row, *old, from.page, from.first + was.slot);
		}
	}
}

void PreparedCpuMotion::fill(const std::vector<PlantBlock> &blocks, const FieldStyle &style) {
	add_pages(blocks, style, *this);
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

PreparedCpuBlock::PreparedCpuBlock(
		int species, const MotionSpecies &kind, std::vector<MotionPlant> &&placed, const FieldSettings &settings) :
		page(species, kind, placed.data(), int(placed.size()), settings.step * float(settings.update_interval),
				settings.prototypes <= 0),
		plants(std::move(placed)) {}

std::unique_ptr<PreparedBlock> prepare_block_on_cpu(
		const PlantBlock &block, const FieldStyle &style, const FieldSettings &settings) {
	const FieldLook &look = style.looks[size_t(block.species)];
	std::vector<MotionPlant> plants;
	look.to_simulate(block.plants, plants);
	return std::make_unique<PreparedCpuBlock>(block.species, look.motion, std::move(plants), settings);
}

std::unique_ptr<PreparedMotion> prepare_on_cpu(const std::vector<PlantBlock> &blocks, const FieldStyle &style,
		const FieldSettings &settings, const FieldWind &wind) {
	auto made = std::make_unique<PreparedCpuMotion>();
	made->simulation = std::make_unique<FieldSimulation>(settings);
	made->simulation->set_wind(wind);
	for (const FieldLook &look : style.looks) {
		made->simulation->add_species(look.motion);
	}
	made->textures = std::make_unique<PoseTexture>(settings.prototypes > 0);
	made->rows = join_into_pages(blocks);
	std::vector<int> plants;
	for (const PageRows &own : made->rows) {
		plants.resize(std::max(plants.size(), size_t(own.page) + 1));
		plants[size_t(own.page)] += own.count;
	}
	for (size_t page = 0; page < plants.size(); page++) {
		made->textures->give_rows(int(page), plants[page]);
	}
	return made;
}

} // namespace undergrowth
