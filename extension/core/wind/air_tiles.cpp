#include "wind/air_tiles.hpp"

#include "base/portable_math.hpp"
#include "base/random.hpp"
#include "conventions.hpp"
#include "wind/air_profile.hpp"
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

/// Distribution across the wind of the waves of one length along it. Row j and its mirror have the same share.
class Spread {
public:
	/// For a coherence of two points of exp(-10·√(f² + (0.12/L)²)·distance), with the frequency `f` (1/m): the share of
	/// each row is the integral of a Lorentz curve.
	static Spread exponential(double f) {
		constexpr double DECAY = 10.0 / (2.0 * PI);
		constexpr double LONGEST = 0.12 / (8.1 * 0.7 * REFERENCE_HEIGHT); // IEC 61400-1, at 10 m.
		constexpr double MAP_SIDE = AirTiles::HEIGHT * AirTiles::SIDE_STEP;
		const double width = DECAY * std::sqrt(f * f + LONGEST * LONGEST);
		Spread spread;
		double below = 0.0;
		for (int k = 0; k < ROWS; k++) {
			const double above = portable_atan2((k + 0.5) / MAP_SIDE, width);
			spread.shares[k] = k == 0 ? 2.0 * above : above - below;
			below = above;
		}
		spread.divide_by(2.0 * below - spread.shares[ROWS - 1]);
		return spread;
	}

	/// Of eddies: a Gaussian, with less than the wave's own frequency, and no wider than WIDEST.
	static Spread of_eddies(double f) {
		constexpr double SLENDER = 0.5;
		constexpr double WIDEST = 0.0015; // 1/m.
		constexpr double MAP_SIDE = AirTiles::HEIGHT * AirTiles::EDDY_SIDE_STEP;
		const double square = SLENDER * SLENDER * f * f + WIDEST * WIDEST;
		Spread spread;
		double sum = 0.0;
		for (int k = 0; k < ROWS; k++) {
			const double across = k / MAP_SIDE;
			spread.shares[k] = portable_exp(-0.5 * across * across / square);
			sum += k == 0 || k == ROWS - 1 ? spread.shares[k] : 2.0 * spread.shares[k];
		}
		spread.divide_by(sum);
		return spread;
	}

	double of_row(int j) const { return shares[j <= AirTiles::HEIGHT / 2 ? j : AirTiles::HEIGHT - j]; }

private:
	static constexpr int ROWS = AirTiles::HEIGHT / 2 + 1;
	double shares[ROWS];

	void divide_by(double sum) {
		for (double &share : shares) {
			share /= sum;
		}
	}
};

/// Variances of the waves of both components.
struct TurbulencePowers {
	Powers along = Powers(static_cast<std::size_t>(AirTiles::WIDTH * AirTiles::HEIGHT));
	Powers across = along;
};

/// 1/(1 + slow·f)^(5/3), Kaimal's spectra for a length of slow/33 m (along the wind) or slow/9.5 m (across it).
double kaimal(double slow, double f) {
	return portable_pow(1.0 + slow * f, -5.0 / 3.0);
}

template <class SpreadOf, class AlongOf, class AcrossOf>
TurbulencePowers powers_of(
		double length, const SpreadOf &spread_of, const AlongOf &along_of, const AcrossOf &across_of) {
	TurbulencePowers powers;
	for (int i = 1; i < AirTiles::WIDTH / 2; i++) {
		const double f = i / length;
		const Spread spread = spread_of(f);
		const double along = along_of(f);
		const double across = across_of(f);
		for (int j = 0; j < AirTiles::HEIGHT; j++) {
			powers.along[at(i, j, AirTiles::WIDTH)] = along * spread.of_row(j);
			powers.across[at(i, j, AirTiles::WIDTH)] = across * spread.of_row(j);
		}
	}
	prepare(powers.along, AirTiles::WIDTH, AirTiles::HEIGHT);
	prepare(powers.across, AirTiles::WIDTH, AirTiles::HEIGHT);
	return powers;
}

// The lengths of both maps and eddy_amount() were fitted together, so that their sum is within 25 % of Kaimal's spectra
// at heights from 0.5 to 10 m, for reduced frequencies from 0.01 to 1.

TurbulencePowers turbulence_powers() {
	constexpr double ALONG = 24.0; // m.
	constexpr double ACROSS = 5.5;
	return powers_of(
			AirTiles::WIDTH * AirTiles::LENGTH_STEP, Spread::exponential, [](double f) { return kaimal(ALONG, f); },
			[](double f) { return kaimal(ACROSS, f); });
}

TurbulencePowers eddy_powers() {
	constexpr double ALONG = 280.0; // m.
	constexpr double ACROSS = 70.0;
	constexpr double SHORTEST_ALONG = 0.2; // 1/m: shorter waves are those of the other map.
	constexpr double SHORTEST_ACROSS = 0.3;
	constexpr double MAP_LENGTH = AirTiles::WIDTH * AirTiles::EDDY_LENGTH_STEP;
	// The longest wave also has the variance of all that are longer than the map.
	const auto along_of = [](double f) {
		constexpr double END = 1.5 / MAP_LENGTH;
		const double longest = 1.5 * MAP_LENGTH * (1.0 - portable_pow(1.0 + ALONG * END, -2.0 / 3.0)) / ALONG;
		return f < END ? longest : kaimal(ALONG, f) / (1.0 + f / SHORTEST_ALONG);
	};
	return powers_of(MAP_LENGTH, Spread::of_eddies, along_of,
			[](double f) { return kaimal(ACROSS, f) / (1.0 + f / SHORTEST_ACROSS); });
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

/// Adds a wave and its mirror, which has the opposite phase, as those of a real map, which is the real or the imaginary
/// part of the grid's.
void add_wave(ComplexGrid &grid, int i, int j, double size, double angle, bool is_imaginary) {
	const std::size_t wave = at(i, j, grid.width);
	const std::size_t mirror = at(grid.width - i, (grid.height - j) % grid.height, grid.width);
	const double c = size * portable_cos(angle);
	const double s = size * portable_sin(angle);
	grid.real[wave] += is_imaginary ? -s : c;
	grid.imaginary[wave] += is_imaginary ? c : s;
	grid.real[mirror] += is_imaginary ? s : c;
	grid.imaginary[mirror] += is_imaginary ? c : -s;
}

/// Adds a real map of waves with random phases.
void add_waves(ComplexGrid &grid, const Powers &powers, uint64_t stream, bool is_imaginary) {
	for (int j = 0; j < grid.height; j++) {
		for (int i = 1; i < grid.width / 2; i++) {
			const std::size_t wave = at(i, j, grid.width);
			add_wave(grid, i, j, std::sqrt(0.5 * powers[wave]), random_angle(stream, wave), is_imaginary);
		}
	}
}

/// Adds both components with the phases of one stream function ψ: u = ∂ψ/∂n and v = -∂ψ/∂s. Waves without a slope
/// across the wind have no u of it, so their phases differ.
void add_swirls(ComplexGrid &grid, const TurbulencePowers &powers, uint64_t stream) {
	for (int j = 0; j < grid.height; j++) {
		const int row = signed_row(j, grid.height);
		for (int i = 1; i < grid.width / 2; i++) {
			const std::size_t wave = at(i, j, grid.width);
			const double angle = random_angle(stream, wave);
			const double turned = row > 0 ? angle + PI : angle;
			const bool is_free = row == 0 || 2 * j == grid.height;
			add_wave(grid, i, j, std::sqrt(0.5 * powers.along[wave]), angle, false);
			add_wave(grid, i, j, std::sqrt(0.5 * powers.across[wave]),
					is_free ? random_angle(stream + 1, wave) : turned, true);
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

/// The real part along the wind, the imaginary one across it.
std::vector<uint64_t> cells_of(ComplexGrid &waves) {
	sum_waves(waves);
	std::vector<uint64_t> cells(2 * waves.real.size());
	write_cells(texels_of(waves.real), AirTiles::WIDTH, AirTiles::HEIGHT, 2, &cells[0]);
	write_cells(texels_of(waves.imaginary), AirTiles::WIDTH, AirTiles::HEIGHT, 2, &cells[1]);
	return cells;
}

std::vector<uint64_t> make_turbulence(uint64_t seed) {
	ComplexGrid grid(AirTiles::WIDTH, AirTiles::HEIGHT);
	const TurbulencePowers powers = turbulence_powers();
	add_waves(grid, powers.along, seed + 1, false);
	add_waves(grid, powers.across, seed + 2, true);
	return cells_of(grid);
}

std::vector<uint64_t> make_eddies(uint64_t seed) {
	ComplexGrid grid(AirTiles::WIDTH, AirTiles::HEIGHT);
	add_swirls(grid, eddy_powers(), seed + 4);
	return cells_of(grid);
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
	tiles->eddies = make_eddies(seed);
	tiles->waves = make_waves(seed);
	return tiles;
}

} // namespace undergrowth
