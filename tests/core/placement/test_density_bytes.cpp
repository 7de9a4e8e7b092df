#include "placement/density_brush.hpp"
#include "placement/density_bytes.hpp"

#include "../golden.hpp"
#include "base/byte_codec.hpp"
#include "base/random.hpp"

#include <doctest/doctest.h>

#include <cstring>

using namespace undergrowth;

namespace {

constexpr std::size_t HECTARE_BYTES = 100 * 1024;
constexpr std::size_t GOLDEN_SIZE = 482;
constexpr uint64_t GOLDEN_BYTES = 16987235884191265994ull;

/// Some strokes with soft edges over a square around (`at`, `at`).
void paint_square(DensityMap &map, const char *layer_name, float side, float at, int strokes, uint64_t seed) {
	const int layer = map.need_layer(layer_name);
	for (int i = 0; i < strokes; i++) {
		const auto n = static_cast<uint64_t>(i);
		const float x = at + 0.5f * side * signed_noise(seed, 4 * n);
		const float z = at + 0.5f * side * signed_noise(seed, 4 * n + 1);
		const float radius = 4.0f + 2.0f * signed_noise(seed, 4 * n + 2);
		paint(map, layer, { { x, z }, radius, 0.5f }, { DensityStroke::Does::add, 0.3f, 1.0f });
		if (i % 3 == 0) {
			paint(map, layer, { { z, x }, radius, 0.5f }, { DensityStroke::Does::set_height, 1.4f, 0.5f });
		}
	}
}

bool are_the_same(const DensityMap &one, const DensityMap &other) {
	return write_density(one) == write_density(other);
}

DensityMap sample() {
	DensityMap map(1.0f);
	paint_square(map, "Poppy", 40.0f, -20.0f, 30, 1);
	paint_square(map, "Mädesüß", 40.0f, 500.0f, 10, 2);
	map.need_layer("empty");
	return map;
}

DensityFault read(const std::vector<uint8_t> &bytes, DensityMap &map) {
	return read_density(bytes.data(), bytes.size(), map);
}

/// Corrects the checksum.
void seal(std::vector<uint8_t> &bytes) {
	const uint32_t sum = checksum_of(bytes.data(), bytes.size() - 4);
	std::memcpy(bytes.data() + bytes.size() - 4, &sum, 4);
}

} // namespace

TEST_CASE("a written map is read unchanged") {
	const DensityMap map = sample();
	DensityMap read_back;
	REQUIRE(read(write_density(map), read_back) == DensityFault::none);
	CHECK(read_back.cell_size() == 1.0f);
	CHECK(read_back.layer_name(1) == "Mädesüß");
	CHECK(read_back.layer_count() == 3);
	CHECK(are_the_same(map, read_back));
	for (int row = -60; row < 60; row++) {
		for (int column = -60; column < 60; column++) {
			REQUIRE(read_back.cell(0, column, row) == map.cell(0, column, row));
		}
	}
}

TEST_CASE("a map with jitter is read unchanged, and without it has the bytes of before") {
	DensityMap map = sample();
	const std::vector<uint8_t> before = write_density(map);
	const DensityBrush disc = { { -20.0f, -20.0f }, 9.0f, 0.7f };
	paint(map, 0, disc, { DensityStroke::Does::set_scale_jitter, 0.5f, 1.0f });
	paint(map, 0, { { 2000.0f, 0.0f }, 2.0f, 0.0f }, { DensityStroke::Does::set_color_jitter, 0.5f, 1.0f });
	DensityMap found;
	REQUIRE(read(write_density(map), found) == DensityFault::none);
	CHECK(are_the_same(map, found));
	CHECK(found.cell(0, -20, -20) == map.cell(0, -20, -20));
	CHECK(found.cell(0, -20, -20).scale_range() == doctest::Approx(0.5f).epsilon(0.01));
	CHECK(found.cell(0, 2000, 0).color_range() == doctest::Approx(0.5f).epsilon(0.01));
	paint(map, 0, { { 2000.0f, 0.0f }, 2.0f, 0.0f }, { DensityStroke::Does::set_color_jitter, 0.0f, 1.0f });
	CHECK(bool(write_density(map) != before));
	paint(map, 0, { { -20.0f, -20.0f }, 10.0f, 0.0f }, { DensityStroke::Does::set_scale_jitter, 0.0f, 1.0f });
	CHECK(bool(write_density(map) == before));
}

TEST_CASE("paint at the coordinate limits is read unchanged") {
	DensityMap map;
	const int layer = map.need_layer("Grass");
	const float end = FARTHEST_COORDINATE;
	const CellRange all = map.cells_around({ { -end, -end }, { end, end } });
	for (const int column : { all.first_column, all.last_column }) {
		for (const int row : { all.first_row, all.last_row }) {
			map.set_cell(layer, column, row, { 9, 64 });
		}
	}
	DensityMap found;
	REQUIRE(read(write_density(map), found) == DensityFault::none);
	CHECK(are_the_same(map, found));
}

TEST_CASE("equal cells give equal bytes, for any painting and erasing before") {
	DensityMap map = sample();
	const std::vector<uint8_t> before = write_density(map);
	const int layer = map.find_layer("Poppy");
	paint(map, layer, { { 900.0f, 900.0f }, 5.0f, 0.0f }, { DensityStroke::Does::add, 1.0f, 1.0f });
	paint(map, layer, { { 900.0f, 900.0f }, 6.0f, 0.0f }, { DensityStroke::Does::add, -1.0f, 1.0f });
	CHECK(write_density(map) == before);
}

TEST_CASE("the bytes of a map are the same on every machine") {
	DensityMap map;
	const int layer = map.need_layer("Poppy");
	for (int i = 0; i < 100; i++) {
		map.set_cell(layer, i % 40 - 20, i / 7 - 7, { static_cast<uint8_t>(37 * i), static_cast<uint8_t>(4 + i) });
	}
	const std::vector<uint8_t> bytes = write_density(map);
	CHECK(bytes.size() == GOLDEN_SIZE);
	CHECK(GoldenHash().add(bytes).value() == GOLDEN_BYTES);
}

TEST_CASE("a painted hectare of a species needs at most 100 KiB") {
	DensityMap map;
	paint_square(map, "Poppy", 100.0f, 0.0f, 1500, 3);
	const std::size_t strokes = write_density(map).size();
	MESSAGE("strokes: " << strokes);
	CHECK(strokes <= HECTARE_BYTES);
	// Even if no two neighbours are equal.
	for (int row = 0; row < 200; row++) {
		for (int column = 0; column < 200; column++) {
			const uint64_t bits = mix_bits(static_cast<uint64_t>(200 * row + column));
			map.set_cell(0, column - 100, row - 100, { static_cast<uint8_t>(bits), static_cast<uint8_t>(bits >> 8) });
		}
	}
	const std::size_t noise = write_density(map).size();
	MESSAGE("noise: " << noise);
	CHECK(noise <= HECTARE_BYTES);
}

TEST_CASE("an evenly painted hectare needs a few hundred bytes per species") {
	DensityMap map;
	fill_polygon(map, map.need_layer("Poppy"), rectangle({ 100.0f, 100.0f }), 0.7f);
	const std::size_t size = write_density(map).size();
	MESSAGE("even: " << size);
	CHECK(size <= 4096);
}

TEST_CASE("zero bytes are an empty map") {
	DensityMap map = sample();
	CHECK(read({}, map) == DensityFault::none);
	CHECK(map.layer_count() == 0);
}

TEST_CASE("bytes that are not a map have a fault and change nothing") {
	DensityMap map = sample();
	const std::vector<uint8_t> whole = write_density(map);
	CHECK(read({ 1, 2, 3 }, map) == DensityFault::not_a_map);
	CHECK(read(std::vector<uint8_t>(100, 7), map) == DensityFault::not_a_map);
	std::vector<uint8_t> later = whole;
	later[4] = 4;
	CHECK(read(later, map) == DensityFault::later_version);
	std::vector<uint8_t> none = whole;
	none[4] = 0;
	CHECK(read(none, map) == DensityFault::torn);
	for (std::size_t length = 4; length < whole.size(); length += 13) {
		const std::vector<uint8_t> torn(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
		REQUIRE(read(torn, map) == DensityFault::torn);
	}
	CHECK(write_density(map) == whole);
}

TEST_CASE("a changed byte is detected") {
	DensityMap map = sample();
	const std::vector<uint8_t> whole = write_density(map);
	for (std::size_t at = 0; at < whole.size(); at += 5) {
		std::vector<uint8_t> bytes = whole;
		bytes[at] ^= 0x11u;
		REQUIRE(read(bytes, map) != DensityFault::none);
	}
	CHECK(write_density(map) == whole);
}

TEST_CASE("reading any bytes ends, and gives a valid map or a fault") {
	const std::vector<uint8_t> whole = write_density(sample());
	int sound = 0;
	for (uint64_t seed = 0; seed < 3000; seed++) {
		std::vector<uint8_t> bytes = whole;
		for (uint64_t i = 0; i < 1 + seed % 4; i++) {
			const uint64_t bits = mix_bits(mix_bits(seed) + i);
			bytes[10 + bits % (bytes.size() - 14)] = static_cast<uint8_t>(bits >> 32);
		}
		seal(bytes);
		DensityMap map;
		if (read(bytes, map) == DensityFault::none) {
			sound++;
			DensityMap again;
			REQUIRE(read(write_density(map), again) == DensityFault::none);
		}
	}
	CHECK(sound > 0);
	CHECK(sound < 3000);
}

TEST_CASE("all faults describe the remedy") {
	for (const DensityFault fault :
			{ DensityFault::not_a_map, DensityFault::later_version, DensityFault::torn, DensityFault::none }) {
		CHECK(std::strlen(describe(fault)) > 10);
	}
}
