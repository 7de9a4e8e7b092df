#include "placement/chunks.hpp"
#include "placement/plant_matches.hpp"
#include "test_placement_fixture.hpp"

#include <doctest/doctest.h>

#include <map>
#include <utility>

using namespace undergrowth;

namespace {

constexpr float DENSITY = 4.0f;
constexpr double SPACING = 0.5; // m: 1/sqrt(DENSITY).

PlantStore filled_store(const PlacementRequest &request, float tile_size) {
	StoreEdit edit;
	edit.replaces_all = true;
	edit.generated = cut_into_chunks(placed(request), tile_size);
	edit.tile_size = tile_size;
	edit.spacing = SPACING;
	PlantStore store;
	store.apply(std::move(edit));
	return store;
}

struct Scene {
	double spacing;
	std::vector<PlantChunk> chunks;

	/// Chunk numbers of a store without other chunks: 7, 10, 13 ...
	GeneratedChunks numbered() const {
		GeneratedChunks all;
		all.spacing = spacing;
		for (const PlantChunk &chunk : chunks) {
			auto shared = std::make_shared<PlantChunk>(chunk);
			shared->spacing = spacing;
			all.chunks.emplace_back(7 + 3 * static_cast<int>(all.chunks.size()), std::move(shared));
		}
		return all;
	}
};

Scene scene_of(const PlacementRequest &request, float tile = 5.0f) {
	return { Placement(request).cell_size(), cut_into_chunks(placed(request), tile) };
}

PlantId id_of(const PlantChunk &chunk, int slot, double spacing) {
	return generated_plant_id(chunk.root(slot).x, chunk.root(slot).z, spacing);
}

std::map<PlantId, PlantRef> ids_of(const GeneratedChunks &generated) {
	std::map<PlantId, PlantRef> ids;
	for (const auto &[number, chunk] : generated.chunks) {
		for (int slot = 0; slot < chunk->size(); slot++) {
			if (!chunk->is_gone(slot)) {
				ids[id_of(*chunk, slot, generated.spacing)] = { number, slot };
			}
		}
	}
	return ids;
}

/// Checks that exactly the plants with ids in both lists are transferred, with their locations. Returns their number.
int check_matches(const GeneratedChunks &before, const Scene &now) {
	std::map<PlantId, PlantRef> ids = ids_of(before);
	const std::vector<PlantMatch> matches = match_plants(before, now.chunks, now.spacing);
	std::size_t next = 0;
	for (std::size_t i = 0; i < now.chunks.size(); i++) {
		for (int slot = 0; slot < now.chunks[i].size(); slot++) {
			const auto found = ids.find(id_of(now.chunks[i], slot, now.spacing));
			if (found == ids.end()) {
				continue;
			}
			REQUIRE(next < matches.size());
			CHECK(matches[next].to.chunk == static_cast<int>(i));
			CHECK(matches[next].to.slot == slot);
			CHECK(matches[next].from.chunk == found->second.chunk);
			CHECK(matches[next].from.slot == found->second.slot);
			next++;
		}
	}
	CHECK(next == matches.size());
	return static_cast<int>(matches.size());
}

int plants_of(const Scene &scene) {
	int count = 0;
	for (const PlantChunk &chunk : scene.chunks) {
		count += chunk.size();
	}
	return count;
}

} // namespace

TEST_CASE("all plants at unchanged positions are transferred") {
	const Scene scene = scene_of(square_field(20.0f, 3.0f, 5));
	CHECK(check_matches(scene.numbered(), scene) == plants_of(scene));
	CHECK(plants_of(scene) > 1000);
}

TEST_CASE("plants are matched by their cells across other tiles, sizes, seeds and species") {
	const PlacementRequest request = square_field(20.0f, 3.0f, 5);
	const Scene before = scene_of(request);
	CHECK(check_matches(before.numbered(), scene_of(request, 7.0f)) == plants_of(before));
	PlacementRequest other = request;
	other.seed = 6;
	CHECK(check_matches(before.numbered(), scene_of(other)) > 900);
	const Scene smaller = scene_of(square_field(10.0f, 3.0f, 5));
	CHECK(check_matches(before.numbered(), smaller) == plants_of(smaller));
	CHECK(check_matches(smaller.numbered(), before) == plants_of(smaller));
}

TEST_CASE("plants outside of the previous area are not transferred") {
	for (const float side : { 15.5f, 16.0f, 31.0f, 64.0f }) { // Cells of 0.5 m: around powers of two.
		const Scene before = scene_of(square_field(side, DENSITY, 3));
		for (const float more : { 1.0f, 2.0f * side }) {
			const Scene now = scene_of(square_field(side + more, DENSITY, 3));
			CHECK(check_matches(before.numbered(), now) == plants_of(before));
			CHECK(check_matches(now.numbered(), before) == plants_of(before));
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
		const Scene before = scene_of(request, 16.0f);
		CHECK(plants_of(before) > 300);
		CHECK(check_matches(before.numbered(), scene_of(request, 11.0f)) == plants_of(before));
		request.seed++;
		CHECK(check_matches(before.numbered(), scene_of(request)) > plants_of(before) * 2 / 3);
	}
}

TEST_CASE("a removed plant is not transferred when it grows again at its position") {
	const Scene scene = scene_of(square_field(20.0f, 3.0f, 5));
	GeneratedChunks before = scene.numbered();
	PlantChunk changed = *before.chunks[2].second;
	changed.plants.scale[1] = 0.0f;
	changed.gone = 1;
	before.chunks[2].second = std::make_shared<PlantChunk>(std::move(changed));
	CHECK(check_matches(before, scene) == plants_of(scene) - 1);
}

TEST_CASE("another density has other ids, even for plants at the same position") {
	const Scene scene = scene_of(square_field(20.0f, 3.0f, 5));
	Scene other = scene;
	other.spacing *= 0.8;
	CHECK(check_matches(scene.numbered(), other) == 0);
}

TEST_CASE("adding or removing a tile does not affect other tiles") {
	const Scene scene = scene_of(square_field(20.0f, 3.0f, 5));
	Scene fewer = scene;
	fewer.chunks.pop_back();
	CHECK(check_matches(scene.numbered(), fewer) == plants_of(fewer));
	CHECK(check_matches(fewer.numbered(), scene) == plants_of(fewer));
	fewer = scene;
	fewer.chunks.erase(fewer.chunks.begin() + 1);
	CHECK(check_matches(scene.numbered(), fewer) == plants_of(fewer));
	CHECK(match_plants(GeneratedChunks(), scene.chunks, scene.spacing).empty());
	CHECK(match_plants(scene.numbered(), {}, scene.spacing).empty());
}

TEST_CASE("a plant that moved along one axis only is also matched by its cell") {
	const Scene scene = scene_of(square_field(20.0f, 3.0f, 5));
	for (const bool along_x : { true, false }) {
		Scene moved = scene;
		FieldPlants &plants = moved.chunks[0].plants;
		(along_x ? plants.x : plants.z)[0] += static_cast<float>(4.0 * scene.spacing);
		const std::vector<PlantMatch> matches = match_plants(scene.numbered(), moved.chunks, moved.spacing);
		CHECK(check_matches(scene.numbered(), moved) == static_cast<int>(matches.size()));
		CHECK(matches.front().from.slot != matches.front().to.slot);
	}
}

TEST_CASE("a rebuild of styles gathers all plants except added ones, removed ones and those of dropped species") {
	PlantStore store = filled_store(square_field(20.0f, DENSITY, 3), 8.0f);
	store.apply([] {
		StoreEdit edit;
		edit.added = { PlacedPlant() };
		return edit;
	}());
	const PlantRef gone = { 0, 0 };
	StoreEdit edit;
	edit.removed = { gone };
	store.apply(std::move(edit));
	int expected = 0;
	for (int number = 0; number < store.chunk_count(); number++) {
		const PlantChunk &chunk = store.chunk(number);
		expected += chunk.is_added || chunk.species == 1 ? 0 : chunk.live_count();
	}
	const FieldPlants plants = gather_plants(share_generated(store), { 1, -1, 0 });
	CHECK(plants.size() == expected);
	for (const uint8_t species : plants.species) {
		CHECK(species <= 1);
	}
}

TEST_CASE("the existing plants of a list of ids are found, in its order") {
	const PlantStore store = filled_store(square_field(10.0f, DENSITY, 1), 8.0f);
	const std::vector<PlantId> ids = store.ids();
	const std::vector<PlantRef> found = store.find_all({ ids[3], NO_PLANT, ids[1] });
	REQUIRE(found.size() == 2);
	CHECK(store.id(found[0]) == ids[3]);
	CHECK(store.id(found[1]) == ids[1]);
}
