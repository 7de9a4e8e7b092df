#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace undergrowth {

/// Frozen wind: periodic maps of normal deviates, independent of the wind's speed. With bilinear interpolation all have
/// a variance of 1.
///
/// Turbulence and eddies, along the wind and across it: two ranges of the spectra of Kaimal et al. (1972). `turbulence`
/// has waves to 256 m, coherent across the wind by IEC 61400-1's exponential law. `eddies` has waves from 8 m to 4 km,
/// about as wide as they are long. Their two components have the phases of one stream function, so eddies are swirls.
/// With eddy_amount(), the sum has Kaimal's spectrum at each height.
///
/// Waves over a canopy (honami) by the analogy with a mixing layer (Raupach, Finnigan and Brunet 1996): a narrow band
/// of wavelengths.
struct AirTiles {
	static constexpr int WIDTH = 1024; ///< Texels along the wind.
	static constexpr int HEIGHT = 256; ///< Across.
	static constexpr double LENGTH_STEP = 0.25; ///< m, between texels along the wind.
	static constexpr double SIDE_STEP = 0.5; ///< m.
	static constexpr double EDDY_LENGTH_STEP = 4.0; ///< m, of as many texels of the eddies.
	static constexpr double EDDY_SIDE_STEP = 16.0; ///< m.
	static constexpr int WAVES_WIDTH = 256;
	static constexpr int WAVES_HEIGHT = 128;
	static constexpr int WAVE_TEXELS = 16; ///< Along the wind, of a wave's length.
	static constexpr int WAVE_SIDE_TEXELS = 8; ///< Across, of as many metres.
	static constexpr double UNIT = 4096.0; ///< Of all maps: a standard deviation.

	/// A cell has the four texels of one interpolation, 16 bits each, lowest first: the texel, its neighbour downwind,
	/// and the same two of the next row. Turbulence: WIDTH·HEIGHT pairs of a cell along the wind and one across it.
	std::vector<uint64_t> turbulence;
	/// The same of the eddies.
	std::vector<uint64_t> eddies;
	/// WAVES_WIDTH·WAVES_HEIGHT.
	std::vector<uint64_t> waves;
};

/// Returns the same bytes for a seed on every platform. Takes about 200 ms; 8.5 MB.
std::shared_ptr<const AirTiles> make_air_tiles(uint64_t seed);

/// Fraction of a wave's variance that interpolation loses at `waves_per_texel`.
double reading_loss(double waves_per_texel);

} // namespace undergrowth
