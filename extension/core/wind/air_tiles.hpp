#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace undergrowth {

/// Frozen wind: two periodic maps of normal deviates, independent of the wind's speed. With bilinear interpolation both
/// have a variance of 1.
///
/// Turbulence, along the wind and across it: the spectra of Kaimal et al. (1972) by the wave's length over the height
/// (1 m here), coherent across the wind by IEC 61400-1's exponential law. The rows are
/// read obliquely, so that a position repeats only after a long time.
///
/// Waves over a canopy (honami) by the analogy with a mixing layer (Raupach, Finnigan and Brunet 1996): a narrow band
/// of wavelengths.
struct AirTiles {
	static constexpr int WIDTH = 1024; ///< Texels along the wind.
	static constexpr int HEIGHT = 256; ///< Across.
	static constexpr double LENGTH_STEP = 0.25; ///< m, between texels along the wind.
	static constexpr double SIDE_STEP = 0.5; ///< m.
	static constexpr int WAVES_WIDTH = 256;
	static constexpr int WAVES_HEIGHT = 128;
	static constexpr int WAVE_TEXELS = 16; ///< Along the wind, of a wave's length.
	static constexpr int WAVE_SIDE_TEXELS = 8; ///< Across, of as many metres.
	static constexpr double UNIT = 4096.0; ///< Of both maps: a standard deviation.

	/// A cell has the four texels of one interpolation, 16 bits each, lowest first: the texel, its neighbour downwind,
	/// and the same two of the next row. Turbulence: WIDTH·HEIGHT pairs of a cell along the wind and one across it.
	std::vector<uint64_t> turbulence;
	/// WAVES_WIDTH·WAVES_HEIGHT.
	std::vector<uint64_t> waves;
};

/// Returns the same bytes for a seed on every platform. Takes about 100 ms; 4.3 MB.
std::shared_ptr<const AirTiles> make_air_tiles(uint64_t seed);

/// Fraction of a wave's variance that interpolation loses at `waves_per_texel`.
double reading_loss(double waves_per_texel);

} // namespace undergrowth
