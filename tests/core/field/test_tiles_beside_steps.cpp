#include "field_fixture.hpp"
#include "placement/edit_log.hpp"
#include "placement/plant_store.hpp"
#include "placement/test_placement_fixture.hpp"
#include "placement/tile_choice.hpp"

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
	EditLog edits;
	MotionSpecies kinds[2];
	std::vector<PlantChunk> chunks;
	std::vector<std::vector<MotionPlant>> plants;
	std::vector<MotionPage> pages;

	void place(bool swings) {
		FieldPlants all = placed(request);
		edits.take_out(all);
		chunks = cut_into_chunks(all, TILE);
		for (const PlantChunk &chunk : chunks) {
			std::vector<MotionPlant> some;
			for (int slot = 0; slot < chunk.size(); slot++) {
				some.push_back({ chunk.root(slot), 0.5f, { 0.0f, 1.0f, 0.0f } });
			}
			pages.emplace_back(chunk.species, kinds[chunk.species], some.data(), chunk.size(), 1.0f / 60.0f, swings);
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
		StoreEdit edit;
		edit.replaces_all = true;
		edit.tile_size = TILE;
		edit.spacing = spacing;
		store.apply(std::move(edit));
	}

	void go(int rounds, int threads) {
		for (int round = 0; round < rounds; round++) {
			const glm::vec2 place(WAY * static_cast<float>(round < rounds / 2 ? round : rounds - round), 0.0f);
			const TileChoice choice = choose_tiles(existing, { place }, DISTANCE, TILE, EVERYWHERE);
			std::vector<Tile> coming;
			for (const TileKey &tile : choice.to_load) {
				coming.push_back({ request, edits.cut(tile_box(tile, TILE)), { kinds[0], kinds[1] }, {}, {}, {} });
				coming.back().request.within = tile_box(tile, TILE);
			}
			step_beside(coming, threads);
			cut_around(place);
			come_and_go(coming, choice);
		}
	}

	uint64_t hash() const { return hash_field(simulation) ^ static_cast<uint64_t>(store.plant_count()); }

	PlantStore store;
	EditLog edits;
	std::set<TileKey> existing;
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
		edits.remove({ generated_plant_id(1.0e4f, static_cast<float>(count), spacing) }, spacing);
		for (std::thread &thread : pool) {
			thread.join();
		}
	}

	void cut_around(const glm::vec2 &place) {
		std::vector<PlantRef> found;
		store.find_in_sphere({ place.x, 0.0f, place.y + 2.0f }, 0.6f, found);
		std::vector<PlantId> ids;
		for (const PlantRef &one : found) {
			ids.push_back(store.id(one));
		}
		edits.remove(ids, spacing);
		StoreEdit edit;
		edit.removed = found;
		follow(store.apply(std::move(edit)), nullptr);
	}

	void come_and_go(std::vector<Tile> &coming, const TileChoice &choice) {
		StoreEdit going;
		going.left_tiles = choice.to_unload;
		follow(store.apply(std::move(going)), nullptr);
		for (const TileKey &tile : choice.to_unload) {
			existing.erase(tile);
		}
		for (Tile &tile : coming) {
			StoreEdit edit;
			edit.arriving = std::move(tile.chunks);
			follow(store.apply(std::move(edit)), &tile);
		}
		existing.insert(choice.to_load.begin(), choice.to_load.end());
	}

	void follow(const ChangeSet &edit, Tile *tile) {
		for (const int chunk : edit.dropped) {
			simulation.remove_page(pages[chunk]);
			pages.erase(chunk);
		}
		for (std::size_t i = 0; i < edit.grown.size(); i++) {
			pages[edit.grown[i].chunk] = simulation.add_page(std::move(tile->pages[i]), tile->plants[i].data());
		}
		for (const PlantRef &place : edit.gone) {
			simulation.drop(pages[place.chunk], place.slot);
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
	for (const TileKey &tile : walk.existing) {
		request.within = tile_box(tile, TILE);
		const FieldPlants plants = placed(request);
		for (std::size_t i = 0; i < plants.x.size(); i++) {
			if (walk.edits.is_gone(plants.x[i], plants.z[i])) {
				cut++;
			} else {
				wanted.insert(generated_plant_id(plants.x[i], plants.z[i], walk.spacing));
			}
		}
	}
	const std::vector<PlantId> ids = walk.store.ids();
	CHECK(std::set<PlantId>(ids.begin(), ids.end()) == wanted);
	CHECK(cut > 50);
}
