#include "placement/edit_log_bytes.hpp"
#include "test_placement_fixture.hpp"

#include "../golden.hpp"

#include <doctest/doctest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace undergrowth;

namespace {

constexpr float BEND_TOLERANCE = 0.02f; // Angles have 256 codes, lengths too.
constexpr std::size_t REMOVED_BYTES = 16;
constexpr uint64_t GOLDEN_BYTES = 11769555693119934671ull;

SavedEdits sample() {
	SavedEdits saved;
	saved.seed = -12;
	std::vector<PlantId> gone;
	std::vector<PlantId> mown;
	std::vector<float> shares;
	for (int i = -50; i < 50; i++) {
		gone.push_back(generated_plant_id(0.5f * static_cast<float>(i), 3.0f, 0.25));
		mown.push_back(generated_plant_id(0.5f * static_cast<float>(i), -90.0f, 0.25));
		shares.push_back(0.005f * static_cast<float>(i + 60));
	}
	saved.edits.remove(gone, 0.25);
	saved.edits.mow(mown, shares, 0.25);
	saved.edits.remove({ generated_plant_id(-40000.0f, 9.0f, 1.5) }, 1.5);
	saved.species = { "Poppy", "Mädesüß" };
	for (int i = 0; i < 3; i++) {
		AddedPlant one;
		one.id = added_plant_id(10 * i);
		one.plant.root = { 1.0f, 2.0f, static_cast<float>(i) };
		one.plant.turn = 1.25f;
		one.plant.species = i % 2;
		saved.added.push_back(one);
	}
	saved.edits.mow({ added_plant_id(10) }, { 0.5f }, 1.0);
	return saved;
}

BytesFault read(const std::vector<uint8_t> &bytes, SavedEdits &edits) {
	return read_edits(bytes.data(), bytes.size(), edits);
}

void reseal(std::vector<uint8_t> &bytes) {
	const uint32_t sum = checksum_of(bytes.data(), bytes.size() - 4);
	std::memcpy(bytes.data() + bytes.size() - 4, &sum, 4);
}

} // namespace

TEST_CASE("written edits are read unchanged") {
	const SavedEdits saved = sample();
	const std::vector<uint8_t> bytes = write_edits(saved);
	SavedEdits back;
	REQUIRE(read(bytes, back) == BytesFault::none);
	CHECK(back.edits.is_gone(-25.0f, 3.0f));
	CHECK(!back.edits.is_gone(-25.0f, 4.0f));
	CHECK(back.edits.is_gone(-40000.0f, 9.0f));
	CHECK(back.edits.share_of(1, 0.0f, -90.0f) == doctest::Approx(0.3).epsilon(1e-4));
	CHECK(back.edits.share_of(added_plant_id(10), 0.0f, 0.0f) == doctest::Approx(0.5).epsilon(1e-4));
	CHECK(back.seed == saved.seed);
	CHECK(back.species == saved.species);
	REQUIRE(back.added.size() == 3);
	CHECK(back.added[2].id == added_plant_id(20));
	CHECK(back.added[2].plant.root == saved.added[2].plant.root);
	CHECK(write_edits(back) == bytes);
	CHECK(GoldenHash().add(bytes).value() == GOLDEN_BYTES);
}

TEST_CASE("edits of the first version, without a seed, are read") {
	SavedEdits saved = sample();
	saved.seed.reset();
	const std::vector<uint8_t> bytes = write_edits(saved);
	CHECK(bytes[4] == 1);
	SavedEdits back = sample();
	REQUIRE(read(bytes, back) == BytesFault::none);
	CHECK(!back.seed);
	CHECK(back.edits.is_gone(-25.0f, 3.0f));
	CHECK(write_edits(back) == bytes);
}

TEST_CASE("trodden plants are written with their bends, and bytes without them are those of the second version") {
	SavedEdits saved = sample();
	CHECK(write_edits(saved)[4] == 2);
	for (int i = 0; i < 300; i++) {
		const float angle = 0.021f * static_cast<float>(i) - 3.1f;
		const float size = 0.003f + 0.0033f * static_cast<float>(i);
		const PlantId id = i % 5 == 0 ? added_plant_id(i) : generated_plant_id(static_cast<float>(i), 3.0f, 0.5);
		saved.trodden.push_back({ id, size * glm::vec2(std::cos(angle), std::sin(angle)) });
	}
	const std::vector<uint8_t> bytes = write_edits(saved);
	CHECK(bytes[4] == 3);
	SavedEdits back;
	REQUIRE(read(bytes, back) == BytesFault::none);
	REQUIRE(back.trodden.size() == saved.trodden.size());
	for (const TroddenPlant &plant : back.trodden) {
		const auto same = std::find_if(saved.trodden.begin(), saved.trodden.end(),
				[&](const TroddenPlant &one) { return one.id == plant.id; });
		REQUIRE(same != saved.trodden.end());
		CHECK(glm::length(plant.bend - same->bend) <= MAX_TRODDEN_BEND * BEND_TOLERANCE);
	}
	CHECK(write_edits(back) == bytes);
	CHECK(back.added.size() == saved.added.size());
	std::vector<uint8_t> cut(bytes.begin(), bytes.end() - 1);
	CHECK(read(cut, back) == BytesFault::torn);
	for (std::size_t i = 10; i + 4 < bytes.size(); i += 7) { // No damage is worse than other edits.
		std::vector<uint8_t> damaged = bytes;
		damaged[i] ^= 0x55;
		reseal(damaged);
		SavedEdits any;
		read(damaged, any);
		for (const TroddenPlant &plant : any.trodden) {
			CHECK(glm::length(plant.bend) <= MAX_TRODDEN_BEND * 1.001f);
		}
	}
}

TEST_CASE("a trodden plant on a path needs at most 4 bytes") {
	const PlacementRequest request = square_field(50.0f, 20.0f, 2);
	const double spacing = Placement(request).cell_size();
	const FieldPlants plants = placed(request);
	SavedEdits saved;
	saved.seed = 1;
	const std::size_t nothing = write_edits(saved).size();
	for (std::size_t i = 0; i < plants.x.size(); i++) {
		const float across = plants.x[i] - 0.6f * plants.z[i];
		if (std::fabs(across) < 0.4f) {
			saved.trodden.push_back({ generated_plant_id(plants.x[i], plants.z[i], spacing), { 0.5f, across } });
		}
	}
	REQUIRE(saved.trodden.size() > 500);
	const double share =
			static_cast<double>(write_edits(saved).size() - nothing) / static_cast<double>(saved.trodden.size());
	MESSAGE("bytes of a trodden plant: ", share);
	CHECK(share <= 4.0);
}

TEST_CASE("regrown plants are not written, and heights are the current ones") {
	SavedEdits saved = sample();
	saved.edits.grow_back(0.9);
	SavedEdits back;
	REQUIRE(read(write_edits(saved), back) == BytesFault::none);
	CHECK(back.edits.grown_back() == 0.0);
	CHECK(back.edits.share_of(1, -25.0f, -90.0f) == doctest::Approx(0.95).epsilon(1e-4));
	CHECK(back.edits.share_of(1, 20.0f, -90.0f) == 1.0f);
	CHECK(back.edits.plant_count() < saved.edits.plant_count());
}

TEST_CASE("a removed plant needs at most 16 bytes, a swath far fewer") {
	const PlacementRequest request = square_field(50.0f, 20.0f, 2);
	const double spacing = Placement(request).cell_size();
	const FieldPlants plants = placed(request);
	SavedEdits swath;
	SavedEdits strewn;
	std::vector<PlantId> ids;
	std::vector<PlantId> few;
	for (std::size_t i = 0; i < plants.x.size(); i++) {
		ids.push_back(generated_plant_id(plants.x[i], plants.z[i], spacing));
		if (i % 997 == 0) {
			few.push_back(generated_plant_id(plants.x[i], plants.z[i], spacing));
		}
	}
	const std::size_t nothing = write_edits(swath).size();
	swath.edits.remove(ids, spacing);
	strewn.edits.remove(few, spacing);
	CHECK(write_edits(swath).size() - nothing <= 3 * ids.size());
	CHECK(write_edits(strewn).size() - nothing <= REMOVED_BYTES * few.size());
}

TEST_CASE("saved plants without height, or with an impossible scale, are rejected") {
	SavedEdits saved;
	saved.species = { "Poppy" };
	saved.added.push_back({ added_plant_id(0), PlacedPlant() });
	const std::vector<uint8_t> whole = write_edits(saved);
	// Before the checksum: the share of height, the variant, side, lean, height and turn, then the scale.
	const std::size_t height_at = whole.size() - 4 - 2 - 1 - 6;
	const std::size_t scale_at = height_at - 2 - 4;
	SavedEdits read_back;
	REQUIRE(read(whole, read_back) == BytesFault::none);
	std::vector<uint8_t> flat = whole;
	flat[height_at] = flat[height_at + 1] = 0;
	reseal(flat);
	CHECK(read(flat, read_back) == BytesFault::torn);
	flat[height_at] = 1;
	reseal(flat);
	CHECK(read(flat, read_back) == BytesFault::none);
	for (const float scale : { 0.0f, -1.0f, 1e-44f, 1e-7f, 1e7f, 3e38f, std::nanf("") }) {
		std::vector<uint8_t> scaled = whole;
		std::memcpy(scaled.data() + scale_at, &scale, sizeof(scale));
		reseal(scaled);
		CHECK(read(scaled, read_back) == BytesFault::torn);
	}
}

TEST_CASE("bytes that are truncated, of a later release or of another kind are reported and change nothing") {
	const std::vector<uint8_t> bytes = write_edits(sample());
	SavedEdits kept = sample();
	for (std::size_t length = 1; length < bytes.size(); length += 7) {
		const std::vector<uint8_t> cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
		CHECK(read(cut, kept) == (length < 4 ? BytesFault::other_kind : BytesFault::torn));
	}
	for (std::size_t at = 10; at < bytes.size(); at += 11) {
		std::vector<uint8_t> damaged = bytes;
		damaged[at] ^= 0x40;
		CHECK(read(damaged, kept) == BytesFault::torn);
		reseal(damaged); // As in a hostile file: it is read without a fault, or refused.
		SavedEdits other;
		read(damaged, other);
	}
	std::vector<uint8_t> later = bytes;
	later[4] = 4;
	reseal(later);
	CHECK(read(later, kept) == BytesFault::later_version);
	CHECK(read({ 'U', 'G', 'D', 'M', 1, 0, 14, 0, 0, 0, 0, 0, 0, 0 }, kept) == BytesFault::other_kind);
	CHECK(write_edits(kept) == bytes);
	CHECK(read({}, kept) == BytesFault::none);
	CHECK(kept.edits.is_empty());
	CHECK(kept.added.empty());
}
