// Tiles of two densities side by side, as while a field is rebuilt tile by tile.
#include "placement/edit_log.hpp"
#include "placement/plant_matches.hpp"
#include "placement/test_plant_store_fixture.hpp"

#include <doctest/doctest.h>

#include <map>
#include <set>
#include <vector>

using namespace undergrowth;

namespace {

constexpr float TILE = 10.0f;
const TileKey EXCHANGED = { 0, 0 };

/// Edit that gives a tile of a field its plants.
StoreEdit exchange(const PlacementRequest &request, const TileKey &tile) {
	PlacementRequest part = request;
	part.within = tile_box(tile, TILE);
	StoreEdit edit;
	edit.left_tiles = { tile };
	edit.arriving = cut_into_chunks(placed(part), TILE);
	edit.spacing = Placement(part).cell_size();
	return edit;
}

PlacementRequest field_of(float density) {
	return square_field(40.0f, density, 2);
}

} // namespace

TEST_CASE("plants of two densities have unique ids and are found by them") {
	for (const float density : { 3.9f, 4.1f, 8.0f, 1.0f }) {
		PlantStore store;
		store.apply(replacing(field_of(4.0f), TILE));
		REQUIRE(store.has_unused_ids(Placement(field_of(density)).cell_size()));
		const PlacementRequest wanted = field_of(density);
		for (int column = -2; column < 2; column++) {
			for (int row = -2; row < 2; row++) {
				store.apply(exchange(wanted, { column, row }));
				CHECK(static_cast<int>(id_set(store).size()) == store.plant_count());
				for (const PlantId id : store.ids()) {
					CHECK(store.id(store.find(id)) == id);
				}
			}
		}
		PlantStore at_once;
		at_once.apply(replacing(wanted, TILE));
		CHECK(id_set(store) == id_set(at_once));
	}
}

TEST_CASE("replacing a tile changes no other tile") {
	PlantStore store;
	store.apply(replacing(field_of(4.0f), TILE));
	std::map<PlantId, PlantRef> others;
	for (const PlantId id : store.ids()) {
		const PlantRef place = store.find(id);
		if (!(store.chunk(place.chunk).tile == EXCHANGED)) {
			others[id] = place;
		}
	}
	const ChangeSet changes = store.apply(exchange(field_of(7.0f), EXCHANGED));
	CHECK(!changes.dropped.empty());
	CHECK(!changes.grown.empty());
	CHECK(changes.gone.empty());
	for (const auto &[id, place] : others) {
		CHECK(store.find(id) == place);
	}
}

TEST_CASE("a replaced tile transfers the same plants, and none of another density") {
	PlantStore store;
	store.apply(replacing(field_of(4.0f), TILE));
	PlacementRequest smaller = field_of(4.0f);
	smaller.area = square_field(11.0f, 4.0f, 2).area;
	const GeneratedChunks before = share_generated_in(store, EXCHANGED);
	const StoreEdit again = exchange(smaller, EXCHANGED);
	int count = 0;
	for (const PlantChunk &chunk : again.arriving) {
		count += chunk.size();
	}
	CHECK(count > 50);
	CHECK(static_cast<int>(match_plants(before, again.arriving, again.spacing).size()) == count);
	const StoreEdit denser = exchange(field_of(4.5f), EXCHANGED);
	CHECK(match_plants(before, denser.arriving, denser.spacing).empty());
	std::set<TileKey> tiles;
	for (const auto &entry : before.chunks) {
		tiles.insert(entry.second->tile);
	}
	CHECK(tiles == std::set<TileKey>{ EXCHANGED });
}

TEST_CASE("late plants do not join blocks of another density") {
	PlantStore store;
	store.apply(replacing(field_of(4.0f), TILE));
	const auto grow = [&](float x) {
		StoreEdit edit;
		edit.grown = { plant_at(x, 5.0f) };
		edit.grown_from = { PlantRef() };
		return store.apply(std::move(edit)).grown.front().chunk;
	};
	const int first = grow(1.0f);
	CHECK(grow(2.0f) == first);
	StoreEdit other;
	other.spacing = 0.3;
	store.apply(std::move(other));
	const int second = grow(3.0f);
	CHECK(second != first);
	CHECK(store.chunk(first).spacing == SPACING);
	CHECK(store.chunk(second).spacing == 0.3);
}

TEST_CASE("tiles with generated plants are listed once each") {
	PlantStore store;
	store.apply(replacing(field_of(4.0f), TILE));
	StoreEdit edit;
	edit.added = { plant_at(100.0f, 100.0f) };
	store.apply(std::move(edit));
	CHECK(store.generated_tiles().size() == 16);
	StoreEdit leaving;
	leaving.left_tiles = { EXCHANGED };
	store.apply(std::move(leaving));
	CHECK(store.generated_tiles().size() == 15);
}

TEST_CASE("marks of spacings are rarely equal and separate ids") {
	int same = 0;
	for (int i = 1; i < 4000; i++) {
		const double spacing = 0.1 + 0.001 * i;
		same += share_ids(0.1, spacing) ? 1 : 0;
		const PlantId id = generated_plant_id(3.0f, -7.0f, spacing);
		CHECK(matches_spacing(id, spacing));
		CHECK(!is_added(id));
		CHECK(id >= 0);
	}
	CHECK(same < 8);
}
