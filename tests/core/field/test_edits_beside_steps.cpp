#include "field_fixture.hpp"
#include "placement/plant_store.hpp"
#include "placement/test_placement_fixture.hpp"

#include <doctest/doctest.h>

#include <thread>
#include <utility>

using namespace undergrowth;

namespace {

constexpr int ROUNDS = 48;
constexpr int ROUNDS_OF_GROWTH = 6; ///< Steps that run during one build.
constexpr float TILE = 4.0f; // m.
constexpr float SIDE = 24.0f; // m.

/// A store and its simulation, edited between steps on the main thread as a field does it.
class Scene {
public:
	explicit Scene(int prototypes) : simulation(settings_of(prototypes)) {
		for (const Law law : { Law::elasticity, Law::spring }) {
			simulation.add_species(species_of(law));
		}
		simulation.set_wind(wave_wind());
	}

	void apply(StoreEdit &&edit) {
		const ChangeSet changes = store.apply(std::move(edit));
		pages.resize(static_cast<std::size_t>(store.chunk_count()), -1);
		for (const int chunk : changes.dropped) {
			if (page(chunk) >= 0) {
				simulation.remove_page(std::exchange(page(chunk), -1));
			}
		}
		for (const ChangeSet::Grown &grown : changes.grown) {
			grow(grown);
		}
		for (const PlantRef &ref : changes.gone) {
			simulation.drop(page(ref.chunk), ref.slot);
		}
	}

	/// Runs the current step on `threads` threads, while this one looks plants up.
	void step(int threads) {
		simulation.begin_step();
		const int count = simulation.page_count();
		std::vector<std::thread> pool;
		for (int i = 0; i < threads; i++) {
			pool.emplace_back([this, i, threads, count] {
				simulation.step_pages(count * i / threads, count * (i + 1) / threads);
			});
		}
		std::vector<PlantRef> found;
		store.find_in_sphere({ 2.0f, 0.0f, 1.0f }, 5.0f, found);
		for (const PlantRef &ref : found) {
			seen += store.find(store.id(ref)) == ref ? 1 : 0;
		}
		for (std::thread &thread : pool) {
			thread.join();
		}
	}

	/// Removes every third plant near `centre`, and adds the same number near it.
	void edit_near(const glm::vec3 &centre) {
		std::vector<PlantRef> found;
		store.find_in_sphere(centre, 2.0f, found);
		StoreEdit edit;
		for (std::size_t i = 0; i < found.size(); i += 3) {
			edit.removed.push_back(found[i]);
			PlacedPlant plant;
			plant.root = centre + glm::vec3(0.1f * static_cast<float>(i), 0.0f, 0.3f);
			plant.species = static_cast<int>(i % 2);
			edit.added.push_back(plant);
		}
		apply(std::move(edit));
	}

	uint64_t hash() const {
		GoldenHash all;
		const uint64_t motion = hash_field(simulation);
		all.add(&motion, 1).add(&seen, 1).add(store.ids());
		return all.value();
	}

	FieldSimulation simulation;
	PlantStore store;
	int seen = 0;

private:
	std::vector<int> pages; ///< By chunk.

	static FieldSettings settings_of(int prototypes) {
		FieldSettings settings;
		settings.update_interval = 2;
		settings.prototypes = prototypes;
		return settings;
	}

	int &page(int chunk) { return pages[static_cast<std::size_t>(chunk)]; }

	void grow(const ChangeSet::Grown &grown) {
		const PlantChunk &chunk = store.chunk(grown.chunk);
		std::vector<MotionPlant> plants(static_cast<std::size_t>(chunk.size() - grown.first));
		for (std::size_t i = 0; i < plants.size(); i++) {
			plants[i].root = chunk.root(grown.first + static_cast<int>(i));
			plants[i].length = 0.7f;
		}
		const int count = static_cast<int>(plants.size());
		if (page(grown.chunk) < 0) {
			page(grown.chunk) = simulation.add_page(chunk.species, plants.data(), count);
		} else {
			REQUIRE(simulation.add_to_page(page(grown.chunk), plants.data(), count));
		}
	}
};

/// A build on its own thread, from copies: the placement request and the previous plants.
class Growth {
public:
	Growth(const PlantStore &store, const PlacementRequest &wanted) : request(wanted) {
		for (int number = 0; number < store.chunk_count(); number++) {
			existing.push_back(store.chunk(number));
		}
		worker = std::thread([this] { work(); });
	}

	/// Waits for the build.
	StoreEdit take() {
		worker.join();
		return std::move(edit);
	}

	int arriving = 0;

private:
	PlacementRequest request;
	std::vector<PlantChunk> existing;
	StoreEdit edit;
	std::thread worker;

	void work() {
		for (const PlantChunk &chunk : existing) {
			arriving += chunk.live_count();
		}
		edit.replaces_all = true;
		edit.tile_size = TILE;
		edit.spacing = Placement(request).cell_size();
		edit.generated = cut_into_chunks(placed(request), TILE);
	}
};

uint64_t run(int prototypes, int threads) {
	Scene scene(prototypes);
	PlacementRequest request = square_field(SIDE, 4.0f, 2);
	scene.apply(Growth(scene.store, request).take());
	for (int i = 0; i < ROUNDS; i += ROUNDS_OF_GROWTH) {
		// The same meadow with a lane through different tiles.
		const float lane = static_cast<float>(i % 20) - 10.0f;
		request.exclusions = { { { lane, -20.0f }, { lane + 3.0f, -20.0f }, { lane + 3.0f, 20.0f }, { lane, 20.0f } } };
		const int before = scene.store.plant_count();
		Growth growth(scene.store, request);
		for (int j = 0; j < ROUNDS_OF_GROWTH; j++) {
			scene.step(threads);
			scene.edit_near({ static_cast<float>(j) - 3.0f, 0.0f, static_cast<float>(i % 7) });
		}
		scene.apply(growth.take());
		CHECK(growth.arriving == before);
	}
	scene.step(threads);
	CHECK(scene.seen > 0);
	return scene.hash();
}

} // namespace

TEST_CASE("adding, mowing and rebuilding plants beside the steps gives the same bits on any number of threads") {
	for (const int prototypes : { 0, 16 }) {
		const uint64_t single = run(prototypes, 1);
		CHECK(run(prototypes, 4) == single);
	}
}
