#include "placement/test_plant_store_fixture.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>
#include <vector>

using namespace undergrowth;

TEST_CASE("every plant has a unique id and is found by it") {
	const PlantStore store = filled_store();
	CHECK(store.plant_count() > 9000);
	CHECK(static_cast<int>(id_set(store).size()) == store.plant_count());
	for (int number = 0; number < store.chunk_count(); number++) {
		for (int slot = 0; slot < store.chunk(number).size(); slot++) {
			const PlantRef place = { number, slot };
			CHECK(store.find(store.id(place)) == place);
		}
	}
}

TEST_CASE("ids are the same after a rebuild with other tiles or another outline") {
	PlantStore store = filled_store();
	const std::set<PlantId> before = id_set(store);
	store.apply(replacing(square_field(50.0f, 4.0f, 2), 7.0f));
	CHECK(id_set(store) == before);
	store.apply(replacing(square_field(30.0f, 4.0f, 2)));
	const std::set<PlantId> fewer = id_set(store);
	CHECK(fewer.size() < before.size());
	CHECK(std::includes(before.begin(), before.end(), fewer.begin(), fewer.end()));
}

/// An edit that builds a tile of filled_store() again.
static StoreEdit tile_again(const TileKey &tile) {
	PlacementRequest request = square_field(50.0f, 4.0f, 2);
	request.within = tile_box(tile, 16.0f);
	StoreEdit edit;
	edit.left_tiles = { tile };
	edit.spacing = SPACING;
	edit.arriving = cut_into_chunks(placed(request), 16.0f);
	return edit;
}

TEST_CASE("the order of ids does not depend on the order in which tiles are built") {
	PlantStore store = filled_store();
	const std::vector<PlantId> ids = store.ids();
	const std::vector<TileKey> all = store.generated_tiles();
	StoreEdit clearing;
	clearing.left_tiles = all;
	store.apply(std::move(clearing));
	REQUIRE(store.plant_count() == 0);
	for (auto tile = all.rbegin(); tile != all.rend(); ++tile) {
		store.apply(tile_again(*tile));
	}
	CHECK(store.ids() == ids);
}

TEST_CASE("ids of added plants follow those of the field") {
	PlantStore store = filled_store();
	std::vector<PlantId> ids = store.ids();
	StoreEdit edit;
	edit.added = { plant_at(-20.0f, -20.0f) };
	ids.push_back(store.apply(std::move(edit)).added.at(0));
	CHECK(store.ids() == ids);
}

TEST_CASE("cells give ids at all densities, also far from the origin") {
	for (const float density : { 0.01f, 1.0f, 40.0f, 2000.0f }) {
		const double spacing = 1.0 / std::sqrt(static_cast<double>(density));
		PlacementRequest request = square_field(static_cast<float>(30.0 * spacing), density, 5);
		for (glm::vec2 &point : request.area) {
			point += glm::vec2(-400.0f, 700.0f);
		}
		PlantStore store;
		store.apply(replacing(request));
		CHECK(static_cast<int>(id_set(store).size()) == store.plant_count());
		for (const PlantId id : store.ids()) {
			CHECK(store.find(id).chunk >= 0);
		}
	}
}

TEST_CASE("removing a plant removes only that plant") {
	PlantStore store = filled_store();
	std::set<PlantId> left = id_set(store);
	std::vector<PlantRef> around;
	store.find_in_sphere({ 5.0f, 0.0f, 5.0f }, 3.0f, around);
	REQUIRE(around.size() > 50);
	const PlantRef other = { 0, 0 };
	const PlantId other_id = store.id(other);
	std::vector<PlantId> gone;
	for (const PlantRef &place : around) {
		gone.push_back(store.id(place));
		left.erase(gone.back());
	}
	const int before = store.plant_count();
	StoreEdit edit;
	edit.removed = around;
	const ChangeSet changes = store.apply(std::move(edit));
	CHECK(changes.gone.size() == around.size());
	CHECK(changes.grown.empty());
	CHECK(store.plant_count() == before - static_cast<int>(around.size()));
	CHECK(id_set(store) == left);
	CHECK(store.id(other) == other_id);
	for (const PlantId id : gone) {
		CHECK(store.find(id).chunk < 0);
	}
	around.clear();
	store.find_in_sphere({ 5.0f, 0.0f, 5.0f }, 3.0f, around);
	CHECK(around.empty());
}

TEST_CASE("chunks for other threads do not change with the store") {
	PlantStore store = filled_store();
	const PlantRef place = { 3, 5 };
	const std::shared_ptr<const PlantChunk> shared = store.share(place.chunk);
	const float scale = shared->plants.scale[5];
	REQUIRE(scale > 0.0f);
	StoreEdit removing;
	removing.removed = { place };
	store.apply(std::move(removing));
	CHECK(store.chunk(place.chunk).is_gone(place.slot));
	CHECK(shared->plants.scale[5] == scale);
	CHECK(shared->gone == 0);
	StoreEdit leaving;
	leaving.left_tiles = store.generated_tiles();
	store.apply(std::move(leaving));
	CHECK(shared->size() > 5);
}

TEST_CASE("removing a plant twice counts once") {
	PlantStore store = filled_store(10.0f);
	const int before = store.plant_count();
	StoreEdit edit;
	edit.removed = { { 0, 1 }, { 0, 1 } };
	CHECK(store.apply(std::move(edit)).gone.size() == 1);
	CHECK(store.plant_count() == before - 1);
}

TEST_CASE("added plants preserve their ids through builds and other tiles") {
	PlantStore store = filled_store();
	StoreEdit edit;
	edit.added = { plant_at(3.0f, 4.0f, 1), plant_at(-100.0f, 4.0f), plant_at(3.2f, 4.1f, 1) };
	const ChangeSet changes = store.apply(std::move(edit));
	REQUIRE(changes.added.size() == 3);
	CHECK(changes.grown.size() == 2);
	for (const float size : { 16.0f, 5.0f, 60.0f }) {
		store.apply(replacing(square_field(20.0f, 4.0f, 9), size));
		for (std::size_t i = 0; i < 3; i++) {
			const PlantRef place = store.find(changes.added[i]);
			REQUIRE(place.chunk >= 0);
			CHECK(store.chunk(place.chunk).root(place.slot).x == std::vector<float>{ 3.0f, -100.0f, 3.2f }[i]);
			CHECK(store.chunk(place.chunk).tile == tile_at(std::vector<float>{ 3.0f, -100.0f, 3.2f }[i], 4.0f, size));
		}
	}
}

TEST_CASE("a new species number also applies to added plants") {
	PlantStore store;
	StoreEdit edit;
	edit.added = { plant_at(0.0f, 0.0f, 2) };
	const PlantId id = store.apply(std::move(edit)).added[0];
	StoreEdit fill = replacing(square_field(10.0f, 4.0f, 1));
	fill.species_numbers = { 0, 1, 5 };
	store.apply(std::move(fill));
	const PlantRef place = store.find(id);
	CHECK(store.chunk(place.chunk).species == 5);
	CHECK(store.chunk(place.chunk).plants.plant(place.slot).species == 5);
}

TEST_CASE("an added block is dropped with its last plant, and its number is reused") {
	PlantStore store;
	StoreEdit edit;
	edit.added = { plant_at(0.0f, 0.0f), plant_at(50.0f, 0.0f) };
	const std::vector<PlantId> ids = store.apply(std::move(edit)).added;
	StoreEdit removal;
	removal.removed = { store.find(ids[0]) };
	const ChangeSet changes = store.apply(std::move(removal));
	CHECK(changes.dropped.size() == 1);
	CHECK(changes.gone.empty());
	CHECK(store.find(ids[1]).chunk >= 0);
	StoreEdit again;
	again.added = { plant_at(-50.0f, 0.0f) };
	const ChangeSet later = store.apply(std::move(again));
	CHECK(later.grown[0].chunk == changes.dropped[0]);
	CHECK(later.added[0] != ids[0]);
	CHECK(store.plant_count() == 2);
}

TEST_CASE("an empty generated block remains, so its number is not reused") {
	PlantStore store = filled_store(10.0f);
	std::vector<PlantRef> all;
	store.find_in_sphere({ 0.0f, 0.0f, 0.0f }, 100.0f, all);
	const auto count = all.size();
	StoreEdit edit;
	edit.removed = std::move(all);
	const ChangeSet changes = store.apply(std::move(edit));
	CHECK(changes.gone.size() == count);
	CHECK(changes.dropped.empty());
	CHECK(store.plant_count() == 0);
	CHECK(store.ids().empty());
}

TEST_CASE("when all added plants of a block are removed at once, only the block is reported") {
	PlantStore store;
	StoreEdit planting;
	planting.added = { plant_at(1.0f, 1.0f), plant_at(2.0f, 2.0f), plant_at(3.0f, 3.0f), plant_at(40.0f, 1.0f) };
	const ChangeSet planted = store.apply(std::move(planting));
	StoreEdit mowing;
	for (int i = 0; i < 3; i++) {
		mowing.removed.push_back(store.find(planted.added[static_cast<std::size_t>(i)]));
	}
	mowing.added = { plant_at(50.0f, 50.0f) }; // It can get the chunk's number.
	const ChangeSet mown = store.apply(std::move(mowing));
	CHECK(mown.dropped.size() == 1);
	CHECK(mown.gone.empty());
	CHECK(store.plant_count() == 2);
}

TEST_CASE("added plants are restored with their ids, and later ones get new ids") {
	PlantStore store = filled_store();
	StoreEdit edit;
	edit.added = { plant_at(1.0f, 1.0f), plant_at(2.0f, 1.0f) };
	edit.added_ids = { added_plant_id(4), added_plant_id(9) };
	CHECK(store.apply(std::move(edit)).added == std::vector<PlantId>{ added_plant_id(4), added_plant_id(9) });
	CHECK(store.find(added_plant_id(9)).chunk >= 0);
	StoreEdit later;
	later.added = { plant_at(3.0f, 1.0f) };
	CHECK(store.apply(std::move(later)).added[0] == added_plant_id(10));
}

TEST_CASE("a removed tile is restored unchanged") {
	PlantStore store = filled_store();
	StoreEdit edit;
	edit.added = { plant_at(20.0f, 20.0f) };
	store.apply(std::move(edit));
	const int count = store.plant_count();
	const TileKey tile = { 1, 1 };
	std::vector<PlantChunk> kept;
	int plants = 0;
	for (const int number : store.chunks_of(tile)) {
		if (!store.chunk(number).is_added) {
			kept.push_back(store.chunk(number));
			plants += kept.back().live_count();
		}
	}
	StoreEdit leaving;
	leaving.left_tiles = { tile, { 900, 900 } };
	const ChangeSet left = store.apply(std::move(leaving));
	CHECK(left.dropped.size() == kept.size());
	CHECK(store.plant_count() == count - plants);
	CHECK(store.chunks_of(tile).size() == 1); // Added plants stay.
	StoreEdit coming;
	coming.arriving = kept;
	const ChangeSet back = store.apply(std::move(coming));
	REQUIRE(back.grown.size() == kept.size());
	CHECK(store.plant_count() == count);
	CHECK(store.chunk(back.grown[0].chunk).plants.x == kept[0].plants.x);
}
