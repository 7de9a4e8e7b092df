// Fuzz tests of the decoders: mutated bytes with a correct length and checksum, as in a damaged or hostile file.

#include "../base/sanitized.hpp"
#include "base/byte_codec.hpp"
#include "base/random.hpp"
#include "motion/motion_species.hpp"
#include "placement/density_brush.hpp"
#include "placement/density_bytes.hpp"
#include "placement/edit_finder.hpp"
#include "placement/edit_log_bytes.hpp"
#include "placement/plant_store.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace undergrowth;

namespace {

using Bytes = std::vector<uint8_t>;

constexpr uint64_t ROUNDS = repetitions(4000, 1500);
constexpr std::size_t LENGTH_AT = 6;
/// Bit patterns of numbers at the limits of the readers.
constexpr uint32_t ODD_WORDS[] = { 0u, 1u, 0x7fu, 0x80u, 0xffu, 0xffffu, 0x7fffffffu, 0x80000000u, 0xffffffffu,
	0x7f800000u /* infinite */, 0x7fc00000u /* not a number */, 0x00000001u /* denormal */, 0x7f7fffffu, 0xff7fffffu };

/// Random numbers of one round, the same on every machine.
class Chance {
public:
	explicit Chance(uint64_t seed) : state(mix_bits(seed)) {}
	uint64_t below(uint64_t end) {
		state = mix_bits(state + 1);
		return (state >> 16) % end;
	}

private:
	uint64_t state;
};

void mutate(Bytes &bytes, Chance &chance) {
	const std::size_t first = ByteFrame::HEADER;
	const std::size_t size = bytes.size() - ByteFrame::CHECKSUM;
	const auto at = static_cast<std::ptrdiff_t>(first + chance.below(size - first));
	const auto length =
			static_cast<std::ptrdiff_t>(std::min<uint64_t>(1 + chance.below(12), size - static_cast<std::size_t>(at)));
	const auto begin = bytes.begin() + at;
	switch (chance.below(6)) {
		case 0:
			*begin = static_cast<uint8_t>(chance.below(256));
			break;
		case 1:
			*begin = static_cast<uint8_t>(*begin ^ (1u << chance.below(8)));
			break;
		case 2:
		case 3: {
			const uint32_t word = ODD_WORDS[chance.below(std::size(ODD_WORDS))];
			for (std::ptrdiff_t i = 0; i < std::min<std::ptrdiff_t>(length, 4); i++) {
				begin[i] = static_cast<uint8_t>(word >> (8 * i));
			}
			break;
		}
		case 4:
			if (size > first + 12) {
				bytes.erase(begin, begin + length);
			}
			break;
		default: {
			const Bytes copied(begin, begin + length);
			bytes.insert(begin, copied.begin(), copied.end());
		}
	}
}

/// Corrects the length and the checksum.
void seal(Bytes &bytes) {
	const auto length = static_cast<uint32_t>(bytes.size());
	for (std::size_t i = 0; i < 4; i++) {
		bytes[LENGTH_AT + i] = static_cast<uint8_t>(length >> (8 * i));
	}
	const uint32_t sum = checksum_of(bytes.data(), bytes.size() - ByteFrame::CHECKSUM);
	for (std::size_t i = 0; i < ByteFrame::CHECKSUM; i++) {
		bytes[bytes.size() - ByteFrame::CHECKSUM + i] = static_cast<uint8_t>(sum >> (8 * i));
	}
}

Bytes mutated(const Bytes &whole, uint64_t seed) {
	Chance chance(seed);
	Bytes bytes = whole;
	for (uint64_t count = 1 + chance.below(4); count > 0; count--) {
		mutate(bytes, chance);
	}
	seal(bytes);
	return bytes;
}

SavedEdits sample_changes() {
	SavedEdits saved;
	saved.seed = 7;
	std::vector<PlantId> gone;
	std::vector<PlantId> mown;
	for (int i = 0; i < 12; i++) {
		gone.push_back(generated_plant_id(0.7f * static_cast<float>(i), 3.0f, 0.25));
		mown.push_back(generated_plant_id(0.7f * static_cast<float>(i), -9.0f, 0.25));
	}
	saved.edits.remove(gone, 0.25);
	saved.edits.mow(mown, std::vector<float>(mown.size(), 0.4f), 0.25);
	saved.species = { "Poppy", "Grass" };
	for (int i = 0; i < 6; i++) {
		PlacedPlant plant;
		plant.root = { static_cast<float>(i), 0.0f, 2.0f };
		plant.species = i % 2;
		plant.height = 0.5f;
		saved.added.push_back({ added_plant_id(3 * i), plant });
	}
	saved.edits.mow({ added_plant_id(3) }, { 0.5f }, 1.0);
	return saved;
}

/// Everything that a field does with loaded edits.
void use(const SavedEdits &saved) {
	StoreEdit edit;
	edit.tile_size = 16.0f;
	for (const AddedPlant &one : saved.added) {
		edit.added.push_back(one.plant);
		edit.added_ids.push_back(one.id);
		const bool is_valid_length = one.plant.height * one.plant.scale > 0.0f && std::isfinite(one.plant.scale);
		REQUIRE((is_valid(one.plant) && is_valid_length));
		REQUIRE(static_cast<std::size_t>(one.plant.species) < saved.species.size());
	}
	PlantStore store;
	store.apply(std::move(edit));
	REQUIRE(store.plant_count() == static_cast<int>(saved.added.size()));
	const EditLog near = saved.edits.cut({ { -20.0f, -20.0f }, { 20.0f, 20.0f } });
	EditFinder finder(near);
	for (float x = -1.0f; x < 10.0f; x += 0.35f) {
		finder.is_gone(x, 3.0f);
		finder.find_mown(x, -9.0f);
	}
	near.gone_beside(EditLog());
	REQUIRE(near.plant_count() >= 0);
}

DensityMap sample_map() {
	DensityMap map(1.0f);
	for (int layer = 0; layer < 3; layer++) {
		const int number = map.need_layer(std::string("layer ") + static_cast<char>('a' + layer));
		const auto middle = static_cast<float>(10 * layer);
		paint(map, number, { { middle, middle }, 4.0f, 0.5f }, { DensityStroke::Does::add, 0.7f, 1.0f });
		paint(map, number, { { middle, middle }, 3.0f, 0.5f }, { DensityStroke::Does::set_height, 1.6f, 0.5f });
	}
	return map;
}

} // namespace

TEST_CASE("mutated edits with a correct checksum are rejected, or can be used and written again") {
	const Bytes whole = write_edits(sample_changes());
	int sound = 0;
	for (uint64_t seed = 0; seed < ROUNDS; seed++) {
		const Bytes bytes = mutated(whole, seed);
		SavedEdits read;
		if (read_edits(bytes.data(), bytes.size(), read) == BytesFault::none) {
			sound++;
			use(read);
			const Bytes again = write_edits(read);
			SavedEdits once_more;
			REQUIRE(read_edits(again.data(), again.size(), once_more) == BytesFault::none);
		}
	}
	CHECK(sound > 100);
	CHECK(sound < static_cast<int>(ROUNDS) - 100);
}

TEST_CASE("a mutated map with a correct checksum is rejected, or can be used and written again") {
	const Bytes whole = write_density(sample_map());
	const DensityMap other = sample_map();
	int sound = 0;
	for (uint64_t seed = 0; seed < ROUNDS; seed++) {
		const Bytes bytes = mutated(whole, seed);
		DensityMap map;
		if (read_density(bytes.data(), bytes.size(), map) == DensityFault::none) {
			sound++;
			const Bytes again = write_density(map);
			DensityMap once_more;
			REQUIRE(read_density(again.data(), again.size(), once_more) == DensityFault::none);
			for (int layer = 0; layer < map.layer_count(); layer++) {
				REQUIRE(map.cell_at(layer, { 3.0f, 4.0f }).share() <= 1.0f);
				paint(map, layer, { { 9.0f, 9.0f }, 3.0f, 0.5f }, { DensityStroke::Does::add, -0.7f, 1.0f });
			}
			map.take(other, map.cells_around({ { -5.0f, -5.0f }, { 5.0f, 5.0f } }));
		}
	}
	CHECK(sound > 100);
	CHECK(sound < static_cast<int>(ROUNDS) - 100);
}
