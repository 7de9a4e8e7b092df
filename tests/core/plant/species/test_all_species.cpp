#include "../../golden.hpp"
#include "../../mesh/mesh_fixture.hpp"
#include "plant/base_shape.hpp"
#include "plant/species/bellflower.hpp"
#include "plant/species/cattail.hpp"
#include "plant/species/grass.hpp"
#include "plant/species/reed.hpp"
#include "plant/species/tulip.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <algorithm>

using namespace undergrowth;

namespace {

constexpr int STEPS = 500;

/// Max width of the plant (m), sampled at `lod` segments.
template <class Species> float widest(const Species &species, int lod) {
	const Plant plant = make_species_plant(species, lod, 1.0f);
	return *std::max_element(plant.widths.begin(), plant.widths.end()) * plant.section.radius;
}

uint64_t golden_hash(const Plant &plant, const MeshOptions &options) {
	const BuiltMesh mesh = build(plant, options);
	return GoldenHash()
			.add(mesh.positions)
			.add(mesh.normals)
			.add(mesh.colors)
			.add(mesh.uvs)
			.add(mesh.bones)
			.add(mesh.weights)
			.add(mesh.indices)
			.value();
}

/// Hashes of smooth and flat meshes, each with deviations and without.
struct Goldens {
	uint64_t smooth_deviating;
	uint64_t flat;
	uint64_t smooth;
	uint64_t flat_deviating;
};

template <class Species> void check_golden(const Goldens &goldens) {
	const HeightRange heights = Species::heights;
	const Plant plant = make_species_plant(Species(), 16, heights.min + (heights.max - heights.min) * 0.5f);
	CHECK(golden_hash(plant, { Shading::smooth, 0.3f, 0.3f, 7 }) == goldens.smooth_deviating);
	CHECK(golden_hash(plant, { Shading::flat, 0.0f, 0.0f, 0 }) == goldens.flat);
	CHECK(golden_hash(plant, { Shading::smooth, 0.0f, 0.0f, 0 }) == goldens.smooth);
	CHECK(golden_hash(plant, { Shading::flat, 0.3f, 0.3f, 7 }) == goldens.flat_deviating);
}

} // namespace

TEST_CASE_TEMPLATE("widths and colours are in range", Species, Grass, Reed, Cattail, Tulip, Bellflower) {
	const Species species;
	for (int i = 0; i <= STEPS; i++) {
		const float offset = static_cast<float>(i) / STEPS;
		CHECK(species.width(offset) >= 0.0f);
		CHECK(species.width(offset) * make_cross_section(species.base_shape(16)).radius < 0.3f);
		const glm::vec4 color = species.color(offset);
		CHECK(color.w == 1.0f);
		CHECK(std::min({ color.x, color.y, color.z }) >= 0.0f);
		CHECK(std::max({ color.x, color.y, color.z }) <= 1.0f);
	}
}

TEST_CASE_TEMPLATE("a coarse level has the girth of the fine one", Species, Grass, Reed, Cattail, Tulip, Bellflower) {
	const float fine = widest(Species(), 96);
	CHECK(widest(Species(), 8) > 0.6f * fine);
	CHECK(widest(Species(), 24) > 0.85f * fine);
	CHECK(widest(Species(), 24) <= 1.01f * fine);
}

TEST_CASE_TEMPLATE("base shapes are sound at any level", Species, Grass, Reed, Cattail, Tulip, Bellflower) {
	for (const int lod : { 1, 8, 24, MAX_LOD }) {
		std::vector<glm::vec3> points;
		for (const glm::vec2 p : Species().base_shape(lod)) {
			points.push_back({ p.x, 0.0f, p.y });
		}
		CHECK(find_ring_fault(points.data(), static_cast<int>(points.size())) == RingFault::none);
	}
}

TEST_CASE("meshes of the species are the same on every platform") {
	check_golden<Grass>({ 0xeed9d6a20185d089ull, 0xf9d7f3204e19420dull, 0xe98447f9121c5871ull, 0x69ef5137e5f2a5adull });
	check_golden<Reed>({ 0x52631348a4eeaffeull, 0x8b94857710fcad01ull, 0xe9938bb85e9850f7ull, 0xda1fb437d359a340ull });
	check_golden<Cattail>(
			{ 0x10b8967b12fadd7aull, 0xe3eda167afd5e7aaull, 0xb7c186bfb40271f0ull, 0x5cd9e63ac631f91aull });
	check_golden<Tulip>({ 0xeca94343025f67f1ull, 0x629d765d8472d00eull, 0xd8e993751b807d32ull, 0x9278f03179bad4f0ull });
	check_golden<Bellflower>(
			{ 0x93e0cbb8b0319332ull, 0x384862a176399f59ull, 0x5f41d2c1984c879aull, 0xac93170f5d00a8b4ull });
}
