// Tiles of two densities side by side, as while a field is rebuilt tile by tile.
#include "stand/kept_plants.hpp"
#include "stand/stand_changes.hpp"
#include "stand/test_plant_store_fixture.hpp"

#include <doctest/doctest.h>

#include <map>
#include <set>
#include <vector>

using namespace undergrowth;

namespace {

constexpr float TILE = 10.0f;
const TileKey EXCHANGED = { 0, 0 };

/// Edit that gives a tile of a field its plants.
StandEdit exchange(const PlacementRequest &request, const TileKey &tile) {
	PlacementRequest part = request;
	part.within = tile_box(tile, TILE);
	StandEdit edit;
	edit.left_tiles = { tile };
	edit.stood = cut_into_blocks(placed(part), TILE);
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
		store.apply(filling(field_of(4.0f), TILE));
		REQUIRE(store.has_names_left(Placement(field_of(density)).cell_size()));
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
		at_once.apply(filling(wanted, TILE));
		CHECK(id_set(store) == id_set(at_once));
	}
}

TEST_CASE("replacing a tile changes no other tile") {
	PlantStore store;
	store.apply(filling(field_of(4.0f), TILE));
	std::map<PlantId, PlantPlace> others;
	for (const PlantId id : store.ids()) {
		const PlantPlace place = store.find(id);
		if (!(store.block(place.block).tile == EXCHANGED)) {
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
	store.apply(filling(field_of(4.0f), TILE));
	PlacementRequest smaller = field_of(4.0f);
	smaller.area = square_field(11.0f, 4.0f, 2).area;
	const FilledBlocks before = copy_filled_in(store, EXCHANGED);
	const StandEdit again = exchange(smaller, EXCHANGED);
	int count = 0;
	for (const PlantBlock &block : again.stood) {
		count += block.size();
	}
	CHECK(count > 50);
	CHECK(static_cast<int>(find_kept(before, again.stood, again.spacing).size()) == count);
	const StandEdit denser = exchange(field_of(4.5f), EXCHANGED);
	CHECK(find_kept(before, denser.stood, denser.spacing).empty());
	std::set<TileKey> tiles;
	for (const auto &entry : before.blocks) {
		tiles.insert(entry.second.tile);
	}
	CHECK(tiles == std::set<TileKey>{ EXCHANGED });
}

TEST_CASE("late plants do not join blocks of another density") {
	PlantStore store;
	store.apply(filling(field_of(4.0f), TILE));
	const auto grow = [&](float x) {
		StandEdit edit;
		edit.grown = { plant_at(x, 5.0f) };
		edit.grown_from = { PlantPlace() };
		return store.apply(std::move(edit)).grown.front().block;
	};
	const int first = grow(1.0f);
	CHECK(grow(2.0f) == first);
	StandEdit other;
	other.spacing = 0.3;
	store.apply(std::move(other));
	const int second = grow(3.0f);
	CHECK(second != first);
	CHECK(store.block(first).spacing == SPACING);
	CHECK(store.block(second).spacing == 0.3);
}

TEST_CASE("tiles with generated plants are listed once each") {
	PlantStore store;
	store.apply(filling(field_of(4.0f), TILE));
	StandEdit edit;
	edit.added = { plant_at(100.0f, 100.0f) };
	store.apply(std::move(edit));
	CHECK(store.filled_tiles().size() == 16);
	StandEdit leaving;
	leaving.left_tiles = { EXCHANGED };
	store.apply(std::move(leaving));
	CHECK(store.filled_tiles().size() == 15);
}

TEST_CASE("marks of spacings are rarely equal and separate ids") {
	int same = 0;
	for (int i = 1; i < 4000; i++) {
		const double spacing = 0.1 + 0.001 * i;
		same += share_names(0.1, spacing) ? 1 : 0;
		const PlantId id = filled_plant_id(3.0f, -7.0f, spacing);
		CHECK(is_named_at(id, spacing));
		CHECK(!is_added(id));
		CHECK(id >= 0);
	}
	CHECK(same < 8);
}
