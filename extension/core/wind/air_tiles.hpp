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

	static constexpr int ROW =
			WIDTH + 8; ///< Texels of a row of the turbulence; the last ones are the first ones again.

	/// ROW·HEIGHT pairs of 16 bits: along the wind in the low ones, across it in the high ones.
	std::vector<uint32_t> turbulence;
	/// WAVES_WIDTH·WAVES_HEIGHT pairs: a texel in the low bits, its neighbour downwind in the high ones.
	std::vector<uint32_t> waves;
};

/// The same bytes for a seed on every platform. Takes about 60 ms.
std::shared_ptr<const AirTiles> make_air_tiles(uint64_t seed);

/// How much of the variance reading between texels loses of a wave with so many waves per texel.
double reading_loss(double waves_per_texel);

} // namespace undergrowth
