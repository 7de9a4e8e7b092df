#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace undergrowth {

/// Wind that was frozen, to be carried along: two periodic maps of normal deviates, whatever the wind's speed. Read
/// between their texels with weights by distance, both have a variance of 1.
///
/// Turbulence, along the wind and across it: the spectra of Kaimal et al. (1972) by the wave's length over the height
/// (1 m here), coherent across the wind by IEC 61400-1's exponential law. The rows that a place sees go across, so that
/// it does not see the same ones again for long.
///
/// Waves over a stand (honami) by the analogy with a mixing layer (Raupach, Finnigan and Brunet 1996): a band of waves
/// about one length.
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

	/// A cell is what a place between four texels needs: 16 bits of each, lowest first, of the texel, its neighbour
	/// downwind, and both a row farther. Of the turbulence: WIDTH·HEIGHT times a cell of what is along the wind, and
	/// one of what is across it.
	std::vector<uint64_t> turbulence;
	/// WAVES_WIDTH·WAVES_HEIGHT.
	std::vector<uint64_t> waves;
};

/// The same bytes for a seed on every platform. Takes about 100 ms; 4.3 MB.
std::shared_ptr<const AirTiles> make_air_tiles(uint64_t seed);

/// How much of the variance reading between texels loses of a wave with so many waves per texel.
double reading_loss(double waves_per_texel);

} // namespace undergrowth
