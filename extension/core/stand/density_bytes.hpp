#pragma once

#include "stand/density_map.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace undergrowth {

/// Why bytes are no map: a BytesFault.
enum class DensityFault {
	none,
	not_a_map,
	later_version, ///< Written by a later release.
	torn, ///< Cut off, or not as they were written.
};

/// One sentence for whoever opens them.
const char *describe(DensityFault fault);

/// A map as bytes, the same for the same cells on every machine. All numbers are little-endian: "UGDM", the version
/// (16 bits), the length of all (32 bits), the cell's size (a float), the number of layers (16 bits); for each its name
/// (its length in 8 bits) and the number of its blocks (32 bits); for each block its column and its row (32 bits each,
/// by ascending column and row), its densities and its heights; in version 2 also the lower and the higher bytes of its
/// plants/m²; then FNV-1a (32 bits) of all before. Each of them is made of runs: a byte n below 128 and n + 1 codes, or
/// n from 128 on and one code that is there n - 125 times. Version 1, which release 0.2 reads, is written where no cell
/// has plants/m².
std::vector<uint8_t> write_density(const DensityMap &map);

/// Reads what write_density() wrote. Where there is a fault `map` stays as it is. No bytes at all are an empty map.
DensityFault read_density(const uint8_t *bytes, std::size_t count, DensityMap &map);

} // namespace undergrowth
