#include "../golden.hpp"
#include "air_series.hpp"

#include "wind/fourier.hpp"

#include <doctest/doctest.h>

using namespace undergrowth;

TEST_CASE("the maps of a seed have the same bytes on every platform") {
	constexpr uint64_t TURBULENCE_GOLDEN = 0xfac831083c1475dull;
	constexpr uint64_t WAVES_GOLDEN = 0x6d78c23e35b1d235ull;
	CHECK(GoldenHash().add(shared_tiles().turbulence).value() == TURBULENCE_GOLDEN);
	CHECK(GoldenHash().add(shared_tiles().waves).value() == WAVES_GOLDEN);
	CHECK(make_air_tiles(1)->turbulence != shared_tiles().turbulence);
}

TEST_CASE("summing waves gives each place the sum of all") {
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

TEST_CASE("neighbours along the rows of the waves' map are stored twice alike") {
	const std::vector<uint32_t> &waves = shared_tiles().waves;
	for (int j = 0; j < AirTiles::WAVES_HEIGHT; j++) {
		for (int i = 0; i < AirTiles::WAVES_WIDTH; i++) {
			const auto row = static_cast<std::size_t>(j * AirTiles::WAVES_WIDTH);
			const uint32_t next = waves[row + static_cast<std::size_t>((i + 1) % AirTiles::WAVES_WIDTH)];
			REQUIRE((waves[row + static_cast<std::size_t>(i)] >> 16) == (next & 0xffffu));
		}
	}
}
