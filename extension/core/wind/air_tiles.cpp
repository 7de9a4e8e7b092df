#include "wind/air_tiles.hpp"

#include "base/portable_math.hpp"
#include "base/random.hpp"
#include "conventions.hpp"
#include "wind/fourier.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace undergrowth {

namespace {

constexpr double MAX_DEVIATE = 32767.0;

/// Variances of the waves of one half of a map; the other half mirrors it.
using Powers = std::vector<double>;

std::size_t at(int i, int j, int width) {
	return static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i);
}

/// Waves per map across the wind, for row j.
int signed_row(int j, int height) {
	return j < height / 2 ? j : j - height;
}

/// Scales the variances of all waves to a sum of 1, then raises each by its loss from reading between texels.
void prepare(Powers &powers, int width, int height) {
	double sum = 0.0;
	for (const double power : powers) {
		sum += power;
	}
	std::vector<double> along;
	for (int i = 0; i < width / 2; i++) {
		along.push_back(reading_loss(static_cast<double>(i) / width));
	}
	for (int j = 0; j < height; j++) {
		const double across = sum * reading_loss(static_cast<double>(j) / height);
		for (int i = 1; i < width / 2; i++) {
			powers[at(i, j, width)] /= across * along[static_cast<std::size_t>(i)];
		}
	}
}

/// Distribution across the wind of the waves of one length along it, for a coherence of two points of exp(-12·√(f² +
/// (0.12/5.67)²)·distance). The share of each row is the integral of a Lorentz curve.
class Spread {
public:
	explicit Spread(double f) {
		constexpr double DECAY = 12.0 / (2.0 * PI);
		constexpr double LONGEST = 0.12 / 5.67; // IEC 61400-1: of the height over the scale, for heights below 60 m.
		constexpr double MAP_SIDE = AirTiles::HEIGHT * AirTiles::SIDE_STEP;
		const double width = DECAY * std::sqrt(f * f + LONGEST * LONGEST);
		double below = 0.0;
		for (int k = 0; k <= AirTiles::HEIGHT / 2; k++) {
			const double above = portable_atan2((k + 0.5) / MAP_SIDE, width);
			shares[k] = k == 0 ? 2.0 * above : above - below;
			below = above;
		}
		const double sum = 2.0 * below - shares[AirTiles::HEIGHT / 2];
		for (double &share : shares) {
			share /= sum;
		}
	}

	double of_row(int j) const { return shares[j <= AirTiles::HEIGHT / 2 ? j : AirTiles::HEIGHT - j]; }

private:
	double shares[AirTiles::HEIGHT / 2 + 1];
};

/// Kaimal's spectra, fast/(1 + slow·f)^(5/3), along the wind and across it.
struct TurbulencePowers {
	Powers along = Powers(static_cast<std::size_t>(AirTiles::WIDTH * AirTiles::HEIGHT));
	Powers across = along;
};

TurbulencePowers kaimal_powers() {
	constexpr double MAP_LENGTH = AirTiles::WIDTH * AirTiles::LENGTH_STEP;
	TurbulencePowers powers;
	for (int i = 1; i < AirTiles::WIDTH / 2; i++) {
		const double f = i / MAP_LENGTH;
		const Spread spread(f);
		const double along = portable_pow(1.0 + 33.0 * f, -5.0 / 3.0);
		const double across = portable_pow(1.0 + 9.5 * f, -5.0 / 3.0);
		for (int j = 0; j < AirTiles::HEIGHT; j++) {
			powers.along[at(i, j, AirTiles::WIDTH)] = along * spread.of_row(j);
			powers.across[at(i, j, AirTiles::WIDTH)] = across * spread.of_row(j);
		}
	}
	prepare(powers.along, AirTiles::WIDTH, AirTiles::HEIGHT);
	prepare(powers.across, AirTiles::WIDTH, AirTiles::HEIGHT);
	return powers;
}

/// A band around one wave per length, and around none across.
Powers wave_powers() {
	constexpr double BAND = 0.2;
	constexpr double SIDE_BAND = 0.4;
	Powers powers(static_cast<std::size_t>(AirTiles::WAVES_WIDTH * AirTiles::WAVES_HEIGHT));
	for (int j = 0; j < AirTiles::WAVES_HEIGHT; j++) {
		const int row = signed_row(j, AirTiles::WAVES_HEIGHT);
		const double across =
				static_cast<double>(row * AirTiles::WAVE_SIDE_TEXELS) / AirTiles::WAVES_HEIGHT / SIDE_BAND;
		for (int i = 1; i < AirTiles::WAVES_WIDTH / 2; i++) {
			const double waves = static_cast<double>(i * AirTiles::WAVE_TEXELS) / AirTiles::WAVES_WIDTH;
			const double along = (waves - 1.0) / BAND;
			powers[at(i, j, AirTiles::WAVES_WIDTH)] = portable_exp(-0.5 * (along * along + across * across));
		}
	}
	prepare(powers, AirTiles::WAVES_WIDTH, AirTiles::WAVES_HEIGHT);
	return powers;
}

double random_angle(uint64_t stream, std::size_t index) {
	constexpr double TURN = 2.0 * PI / 9007199254740992.0; // Over 2^53.
	return static_cast<double>(mix_bits(mix_bits(stream) ^ index) >> 11) * TURN;
}

/// Adds a real map as the real or the imaginary part of the grid's waves. Each wave has a random phase, and its mirror
/// the opposite phase.
void add_waves(ComplexGrid &grid, const Powers &powers, uint64_t stream, bool is_imaginary) {
	for (int j = 0; j < grid.height; j++) {
		for (int i = 1; i < grid.width / 2; i++) {
			const std::size_t wave = at(i, j, grid.width);
			const std::size_t mirror = at(grid.width - i, (grid.height - j) % grid.height, grid.width);
			const double size = std::sqrt(0.5 * powers[wave]);
			const double angle = random_angle(stream, wave);
			const double c = size * portable_cos(angle);
			const double s = size * portable_sin(angle);
			grid.real[wave] += is_imaginary ? -s : c;
			grid.imaginary[wave] += is_imaginary ? c : s;
			grid.real[mirror] += is_imaginary ? s : c;
			grid.imaginary[mirror] += is_imaginary ? c : -s;
		}
	}
}

uint16_t texel_of(double deviate) {
	const double bounded = std::clamp(deviate * AirTiles::UNIT, -MAX_DEVIATE, MAX_DEVIATE);
	return static_cast<uint16_t>(static_cast<int32_t>(std::floor(bounded + 0.5)));
}

std::vector<uint16_t> texels_of(const std::vector<double> &deviates) {
	std::vector<uint16_t> texels(deviates.size());
	std::transform(deviates.begin(), deviates.end(), texels.begin(), texel_of);
	return texels;
}

/// Writes the cells of a map, each `apart` numbers after the last.
void write_cells(const std::vector<uint16_t> &texels, int width, int height, std::size_t apart, uint64_t *cells) {
	for (int j = 0; j < height; j++) {
		const uint16_t *near = &texels[at(0, j, width)];
		const uint16_t *far = &texels[at(0, (j + 1) % height, width)];
		for (int i = 0; i < width; i++) {
			const int next = (i + 1) % width;
			*cells = static_cast<uint64_t>(near[i]) | static_cast<uint64_t>(near[next]) << 16 |
					static_cast<uint64_t>(far[i]) << 32 | static_cast<uint64_t>(far[next]) << 48;
			cells += apart;
		}
	}
}

std::vector<uint64_t> make_turbulence(uint64_t seed) {
	ComplexGrid grid(AirTiles::WIDTH, AirTiles::HEIGHT);
	const TurbulencePowers powers = kaimal_powers();
	add_waves(grid, powers.along, seed + 1, false);
	add_waves(grid, powers.across, seed + 2, true);
	sum_waves(grid);
	std::vector<uint64_t> cells(2 * grid.real.size());
	write_cells(texels_of(grid.real), AirTiles::WIDTH, AirTiles::HEIGHT, 2, &cells[0]);
	write_cells(texels_of(grid.imaginary), AirTiles::WIDTH, AirTiles::HEIGHT, 2, &cells[1]);
	return cells;
}

std::vector<uint64_t> make_waves(uint64_t seed) {
	ComplexGrid grid(AirTiles::WAVES_WIDTH, AirTiles::WAVES_HEIGHT);
	add_waves(grid, wave_powers(), seed + 3, false);
	sum_waves(grid);
	std::vector<uint64_t> cells(grid.real.size());
	write_cells(texels_of(grid.real), grid.width, grid.height, 1, cells.data());
	return cells;
}

} // namespace

double reading_loss(double waves_per_texel) {
	return (2.0 + portable_cos(2.0 * PI * waves_per_texel)) / 3.0;
}

std::shared_ptr<const AirTiles> make_air_tiles(uint64_t seed) {
	const auto tiles = std::make_shared<AirTiles>();
	tiles->turbulence = make_turbulence(seed);
	tiles->waves = make_waves(seed);
	return tiles;
}

} // namespace undergrowth
