#include "stand/blocks.hpp"
#include "stand/kept_plants.hpp"
#include "test_placement_fixture.hpp"

#include <doctest/doctest.h>

#include <map>

using namespace undergrowth;

namespace {

struct Stand {
	double spacing;
	std::vector<PlantBlock> blocks;

	/// Numbers in a store that has no others: 7, 10, 13 ...
	std::vector<NumberedBlock> numbered() const {
		std::vector<NumberedBlock> all;
		for (const PlantBlock &block : blocks) {
			all.emplace_back(7 + 3 * static_cast<int>(all.size()), block);
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

std::map<PlantId, PlantPlace> names_of(const std::vector<NumberedBlock> &blocks, double spacing) {
	std::map<PlantId, PlantPlace> names;
	for (const auto &[number, block] : blocks) {
		for (int slot = 0; slot < block.size(); slot++) {
			if (!block.is_gone(slot)) {
				names[name_of(block, slot, spacing)] = { number, slot };
			}
		}
	}
	return names;
}

/// Checks that those are kept, from where and to where, whose names both have, and no other; tells their number.
int check_kept(const std::vector<NumberedBlock> &before, double old_spacing, const Stand &now) {
	std::map<PlantId, PlantPlace> names = names_of(before, old_spacing);
	const std::vector<KeptPlant> kept = find_kept(before, old_spacing, now.blocks, now.spacing);
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

TEST_CASE("who stands where it stood is kept, all of them") {
	const Stand stand = stand_of(square_field(20.0f, 3.0f, 5));
	CHECK(check_kept(stand.numbered(), stand.spacing, stand) == plants_of(stand));
	CHECK(plants_of(stand) > 1000);
}

TEST_CASE("plants are kept by their cells when tiles, sizes, seeds and species are others") {
	const PlacementRequest request = square_field(20.0f, 3.0f, 5);
	const Stand before = stand_of(request);
	CHECK(check_kept(before.numbered(), before.spacing, stand_of(request, 7.0f)) == plants_of(before));
	PlacementRequest other = request;
	other.seed = 6;
	CHECK(check_kept(before.numbered(), before.spacing, stand_of(other)) > 900);
	const Stand smaller = stand_of(square_field(10.0f, 3.0f, 5));
	CHECK(check_kept(before.numbered(), before.spacing, smaller) == plants_of(smaller));
	CHECK(check_kept(smaller.numbered(), smaller.spacing, before) == plants_of(smaller));
}

TEST_CASE("who is gone is not kept, though it grows again where it stood") {
	const Stand stand = stand_of(square_field(20.0f, 3.0f, 5));
	std::vector<NumberedBlock> before = stand.numbered();
	before[2].second.plants.scale[1] = 0.0f;
	before[2].second.gone = 1;
	CHECK(check_kept(before, stand.spacing, stand) == plants_of(stand) - 1);
}

TEST_CASE("another density has other names, also where a plant stands on the same spot") {
	const Stand stand = stand_of(square_field(20.0f, 3.0f, 5));
	Stand other = stand;
	other.spacing *= 0.8;
	const int kept = check_kept(stand.numbered(), stand.spacing, other);
	CHECK(kept < plants_of(stand));
}

TEST_CASE("a tile more or less changes nothing for the others") {
	const Stand stand = stand_of(square_field(20.0f, 3.0f, 5));
	Stand fewer = stand;
	fewer.blocks.pop_back();
	CHECK(check_kept(stand.numbered(), stand.spacing, fewer) == plants_of(fewer));
	CHECK(check_kept(fewer.numbered(), stand.spacing, stand) == plants_of(fewer));
	fewer = stand;
	fewer.blocks.erase(fewer.blocks.begin() + 1);
	CHECK(check_kept(stand.numbered(), stand.spacing, fewer) == plants_of(fewer));
	CHECK(find_kept({}, stand.spacing, stand.blocks, stand.spacing).empty());
	CHECK(find_kept(stand.numbered(), stand.spacing, {}, stand.spacing).empty());
}

TEST_CASE("a plant that moved along one axis only is told by its cell as well") {
	const Stand stand = stand_of(square_field(20.0f, 3.0f, 5));
	for (const bool along_x : { true, false }) {
		Stand moved = stand;
		FieldPlants &plants = moved.blocks[0].plants;
		(along_x ? plants.x : plants.z)[0] += static_cast<float>(4.0 * stand.spacing);
		const std::vector<KeptPlant> kept = find_kept(stand.numbered(), stand.spacing, moved.blocks, moved.spacing);
		CHECK(check_kept(stand.numbered(), stand.spacing, moved) == static_cast<int>(kept.size()));
		CHECK(kept.front().from.slot != kept.front().to.slot);
	}
}
