#include "placement/edit_finder.hpp"
#include "placement/edit_log.hpp"
#include "placement/plant_store.hpp"
#include "test_placement_fixture.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace undergrowth;

namespace {

constexpr float SIDE = 40.0f; // m.

/// A square with removed plants in a circle of 6 m, and plants mown to half their height in another.
struct Cut {
	PlacementRequest request = square_field(SIDE, 4.0f, 2);
	double spacing = Placement(request).cell_size();
	FieldPlants plants = placed(request);
	EditLog edits;

	Cut() {
		edits.remove(named_near(5.0f), spacing);
		const std::vector<PlantId> mown = named_near(-8.0f);
		edits.mow(mown, std::vector<float>(mown.size(), 0.5f), spacing);
	}

	static bool is_near(float x, float z, float middle) { return std::hypot(x - middle, z - 2.0f) < 6.0f; }

	std::vector<PlantId> named_near(float middle) const {
		std::vector<PlantId> ids;
		for (std::size_t i = 0; i < plants.x.size(); i++) {
			if (is_near(plants.x[i], plants.z[i], middle)) {
				ids.push_back(generated_plant_id(plants.x[i], plants.z[i], spacing));
			}
		}
		return ids;
	}
};

int count_near(const FieldPlants &plants, float middle, float less) {
	int count = 0;
	for (std::size_t i = 0; i < plants.x.size(); i++) {
		count += std::hypot(plants.x[i] - middle, plants.z[i] - 2.0f) < 6.0f - less ? 1 : 0;
	}
	return count;
}

} // namespace

TEST_CASE("removed plants, and only those, stay removed in a rebuild") {
	const Cut cut;
	FieldPlants anew = placed(cut.request);
	const int before = anew.size();
	const int gone = static_cast<int>(cut.named_near(5.0f).size());
	REQUIRE(gone > 400);
	cut.edits.take_out(anew);
	CHECK(anew.size() == before - gone);
	CHECK(count_near(anew, 5.0f, 0.0f) == 0);
}

TEST_CASE("at another density no plant grows where plants are removed") {
	const Cut cut;
	for (const float density : { 1.0f, 11.0f, 40.0f }) {
		PlacementRequest request = cut.request;
		request.density = density;
		FieldPlants anew = placed(request);
		const int all = anew.size();
		cut.edits.take_out(anew);
		CHECK(count_near(anew, 5.0f, 1.0f) == 0);
		const double area = 3.14159 * 6.0 * 6.0;
		CHECK(all - anew.size() == doctest::Approx(area * static_cast<double>(density)).epsilon(0.15));
	}
}

TEST_CASE("a mown plant has its mown height and grows back") {
	Cut cut;
	const std::vector<PlantId> mown = cut.named_near(-8.0f);
	const auto share_of = [&](PlantId id) {
		float x = 0.0f;
		float z = 0.0f;
		generated_plant_position(id, cut.spacing, x, z);
		return cut.edits.share_of(id, x, z);
	};
	CHECK(share_of(mown[7]) == 0.5f);
	CHECK(share_of(cut.named_near(5.0f)[0]) == 1.0f);
	cut.edits.grow_back(0.25);
	CHECK(share_of(mown[7]) == 0.75f);
	cut.edits.mow({ mown[7] }, { 0.125f }, cut.spacing);
	CHECK(share_of(mown[7]) == 0.125f);
	CHECK(share_of(mown[8]) == 0.75f);
	cut.edits.mow({ mown[9] }, { -3.0f }, cut.spacing);
	CHECK(share_of(mown[9]) == EditLog::MIN_SHARE);
	cut.edits.grow_back(1.0);
	CHECK(share_of(mown[7]) == 1.0f);
	cut.edits.remove({ mown[8] }, cut.spacing);
	cut.edits.mow({ mown[7] }, { 1.0f }, cut.spacing);
	const int left = static_cast<int>(mown.size() + cut.named_near(5.0f).size());
	CHECK(cut.edits.plant_count() < left); // An edit of a square also drops its plants that are whole again.
}

TEST_CASE("no removed plant is also recorded as mown") {
	Cut cut;
	const int known = cut.edits.plant_count();
	cut.edits.remove(cut.named_near(-8.0f), cut.spacing);
	CHECK(cut.edits.plant_count() == known);
	for (const auto &[spacing, squares] : cut.edits.of_generated()) {
		for (const auto &[key, square] : squares) {
			CHECK(square->mown.empty());
		}
	}
}

TEST_CASE("added plants are mown by their ids") {
	EditLog edits;
	edits.mow({ added_plant_id(3) }, { 0.25f }, 1.0);
	CHECK(edits.share_of(added_plant_id(3), 90.0f, 90.0f) == 0.25f);
	CHECK(edits.share_of(added_plant_id(4), 90.0f, 90.0f) == 1.0f);
	edits.forget_added(added_plant_id(3));
	CHECK(edits.is_empty());
}

TEST_CASE("an added plant at its full height is the same as one that was never mown") {
	EditLog edits;
	edits.mow({ added_plant_id(3), added_plant_id(4) }, { 0.25f, 1.0f }, 1.0);
	CHECK(edits.plant_count() == 1);
	edits.mow({ added_plant_id(3) }, { 1.0f }, 1.0);
	CHECK(edits.is_empty());
}

TEST_CASE("a copy does not change with its source, and a cut has everything for its box") {
	Cut cut;
	const EditLog copy = cut.edits;
	const PlantId id = generated_plant_id(15.0f, 15.0f, cut.spacing);
	cut.edits.remove({ id }, cut.spacing);
	CHECK(cut.edits.is_gone(15.0f, 15.0f));
	CHECK(!copy.is_gone(15.0f, 15.0f));
	const AreaBox box = { { 3.0f, -2.0f }, { 9.0f, 4.0f } };
	const EditLog part = cut.edits.cut(box);
	EditFinder finder(part);
	CHECK(part.plant_count() < cut.edits.plant_count());
	for (float x = box.low.x; x < box.high.x; x += 0.1f) {
		for (float z = box.low.y; z < box.high.y; z += 0.1f) {
			REQUIRE(part.is_gone(x, z) == cut.edits.is_gone(x, z));
			REQUIRE(finder.is_gone(x, z) == part.is_gone(x, z));
		}
	}
	CHECK(cut.edits.has_mown({ { -9.0f, 1.0f }, { -8.0f, 2.0f } }));
	CHECK(!cut.edits.has_mown({ { 14.0f, 12.0f }, { 18.0f, 18.0f } }));
}

TEST_CASE("boxes report the plants that are removed only here") {
	Cut cut;
	const EditLog before = cut.edits;
	CHECK(cut.edits.gone_beside(before).empty());
	const PlantId id = generated_plant_id(15.0f, -15.0f, cut.spacing);
	cut.edits.remove({ id }, cut.spacing);
	const std::vector<AreaBox> boxes = cut.edits.gone_beside(before);
	REQUIRE(boxes.size() == 1);
	CHECK(boxes[0].low.x <= 15.0f);
	CHECK(boxes[0].high.y >= -15.0f);
	CHECK(before.gone_beside(cut.edits).empty());
	CHECK(before.gone_beside(EditLog()).size() == cut.named_near(5.0f).size());
}

TEST_CASE("a cut has everything for its box, for any changed squares beside it") {
	PlacementRequest request = square_field(SIDE, 4.0f, 2);
	const double spacing = Placement(request).cell_size();
	const FieldPlants plants = placed(request);
	EditLog edits;
	std::vector<PlantId> all;
	for (std::size_t i = 0; i < plants.x.size(); i++) {
		all.push_back(generated_plant_id(plants.x[i], plants.z[i], spacing));
	}
	edits.remove(all, spacing);
	constexpr float S = EditLog::SQUARE;
	const AreaBox box = { { -1.5f * S, -1.5f * S },
		{ 1.5f * S, SIDE } }; // There are squares beside it and below it, none above.
	const EditLog part = edits.cut(box);
	int count = 0;
	for (std::size_t i = 0; i < plants.x.size(); i++) {
		if (box.low.x < plants.x[i] && plants.x[i] < box.high.x && box.low.y < plants.z[i] &&
				plants.z[i] < box.high.y) {
			CHECK(part.is_gone(plants.x[i], plants.z[i]));
			count++;
		}
	}
	CHECK(count > 1000);
	CHECK(part.plant_count() < edits.plant_count());
}

TEST_CASE("a cut around a plant's root has its removal, for any position in its cell") {
	const Cut cut;
	for (std::size_t i = 0; i < cut.plants.x.size(); i++) {
		const float x = cut.plants.x[i];
		const float z = cut.plants.z[i];
		const AreaBox root = { { x, z }, { x, z } };
		CHECK(cut.edits.cut(root).is_gone(x, z) == cut.edits.is_gone(x, z));
	}
}

namespace {

/// Plants around 25 positions are removed and others mown, at different positions for each of `count` densities.
EditLog changes_of_densities(int count) {
	EditLog edits;
	for (int i = 0; i < count; i++) {
		const double spacing = 0.5 + 0.003 * i;
		for (int place = 0; place < 25; place++) {
			const float x = 8.0f * static_cast<float>(place % 5) - 18.0f + 0.037f * static_cast<float>(i);
			const float z = 8.0f * static_cast<float>(place / 5) - 18.0f + 0.029f * static_cast<float>(i);
			edits.remove({ generated_plant_id(x, z, spacing) }, spacing);
			edits.mow({ generated_plant_id(x + 1.0f, z, spacing) }, { 0.5f }, spacing);
		}
	}
	return edits;
}

/// Cells that a finder compares for all plants of a square field.
int64_t compared_for(const EditLog &edits) {
	EditFinder finder(edits);
	const FieldPlants plants = placed(square_field(SIDE, 4.0f, 2));
	for (std::size_t i = 0; i < plants.x.size(); i++) {
		finder.is_gone(plants.x[i], plants.z[i]);
	}
	return finder.compared_cells();
}

} // namespace

TEST_CASE("a finder returns the same as the edits, for many densities") {
	const EditLog edits = changes_of_densities(40);
	EditFinder finder(edits);
	int gone = 0;
	int mown = 0;
	for (float x = -21.0f; x < 21.0f; x += 0.13f) {
		for (float z = -21.0f; z < 21.0f; z += 0.17f) {
			REQUIRE(finder.is_gone(x, z) == edits.is_gone(x, z));
			REQUIRE(finder.find_mown(x, z) == edits.find_mown(generated_plant_id(x, z, 0.5), x, z));
			gone += finder.is_gone(x, z) ? 1 : 0;
			mown += finder.find_mown(x, z) != nullptr ? 1 : 0;
		}
	}
	CHECK(gone > 100);
	CHECK(mown > 100);
}

TEST_CASE("a finder compares only the cells around the plants, for many densities") {
	const FieldPlants plants = placed(square_field(SIDE, 4.0f, 2));
	const int64_t of_ten = compared_for(changes_of_densities(10));
	const int64_t of_hundred = compared_for(changes_of_densities(100));
	CHECK(of_ten > 0);
	CHECK(of_hundred < 6 * plants.size()); // One comparison per density would be 100 per plant.
}
