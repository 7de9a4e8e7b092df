#include "stand/blocks.hpp"
#include "stand/kept_plants.hpp"
#include "test_placement_fixture.hpp"

#include <doctest/doctest.h>

#include <map>
#include <utility>

using namespace undergrowth;

namespace {

constexpr float DENSITY = 4.0f;
constexpr double SPACING = 0.5; // m: 1/sqrt(DENSITY).

PlantStore filled_store(const PlacementRequest &request, float tile_size) {
	StandEdit edit;
	edit.fills = true;
	edit.filled = cut_into_blocks(placed(request), tile_size);
	edit.tile_size = tile_size;
	edit.spacing = SPACING;
	PlantStore store;
	store.apply(std::move(edit));
	return store;
}

struct Stand {
	double spacing;
	std::vector<PlantBlock> blocks;

	/// Block numbers of a store without other blocks: 7, 10, 13 ...
	FilledBlocks numbered() const {
		FilledBlocks all;
		all.spacing = spacing;
		for (const PlantBlock &block : blocks) {
			all.blocks.emplace_back(7 + 3 * static_cast<int>(all.blocks.size()), block);
			all.blocks.back().second.spacing = spacing;
		}
		return all;
	}
};

Stand stand_of(const PlacementRequest &request, float tile = 5.0f) {
	return { Placement(request).cell_size(), cut_into_blocks(placed(request), tile) };
}

PlantId name_of(const PlantBlock &block, int slot, double spacing) {
	return filled_plant_id(block.root(slot).x, block.root(slot).z, spacing);
}

std::map<PlantId, PlantPlace> names_of(const FilledBlocks &filled) {
	std::map<PlantId, PlantPlace> names;
	for (const auto &[number, block] : filled.blocks) {
		for (int slot = 0; slot < block.size(); slot++) {
			if (!block.is_gone(slot)) {
				names[name_of(block, slot, filled.spacing)] = { number, slot };
			}
		}
	}
	return names;
}

/// Checks that exactly the plants with ids in both lists are transferred, with their locations. Returns their number.
int check_kept(const FilledBlocks &before, const Stand &now) {
	std::map<PlantId, PlantPlace> names = names_of(before);
	const std::vector<KeptPlant> kept = find_kept(before, now.blocks, now.spacing);
	std::size_t next = 0;
	for (std::size_t i = 0; i < now.blocks.size(); i++) {
		for (int slot = 0; slot < now.blocks[i].size(); slot++) {
			const auto found = names.find(name_of(now.blocks[i], slot, now.spacing));
			if (found == names.end()) {
				continue;
			}
			REQUIRE(next < kept.size());
			CHECK(kept[next].to.block == static_cast<int>(i));
			CHECK(kept[next].to.slot == slot);
			CHECK(kept[next].from.block == found->second.block);
			CHECK(kept[next].from.slot == found->second.slot);
			next++;
		}
	}
	CHECK(next == kept.size());
	return static_cast<int>(kept.size());
}

int plants_of(const Stand &stand) {
	int count = 0;
	for (const PlantBlock &block : stand.blocks) {
		count += block.size();
	}
	return count;
}

} // namespace

TEST_CASE("all plants at unchanged positions are transferred") {
	const Stand stand = stand_of(square_field(20.0f, 3.0f, 5));
	CHECK(check_kept(stand.numbered(), stand) == plants_of(stand));
	CHECK(plants_of(stand) > 1000);
}

TEST_CASE("plants are matched by their cells across other tiles, sizes, seeds and species") {
	const PlacementRequest request = square_field(20.0f, 3.0f, 5);
	const Stand before = stand_of(request);
	CHECK(check_kept(before.numbered(), stand_of(request, 7.0f)) == plants_of(before));
	PlacementRequest other = request;
	other.seed = 6;
	CHECK(check_kept(before.numbered(), stand_of(other)) > 900);
	const Stand smaller = stand_of(square_field(10.0f, 3.0f, 5));
	CHECK(check_kept(before.numbered(), smaller) == plants_of(smaller));
	CHECK(check_kept(smaller.numbered(), before) == plants_of(smaller));
}

TEST_CASE("plants outside of the previous area are not transferred") {
	for (const float side : { 15.5f, 16.0f, 31.0f, 64.0f }) { // Cells of 0.5 m: around powers of two.
		const Stand before = stand_of(square_field(side, DENSITY, 3));
		for (const float more : { 1.0f, 2.0f * side }) {
			const Stand now = stand_of(square_field(side + more, DENSITY, 3));
			CHECK(check_kept(before.numbered(), now) == plants_of(before));
			CHECK(check_kept(now.numbered(), before) == plants_of(before));
		}
	}
}

TEST_CASE("plants are transferred in narrow, slanting and distant areas") {
	constexpr float FAR = 3000.0f;
	const Polygon narrow = { { -400.0f, 0.0f }, { 400.0f, 0.0f }, { 400.0f, 1.5f }, { -400.0f, 1.5f } };
	const Polygon slanting = { { 0.0f, 0.0f }, { 300.0f, 300.0f }, { 300.0f, 302.0f }, { 0.0f, 2.0f } };
	const Polygon two = { { 0.0f, 0.0f }, { 9.0f, 0.0f }, { 9.0f, 8.9f }, { FAR, FAR }, { FAR, FAR + 9.0f },
		{ FAR - 9.0f, FAR }, { 8.9f, 9.0f }, { 0.0f, 9.0f } };
	for (const Polygon &area : { narrow, slanting, two }) {
		PlacementRequest request = square_field(1.0f, DENSITY, 3);
		request.area = area;
		const Stand before = stand_of(request, 16.0f);
		CHECK(plants_of(before) > 300);
		CHECK(check_kept(before.numbered(), stand_of(request, 11.0f)) == plants_of(before));
		request.seed++;
		CHECK(check_kept(before.numbered(), stand_of(request)) > plants_of(before) * 2 / 3);
	}
}

TEST_CASE("a removed plant is not transferred when it grows again at its position") {
	const Stand stand = stand_of(square_field(20.0f, 3.0f, 5));
	FilledBlocks before = stand.numbered();
	before.blocks[2].second.plants.scale[1] = 0.0f;
	before.blocks[2].second.gone = 1;
	CHECK(check_kept(before, stand) == plants_of(stand) - 1);
}

TEST_CASE("another density has other ids, even for plants at the same position") {
	const Stand stand = stand_of(square_field(20.0f, 3.0f, 5));
	Stand other = stand;
	other.spacing *= 0.8;
	CHECK(check_kept(stand.numbered(), other) == 0);
}

TEST_CASE("adding or removing a tile does not affect other tiles") {
	const Stand stand = stand_of(square_field(20.0f, 3.0f, 5));
	Stand fewer = stand;
	fewer.blocks.pop_back();
	CHECK(check_kept(stand.numbered(), fewer) == plants_of(fewer));
	CHECK(check_kept(fewer.numbered(), stand) == plants_of(fewer));
	fewer = stand;
	fewer.blocks.erase(fewer.blocks.begin() + 1);
	CHECK(check_kept(stand.numbered(), fewer) == plants_of(fewer));
	CHECK(find_kept(FilledBlocks(), stand.blocks, stand.spacing).empty());
	CHECK(find_kept(stand.numbered(), {}, stand.spacing).empty());
}

TEST_CASE("a plant that moved along one axis only is also matched by its cell") {
	const Stand stand = stand_of(square_field(20.0f, 3.0f, 5));
	for (const bool along_x : { true, false }) {
		Stand moved = stand;
		FieldPlants &plants = moved.blocks[0].plants;
		(along_x ? plants.x : plants.z)[0] += static_cast<float>(4.0 * stand.spacing);
		const std::vector<KeptPlant> kept = find_kept(stand.numbered(), moved.blocks, moved.spacing);
		CHECK(check_kept(stand.numbered(), moved) == static_cast<int>(kept.size()));
		CHECK(kept.front().from.slot != kept.front().to.slot);
	}
}

TEST_CASE("a rebuild of styles gathers all plants except added ones, removed ones and those of dropped species") {
	PlantStore store = filled_store(square_field(20.0f, DENSITY, 3), 8.0f);
	store.apply([] {
		StandEdit edit;
		edit.added = { PlacedPlant() };
		return edit;
	}());
	const PlantPlace gone = { 0, 0 };
	StandEdit edit;
	edit.removed = { gone };
	store.apply(std::move(edit));
	int expected = 0;
	for (int number = 0; number < store.block_count(); number++) {
		const PlantBlock &block = store.block(number);
		expected += block.is_added || block.species == 1 ? 0 : block.standing();
	}
	const FieldPlants plants = gather_plants(copy_filled(store), { 1, -1, 0 });
	CHECK(plants.size() == expected);
	for (const uint8_t species : plants.species) {
		CHECK(species <= 1);
	}
}

TEST_CASE("the existing plants of a list of ids are found, in its order") {
	const PlantStore store = filled_store(square_field(10.0f, DENSITY, 1), 8.0f);
	const std::vector<PlantId> ids = store.ids();
	const std::vector<PlantPlace> found = store.find_all({ ids[3], NO_PLANT, ids[1] });
	REQUIRE(found.size() == 2);
	CHECK(store.id(found[0]) == ids[3]);
	CHECK(store.id(found[1]) == ids[1]);
}
