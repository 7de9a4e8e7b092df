#include "field_fixture.hpp"
#include "stand/plant_store.hpp"
#include "stand/stand_changes.hpp"
#include "stand/test_placement_fixture.hpp"
#include "stand/tile_choice.hpp"

#include <doctest/doctest.h>

#include <map>
#include <set>
#include <thread>
#include <utility>

using namespace undergrowth;

namespace {

constexpr int ROUNDS = 40;
constexpr float TILE = 4.0f; // m.
constexpr float DISTANCE = 9.0f; // m.
constexpr float WAY = 1.5f; // m per round.
constexpr AreaBox EVERYWHERE = { { -1.0e5f, -1.0e5f }, { 1.0e5f, 1.0e5f } };

/// A tile that is placed on its own thread, and its simulated plants.
struct Tile {
	PlacementRequest request;
	StandChanges changes;
	MotionSpecies kinds[2];
	std::vector<PlantBlock> blocks;
	std::vector<std::vector<MotionPlant>> plants;
	std::vector<MotionPage> pages;

	void place(bool swings) {
		FieldPlants all = placed(request);
		changes.take_out(all);
		blocks = cut_into_blocks(all, TILE);
		for (const PlantBlock &block : blocks) {
			std::vector<MotionPlant> some;
			for (int slot = 0; slot < block.size(); slot++) {
				some.push_back({ block.root(slot), 0.5f, { 0.0f, 1.0f, 0.0f } });
			}
			pages.emplace_back(block.species, kinds[block.species], some.data(), block.size(), 1.0f / 60.0f, swings);
			plants.push_back(std::move(some));
		}
	}
};

/// A camera moves over a field that has tiles only near it, and plants near it are cut.
class Walk {
public:
	explicit Walk(int prototypes) : simulation(settings_of(prototypes)), swings(prototypes == 0) {
		kinds[0] = species_of(Law::elasticity);
		kinds[1] = species_of(Law::spring);
		simulation.add_species(kinds[0]);
		simulation.add_species(kinds[1]);
		simulation.set_wind(wave_wind());
		request.area = rectangle({ 1000.0f, 1000.0f });
		spacing = [&] {
			PlacementRequest some = request;
			some.within = AreaBox();
			return Placement(some).cell_size();
		}();
		StandEdit edit;
		edit.fills = true;
		edit.tile_size = TILE;
		edit.spacing = spacing;
		store.apply(std::move(edit));
	}

	void go(int rounds, int threads) {
		for (int round = 0; round < rounds; round++) {
			const glm::vec2 place(WAY * static_cast<float>(round < rounds / 2 ? round : rounds - round), 0.0f);
			const TileChoice choice = choose_tiles(standing, { place }, DISTANCE, TILE, EVERYWHERE);
			std::vector<Tile> coming;
			for (const TileKey &tile : choice.coming) {
				coming.push_back({ request, changes.cut(tile_box(tile, TILE)), { kinds[0], kinds[1] }, {}, {}, {} });
				coming.back().request.within = tile_box(tile, TILE);
			}
			step_beside(coming, threads);
			cut_around(place);
			come_and_go(coming, choice);
		}
	}

	uint64_t hash() const { return hash_field(simulation) ^ static_cast<uint64_t>(store.plant_count()); }

	PlantStore store;
	StandChanges changes;
	std::set<TileKey> standing;
	double spacing = 1.0;

private:
	FieldSimulation simulation;
	bool swings;
	MotionSpecies kinds[2];
	PlacementRequest request = square_field(10.0f, 9.0f, 2);
	std::map<int, int> pages;

	static FieldSettings settings_of(int prototypes) {
		FieldSettings settings;
		settings.prototypes = prototypes;
		return settings;
	}

	/// Steps on some threads, tiles on other threads, and edits of plants on this one.
	void step_beside(std::vector<Tile> &coming, int threads) {
		simulation.begin_step();
		const int count = simulation.page_count();
		std::vector<std::thread> pool;
		for (int i = 0; i < threads; i++) {
			pool.emplace_back([this, i, threads, count] {
				simulation.step_pages(count * i / threads, count * (i + 1) / threads);
			});
		}
		for (Tile &tile : coming) {
			pool.emplace_back([this, &tile] { tile.place(swings); });
		}
		changes.remove({ filled_plant_id(1.0e4f, static_cast<float>(count), spacing) }, spacing);
		for (std::thread &thread : pool) {
			thread.join();
		}
	}

	void cut_around(const glm::vec2 &place) {
		std::vector<PlantPlace> found;
		store.find_in_sphere({ place.x, 0.0f, place.y + 2.0f }, 0.6f, found);
		std::vector<PlantId> ids;
		for (const PlantPlace &one : found) {
			ids.push_back(store.id(one));
		}
		changes.remove(ids, spacing);
		StandEdit edit;
		edit.removed = found;
		follow(store.apply(std::move(edit)), nullptr);
	}

	void come_and_go(std::vector<Tile> &coming, const TileChoice &choice) {
		StandEdit going;
		going.left_tiles = choice.going;
		follow(store.apply(std::move(going)), nullptr);
		for (const TileKey &tile : choice.going) {
			standing.erase(tile);
		}
		for (Tile &tile : coming) {
			StandEdit edit;
			edit.stood = std::move(tile.blocks);
			follow(store.apply(std::move(edit)), &tile);
		}
		standing.insert(choice.coming.begin(), choice.coming.end());
	}

	void follow(const ChangeSet &edit, Tile *tile) {
		for (const int block : edit.dropped) {
			simulation.remove_page(pages[block]);
			pages.erase(block);
		}
		for (std::size_t i = 0; i < edit.grown.size(); i++) {
			pages[edit.grown[i].block] = simulation.add_page(std::move(tile->pages[i]), tile->plants[i].data());
		}
		for (const PlantPlace &place : edit.gone) {
			simulation.drop(pages[place.block], place.slot);
		}
	}
};

} // namespace

TEST_CASE("adding and removing tiles beside steps gives the same bits on any number of threads") {
	for (const int prototypes : { 0, 8 }) {
		Walk single(prototypes);
		single.go(ROUNDS, 1);
		for (const int threads : { 2, 5 }) {
			Walk walk(prototypes);
			walk.go(ROUNDS, threads);
			CHECK(walk.hash() == single.hash());
		}
	}
}

TEST_CASE("after a walk and back the same plants exist, except for the cut ones") {
	Walk walk(0);
	walk.go(ROUNDS, 2);
	PlacementRequest request = square_field(10.0f, 9.0f, 2);
	request.area = rectangle({ 1000.0f, 1000.0f });
	std::set<PlantId> wanted;
	int cut = 0;
	for (const TileKey &tile : walk.standing) {
		request.within = tile_box(tile, TILE);
		const FieldPlants plants = placed(request);
		for (std::size_t i = 0; i < plants.x.size(); i++) {
			if (walk.changes.is_gone(plants.x[i], plants.z[i])) {
				cut++;
			} else {
				wanted.insert(filled_plant_id(plants.x[i], plants.z[i], walk.spacing));
			}
		}
	}
	const std::vector<PlantId> ids = walk.store.ids();
	CHECK(std::set<PlantId>(ids.begin(), ids.end()) == wanted);
	CHECK(cut > 50);
}
