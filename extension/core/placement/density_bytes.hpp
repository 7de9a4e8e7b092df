#pragma once

#include "placement/density_map.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace undergrowth {

/// Reason that bytes are not a map: a BytesFault.
enum class DensityFault {
	none,
	not_a_map,
	later_version, ///< Written by a later release.
	torn, ///< Truncated or damaged.
};

/// One sentence for the user.
const char *describe(DensityFault fault);

/// Returns a map as bytes, the same for the same cells on every machine. All numbers are little-endian.
/// Header: "UGDM", version (16 bits), total length (32 bits), cell size (float), number of layers (16 bits).
/// Each layer: name (its length in 8 bits) and number of blocks (32 bits).
/// Each block: column and row (32 bits each), densities, heights; ascending by column and row. Version 2 adds the lower
/// and then the higher bytes of its plants/m². Version 3 also adds its jitter of scale, and then of color.
/// End: FNV-1a (32 bits) of everything before.
/// The arrays of a block consist of runs. A byte n below 128 is followed by n + 1 codes. A byte n from 128 on is
/// followed by one code that repeats n - 125 times. A map has the lowest version that contains its values: release 0.2
/// reads version 1.
std::vector<uint8_t> write_density(const DensityMap &map);

/// Reads the output of write_density(). After a fault `map` is unchanged. No bytes at all are an empty map.
DensityFault read_density(const uint8_t *bytes, std::size_t count, DensityMap &map);

} // namespace undergrowth
