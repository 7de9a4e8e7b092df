#pragma once

#include "base/byte_codec.hpp"
#include "placement/edit_log.hpp"

#include <glm/vec2.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace undergrowth {

/// A plant that code added, with its id.
struct AddedPlant {
	PlantId id = NO_PLANT;
	PlacedPlant plant; ///< Its species is an index in SavedEdits::species.
};

/// A plant with a lasting bend.
struct TroddenPlant {
	PlantId id = NO_PLANT;
	glm::vec2 bend = { 0.0f, 0.0f }; ///< As in LastingBends; at most MAX_TRODDEN_BEND long.
};

inline constexpr float MAX_TRODDEN_BEND = 1.0f;

/// All edits of a field by code, as saved, and its trodden plants.
struct SavedEdits {
	EditLog edits;
	std::optional<int64_t> seed; ///< Of the field. Bytes of version 1 lack it.
	std::vector<std::string> species; ///< Names of the species of added plants, at most 255 bytes each.
	std::vector<AddedPlant> added;
	std::vector<TroddenPlant> trodden; ///< Any order, without duplicates. Written only with a seed.
};

/// One sentence for the user: the error and its remedy.
const char *describe_edits_fault(BytesFault fault);

/// Writes edits in a ByteFrame of "UGSC"; equal edits give equal bytes on every machine. Content:
/// - the seed (64 bits; not in version 1);
/// - the number of spacings; for each the spacing (double), the removed plants, and the mown plants with their heights
///   (65535ths of their own, 16 bits);
/// - the number of species and their names;
/// - the number of added plants; for each its number, species (8 bits), root and scale (floats), turn, height, lean and
///   side as in FieldPlants (16 bits each), variant (8 bits) and mown height;
/// - in version 3 the number of trodden plants, and their bends: the angle (256ths of a turn, 8 bits) and the length
///   (256ths of MAX_TRODDEN_BEND, 8 bits). Bytes without trodden plants have version 2.
/// Ids ascend and are stored as differences. Numbers without a width are counts of put_count(). A removed plant takes 2
/// to 5 bytes in a swath and at most 10.
std::vector<uint8_t> write_edits(const SavedEdits &edits);

/// Reads bytes of write_edits(), of all versions. On a fault `edits` is not modified. Zero bytes are no edits.
BytesFault read_edits(const uint8_t *bytes, std::size_t count, SavedEdits &edits);

} // namespace undergrowth
