#pragma once

#include "base/byte_codec.hpp"
#include "stand/stand_changes.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace undergrowth {

/// A plant that code added, with its name.
struct AddedPlant {
	PlantId id = NO_PLANT;
	PlacedPlant plant; ///< Its species is one of SavedChanges::species.
};

/// All that code changed of a field, as it is saved.
struct SavedChanges {
	StandChanges changes;
	std::optional<int64_t> seed; ///< Of the field. Bytes of version 1 do not tell it.
	std::vector<std::string> species; ///< Names of those that plants were added of, 255 bytes each at most.
	std::vector<AddedPlant> added;
};

/// One sentence for whoever opens such bytes.
const char *describe_changes_fault(BytesFault fault);

/// Changes in a ByteFrame of "UGSC", the same for the same changes on every machine. Then the seed (64 bits), which
/// version 1 lacked; the number of spacings; for
/// each the spacing (a double), those who are gone, and those who are mown, with their heights (65535ths of their own,
/// 16 bits); the number of species, and their names; the number of plants that were added; for each its number, its
/// species (8 bits), its root and scale (floats), turn, height, lean and side as FieldPlants keeps them (16 bits each),
/// its variant (8 bits) and its height, as of those who are mown. Names of plants ascend: each is the difference from
/// the one before. Numbers without a width are counts of put_count(). A plant that is gone takes 2 to 5 bytes in a
/// swath and never more than 10.
std::vector<uint8_t> write_changes(const SavedChanges &changes);

/// Reads what write_changes() wrote, of version 1, too. Where there is a fault `changes` stays as it is. No bytes at
/// all are no changes.
BytesFault read_changes(const uint8_t *bytes, std::size_t count, SavedChanges &changes);

} // namespace undergrowth
