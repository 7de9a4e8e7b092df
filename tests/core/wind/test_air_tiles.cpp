#include "../golden.hpp"
#include "air_series.hpp"

#include "wind/fourier.hpp"

#include <doctest/doctest.h>

using namespace undergrowth;

TEST_CASE("the maps of a seed have the same bytes on every platform") {
	constexpr uint64_t TURBULENCE_GOLDEN = 0xf4c1e0df9de0b42dull;
	constexpr uint64_t EDDIES_GOLDEN = 0x96ca05d94bd6a059ull;
	constexpr uint64_t WAVES_GOLDEN = 0x224de7c8ba050959ull;
	CHECK(GoldenHash().add(shared_tiles().turbulence).value() == TURBULENCE_GOLDEN);
	CHECK(GoldenHash().add(shared_tiles().eddies).value() == EDDIES_GOLDEN);
	CHECK(GoldenHash().add(shared_tiles().waves).value() == WAVES_GOLDEN);
	CHECK(make_air_tiles(1)->turbulence != shared_tiles().turbulence);
}

TEST_CASE("the transform gives each position the sum of all waves") {
	ComplexGrid grid(16, 8);
	for (std::size_t i = 0; i < grid.real.size(); i++) {
		grid.real[i] = std::sin(1.7 * static_cast<double>(i));
		grid.imaginary[i] = std::cos(2.3 * static_cast<double>(i));
	}
	const ComplexGrid waves = grid;
	sum_waves(grid);
	for (int y = 0; y < 8; y++) {
		for (int x = 0; x < 16; x++) {
			double real = 0.0, imaginary = 0.0;
			for (int j = 0; j < 8; j++) {
				for (int i = 0; i < 16; i++) {
					const double angle = 2.0 * 3.14159265358979323846 * (i * x / 16.0 + j * y / 8.0);
					const auto k = static_cast<std::size_t>(16 * j + i);
					real += waves.real[k] * std::cos(angle) - waves.imaginary[k] * std::sin(angle);
					imaginary += waves.real[k] * std::sin(angle) + waves.imaginary[k] * std::cos(angle);
				}
			}
			const auto place = static_cast<std::size_t>(16 * y + x);
			REQUIRE(std::fabs(grid.real[place] - real) < 1e-12);
			REQUIRE(std::fabs(grid.imaginary[place] - imaginary) < 1e-12);
		}
	}
}

TEST_CASE("a cell has a texel and its neighbours downwind and one row farther, around the map") {
	const auto check_map = [](const std::vector<uint64_t> &cells, int width, int height, int apart, int first) {
		const auto cell = [&](int i, int j) {
			return cells[static_cast<std::size_t>((j % height * width + i % width) * apart + first)];
		};
		for (int j = 0; j < height; j++) {
			for (int i = 0; i < width; i++) {
				const uint64_t downwind = (cell(i, j) >> 16) & 0xffffu;
				const uint64_t farther = cell(i, j) >> 32;
				REQUIRE(downwind == (cell(i + 1, j) & 0xffffu));
				REQUIRE(farther == (cell(i, j + 1) & 0xffffffffu));
			}
		}
	};
	check_map(shared_tiles().waves, AirTiles::WAVES_WIDTH, AirTiles::WAVES_HEIGHT, 1, 0);
	for (const std::vector<uint64_t> *cells : { &shared_tiles().turbulence, &shared_tiles().eddies }) {
		check_map(*cells, AirTiles::WIDTH, AirTiles::HEIGHT, 2, 0);
		check_map(*cells, AirTiles::WIDTH, AirTiles::HEIGHT, 2, 1);
	}
}
