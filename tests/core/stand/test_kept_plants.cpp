#include "stand/kept_plants.hpp"
#include "test_placement_fixture.hpp"

#include <doctest/doctest.h>

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

/// Checks that pairs are the same plants, each once.
void check_pairs(const std::vector<KeptPlant> &kept, const PlantStore &store, const std::vector<PlantBlock> &now) {
	for (const KeptPlant &pair : kept) {
		const PlantBlock &block = now[static_cast<std::size_t>(pair.to.block)];
		REQUIRE(store.block(pair.from.block).root(pair.from.slot) == block.root(pair.to.slot));
	}
}

} // namespace

TEST_CASE("all plants of a field that is filled with the same again are kept") {
	const PlacementRequest request = square_field(30.0f, DENSITY, 2);
	const PlantStore store = filled_store(request, 8.0f);
	const std::vector<PlantBlock> now = cut_into_blocks(placed(request), 8.0f);
	const std::vector<KeptPlant> kept = find_kept(copy_filled(store), now, SPACING);
	CHECK(static_cast<int>(kept.size()) == store.plant_count());
	check_pairs(kept, store, now);
}

TEST_CASE("plants are known again in other tiles and within a smaller outline, but for those that were removed") {
	PlantStore store = filled_store(square_field(30.0f, DENSITY, 2), 8.0f);
	StandEdit mowing;
	store.find_in_sphere({ 0.0f, 0.0f, 0.0f }, 3.0f, mowing.removed);
	const auto mown = static_cast<int>(mowing.removed.size());
	REQUIRE(mown > 0);
	store.apply(std::move(mowing));
	const FieldPlants fewer = placed(square_field(20.0f, DENSITY, 2));
	const std::vector<PlantBlock> now = cut_into_blocks(fewer, 5.0f);
	const std::vector<KeptPlant> kept = find_kept(copy_filled(store), now, SPACING);
	CHECK(static_cast<int>(kept.size()) == fewer.size() - mown);
	check_pairs(kept, store, now);
}

TEST_CASE("nobody is kept where plants stand at another spacing") {
	const PlacementRequest request = square_field(30.0f, DENSITY, 1);
	const PlantStore store = filled_store(request, 8.0f);
	const std::vector<PlantBlock> now = cut_into_blocks(placed(square_field(30.0f, 1.0f, 1)), 8.0f);
	CHECK(find_kept(copy_filled(store), {}, SPACING).empty());
	CHECK(find_kept(FilledBlocks(), now, 1.0).empty());
}

TEST_CASE("what is dressed anew stands as it stood, without species that are no more and without the removed") {
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

TEST_CASE("of names, those that stand are found, in their order") {
	const PlantStore store = filled_store(square_field(10.0f, DENSITY, 1), 8.0f);
	const std::vector<PlantId> ids = store.ids();
	const std::vector<PlantPlace> found = store.find_all({ ids[3], NO_PLANT, ids[1] });
	REQUIRE(found.size() == 2);
	CHECK(store.id(found[0]) == ids[3]);
	CHECK(store.id(found[1]) == ids[1]);
}
