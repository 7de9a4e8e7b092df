#include "placement/edit_log_bytes.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace undergrowth {

namespace {

constexpr char LETTERS[] = "UGSC";
constexpr uint32_t WITHOUT_SEED = 1;
constexpr uint32_t WITH_SEED = 2;
constexpr uint32_t WITH_TRODDEN = 3;
constexpr int SEED_BYTES = 8;
constexpr float SHARE_CODES = 65535.0f;
constexpr double MIN_SPACING = 1.0e-3; ///< m.
constexpr double MAX_SPACING = 1.0e6;

uint64_t code_of_share(float share) {
	return static_cast<uint64_t>(share * SHARE_CODES + 0.5f);
}

float read_share(ByteReader &from) {
	return static_cast<float>(from.number(2)) / SHARE_CODES;
}

/// A list of ids, each written as the difference from the one before.
class NameRun {
public:
	void put(std::vector<uint8_t> &to, PlantId id) {
		put_count(to, static_cast<uint64_t>(id - std::exchange(last, id)));
	}
	PlantId read(ByteReader &from, bool are_added) {
		if (is_added(read(from)) != are_added) {
			from.fail();
		}
		return last;
	}
	PlantId read(ByteReader &from) {
		const uint64_t way = from.count();
		const uint64_t max = static_cast<uint64_t>(added_plant_id(MAX_NUMBER) - last);
		if (way > max || (way == 0 && last != 0)) {
			from.fail();
			return 0;
		}
		last += static_cast<PlantId>(way);
		return last;
	}

private:
	static constexpr int64_t MAX_NUMBER = (int64_t(1) << 61) - 1;
	PlantId last = 0;
};

void put_squares(std::vector<uint8_t> &bytes, const EditLog &edits, const EditLog::Squares &squares) {
	std::vector<PlantId> gone;
	std::vector<MownPlant> mown;
	for (const auto &entry : squares) {
		gone.insert(gone.end(), entry.second->gone.begin(), entry.second->gone.end());
		std::copy_if(entry.second->mown.begin(), entry.second->mown.end(), std::back_inserter(mown),
				[&](const MownPlant &plant) { return edits.share_of(plant.base) < 1.0f; });
	}
	std::sort(gone.begin(), gone.end());
	std::sort(mown.begin(), mown.end());
	put_count(bytes, gone.size());
	NameRun names;
	for (const PlantId id : gone) {
		names.put(bytes, id);
	}
	put_count(bytes, mown.size());
	NameRun mown_names;
	for (const MownPlant &plant : mown) {
		mown_names.put(bytes, plant.id);
		put_number(bytes, code_of_share(edits.share_of(plant.base)), 2);
	}
}

void put_added(std::vector<uint8_t> &bytes, const SavedEdits &saved) {
	std::vector<AddedPlant> added = saved.added;
	std::sort(added.begin(), added.end(), [](const AddedPlant &a, const AddedPlant &b) { return a.id < b.id; });
	put_count(bytes, added.size());
	NameRun names;
	for (const AddedPlant &one : added) {
		FieldPlants codes;
		codes.add(one.plant);
		names.put(bytes, one.id);
		put_number(bytes, codes.species[0], 1);
		for (const float number : { codes.x[0], codes.y[0], codes.z[0], codes.scale[0] }) {
			put_float(bytes, number);
		}
		for (const uint16_t code : { codes.turn[0], codes.height[0], codes.lean[0], codes.side[0] }) {
			put_number(bytes, code, 2);
		}
		put_number(bytes, codes.variant[0], 1);
		put_number(bytes, code_of_share(saved.edits.share_of(one.id, 0.0f, 0.0f)), 2);
	}
}

uint64_t angle_code(const glm::vec2 &bend) {
	const double turns = portable_atan2(static_cast<double>(bend.y), static_cast<double>(bend.x)) / (2.0 * PI);
	return static_cast<uint64_t>(static_cast<int64_t>(std::floor(256.0 * turns + 0.5))) & 0xff;
}

/// At least 1, since a bend of length 0 would not be trodden.
uint64_t length_code(const glm::vec2 &bend) {
	const float share = glm::length(bend) / MAX_TRODDEN_BEND;
	return static_cast<uint64_t>(std::clamp(std::ceil(256.0f * share - 0.5f), 1.0f, 256.0f)) - 1;
}

glm::vec2 bend_of_codes(uint64_t angle, uint64_t length) {
	const SineAndCosine way = portable_sine_and_cosine(2.0 * PI * static_cast<double>(angle) / 256.0);
	const float size = MAX_TRODDEN_BEND * static_cast<float>(length + 1) / 256.0f;
	return size * glm::vec2(static_cast<float>(way.cosine), static_cast<float>(way.sine));
}

void put_trodden(std::vector<uint8_t> &bytes, const SavedEdits &saved) {
	std::vector<TroddenPlant> trodden = saved.trodden;
	std::sort(trodden.begin(), trodden.end(), [](const TroddenPlant &a, const TroddenPlant &b) { return a.id < b.id; });
	put_count(bytes, trodden.size());
	NameRun names;
	for (const TroddenPlant &plant : trodden) {
		names.put(bytes, plant.id);
		put_number(bytes, angle_code(plant.bend), 1);
		put_number(bytes, length_code(plant.bend), 1);
	}
}

void read_trodden(ByteReader &from, SavedEdits &saved) {
	NameRun names;
	for (uint64_t left = from.count(); left > 0 && from.is_sound(); left--) {
		const PlantId id = names.read(from);
		const uint64_t angle = from.number(1);
		saved.trodden.push_back({ id, bend_of_codes(angle, from.number(1)) });
	}
}

void read_squares(ByteReader &from, SavedEdits &saved) {
	const double spacing = from.long_real();
	if (!(spacing >= MIN_SPACING && spacing <= MAX_SPACING)) {
		from.fail();
	}
	std::vector<PlantId> ids;
	NameRun names;
	for (uint64_t left = from.count(); left > 0 && from.is_sound(); left--) {
		ids.push_back(names.read(from, false));
	}
	std::vector<PlantId> mown;
	std::vector<float> shares;
	NameRun mown_names;
	for (uint64_t left = from.count(); left > 0 && from.is_sound(); left--) {
		mown.push_back(mown_names.read(from, false));
		shares.push_back(read_share(from));
	}
	if (from.is_sound()) {
		saved.edits.remove(ids, spacing);
		saved.edits.mow(mown, shares, spacing);
	}
}

void read_added(ByteReader &from, SavedEdits &saved) {
	std::vector<PlantId> ids;
	std::vector<float> shares;
	NameRun names;
	for (uint64_t left = from.count(); left > 0 && from.is_sound(); left--) {
		ids.push_back(names.read(from, true));
		FieldPlants codes;
		codes.resize(1);
		codes.species[0] = static_cast<uint8_t>(from.number(1));
		for (std::vector<float> *column : { &codes.x, &codes.y, &codes.z, &codes.scale }) {
			column->front() = from.real();
		}
		for (std::vector<uint16_t> *column : { &codes.turn, &codes.height, &codes.lean, &codes.side }) {
			column->front() = static_cast<uint16_t>(from.number(2));
		}
		codes.variant[0] = static_cast<uint8_t>(from.number(1));
		shares.push_back(read_share(from));
		const PlacedPlant plant = codes.plant(0);
		if (!is_valid(plant) || codes.height[0] == 0 ||
				static_cast<std::size_t>(plant.species) >= saved.species.size()) {
			from.fail();
		}
		saved.added.push_back({ ids.back(), plant });
	}
	if (from.is_sound()) {
		saved.edits.mow(ids, shares, 1.0);
	}
}

} // namespace

const char *describe_edits_fault(BytesFault fault) {
	switch (fault) {
		case BytesFault::none:
			return "The edits are valid.";
		case BytesFault::other_kind:
			return "These bytes are no edits of a field: pass the bytes that get_changes() returned.";
		case BytesFault::later_version:
			return "They were saved by a later release of Undergrowth: update the add-on.";
		case BytesFault::torn:
			return "They are incomplete or damaged: load another save.";
	}
	return "";
}

std::vector<uint8_t> write_edits(const SavedEdits &saved) {
	const bool has_trodden = saved.seed && !saved.trodden.empty();
	const uint32_t version = saved.seed ? WITH_SEED : WITHOUT_SEED;
	std::vector<uint8_t> bytes = ByteFrame::begin(LETTERS, has_trodden ? WITH_TRODDEN : version);
	if (saved.seed) {
		put_number(bytes, static_cast<uint64_t>(*saved.seed), SEED_BYTES);
	}
	put_count(bytes, saved.edits.of_generated().size());
	for (const auto &[spacing, squares] : saved.edits.of_generated()) {
		put_double(bytes, spacing);
		put_squares(bytes, saved.edits, squares);
	}
	put_count(bytes, saved.species.size());
	for (const std::string &name : saved.species) {
		put_text(bytes, name);
	}
	put_added(bytes, saved);
	if (has_trodden) {
		put_trodden(bytes, saved);
	}
	ByteFrame::seal(bytes);
	return bytes;
}

BytesFault read_edits(const uint8_t *bytes, std::size_t count, SavedEdits &edits) {
	uint32_t version = WITHOUT_SEED;
	while (version < WITH_TRODDEN && ByteFrame::check(LETTERS, version, bytes, count) == BytesFault::later_version) {
		version++;
	}
	const BytesFault fault = count == 0 ? BytesFault::none : ByteFrame::check(LETTERS, version, bytes, count);
	if (fault != BytesFault::none) {
		return fault;
	}
	SavedEdits made;
	if (count > 0) {
		ByteReader from = ByteFrame::inside(bytes, count);
		if (version >= WITH_SEED) {
			made.seed = static_cast<int64_t>(from.number(SEED_BYTES));
		}
		for (uint64_t left = from.count(); left > 0 && from.is_sound(); left--) {
			read_squares(from, made);
		}
		for (uint64_t left = from.count(); left > 0 && from.is_sound(); left--) {
			made.species.push_back(from.text());
		}
		read_added(from, made);
		if (version >= WITH_TRODDEN) {
			read_trodden(from, made);
		}
		if (!from.is_sound() || from.rest() != 0) {
			return BytesFault::torn;
		}
	}
	edits = std::move(made);
	return BytesFault::none;
}

} // namespace undergrowth
