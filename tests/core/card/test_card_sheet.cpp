#include "../form/form_species.hpp"
#include "../golden.hpp"
#include "card/card_sheet.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace undergrowth;

namespace {

using Grow = PlantForm (*)(uint64_t);
constexpr Grow SPECIES[] = { grow_grass, grow_daisy, grow_fern };

/// A mipmap of a layer's coverage.
struct Alphas {
	int width, height;
	const uint8_t *bytes;

	double at(int x, int y) const {
		const int column = std::clamp(x, 0, width - 1);
		const int row = std::clamp(y, 0, height - 1);
		return bytes[4 * (row * width + column) + 3] / 255.0;
	}
	/// Fraction of a fine picture that a material with linear filter and a threshold of one half draws.
	double drawn() const { return drawn(0, 0, width, height); }
	/// The same of a part of it, from this texel on.
	double drawn(int left_end, int upper_end, int wide, int high) const {
		constexpr int FINER = 8;
		int count = 0;
		for (int y = FINER * upper_end; y < FINER * (upper_end + high); y++) {
			for (int x = FINER * left_end; x < FINER * (left_end + wide); x++) {
				const double u = (x + 0.5) / FINER - 0.5;
				const double v = (y + 0.5) / FINER - 0.5;
				const int left = static_cast<int>(std::floor(u));
				const int upper = static_cast<int>(std::floor(v));
				const double above = at(left, upper) * (left + 1 - u) + at(left + 1, upper) * (u - left);
				const double below = at(left, upper + 1) * (left + 1 - u) + at(left + 1, upper + 1) * (u - left);
				count += above * (upper + 1 - v) + below * (v - upper) >= 0.5 ? 1 : 0;
			}
		}
		return static_cast<double>(count) / (FINER * FINER * wide * high);
	}
};

/// The place that a layer of a sheet of one group shows.
int place_of(const CardPlaces &all, const CardLayer &layer) {
	for (size_t i = 0; i < all.places.size(); i++) {
		const CardExtent &extent = all.places[i].extent;
		if (extent.low == layer.extent.low && extent.high == layer.extent.high && extent.half == layer.extent.half) {
			return static_cast<int>(i);
		}
	}
	return -1;
}

constexpr int HEAD_PARTS = 40;
constexpr int BRACTS = 8;

/// A fresh and a faded head on stems of one kind, without bracts or with the same ones.
PlantForm grow_faded(bool has_bracts) {
	Growth growth(0.3f, 1);
	Part stem, floret, faded, bract;
	stem.kind = PartKind::axis;
	stem.length_min = stem.length_max = 0.3f;
	stem.width = 0.003f;
	floret.length_min = floret.length_max = 0.01f;
	floret.width = 0.006f;
	bract = faded = floret;
	faded.colors.base = faded.colors.tip = glm::vec4(0.4f, 0.2f, 0.1f, 1.0f);
	int stem_kind = 0, floret_kind = 0, faded_kind = 0, bract_kind = 0;
	REQUIRE(growth.add_kind(stem, stem_kind) == "");
	REQUIRE(growth.add_kind(floret, floret_kind) == "");
	REQUIRE(growth.add_kind(faded, faded_kind) == "");
	REQUIRE(growth.add_kind(bract, bract_kind) == "");
	Arrangement head, ground, bracts;
	head.layout = Layout::disc;
	head.count_min = head.count_max = HEAD_PARTS;
	head.radius = 0.01f;
	head.dome = 1.5f;
	ground.layout = Layout::ground;
	bracts.layout = Layout::whorl;
	bracts.count_min = bracts.count_max = BRACTS;
	bracts.angle = { 1.7f, 1.7f };
	for (const int kind : { floret_kind, faded_kind }) {
		std::vector<int> stems, florets, own;
		REQUIRE(growth.arrange(stem_kind, ground, { ON_GROUND }, stems) == "");
		if (has_bracts) {
			REQUIRE(growth.arrange(bract_kind, bracts, stems, own) == "");
		}
		REQUIRE(growth.arrange(kind, head, stems, florets) == "");
	}
	return growth.finish();
}

/// A flower: a bell of one tube, and five sepals around it; with lobes at the mouth of the bell, or without.
PlantForm grow_bell(bool has_lobes) {
	Growth growth(0.3f, 1);
	Part stalk, sepal, bell, lobe;
	stalk.kind = bell.kind = PartKind::axis;
	stalk.length_min = stalk.length_max = 0.2f;
	stalk.width = stalk.axis.tip_diameter = 0.002f;
	bell.length_min = bell.length_max = 0.04f;
	bell.width = bell.axis.tip_diameter = 0.03f;
	bell.axis.open_tip = true;
	bell.axis.lobes = 5;
	lobe.length_min = lobe.length_max = 0.01f;
	sepal.length_min = sepal.length_max = 0.02f;
	sepal.width = 0.004f;
	int kind = 0;
	for (Part *part : { &stalk, &sepal, &bell, &lobe }) {
		part->colors.base = part->colors.tip = glm::vec4(0.5f);
		REQUIRE(growth.add_kind(*part, kind) == "");
	}
	Arrangement ground, whorl, tip;
	ground.layout = Layout::ground;
	whorl.layout = Layout::whorl;
	whorl.count_min = whorl.count_max = 5;
	whorl.angle = { 1.2f, 1.2f };
	tip.from = 1.0f;
	std::vector<int> stalks, sepals, bells, lobes;
	REQUIRE(growth.arrange(0, ground, { ON_GROUND }, stalks) == "");
	REQUIRE(growth.arrange(1, whorl, stalks, sepals) == "");
	REQUIRE(growth.arrange(2, tip, stalks, bells) == "");
	if (has_lobes) {
		REQUIRE(growth.arrange(3, whorl, bells, lobes) == "");
	}
	return growth.finish();
}

constexpr int STEMS = 10;
constexpr int BRANCHES = 3;

/// A shrub like heather: three branches on each of ten stems, and sixty buds of this length (m) around each branch.
PlantForm grow_heath(float bud_length) {
	Growth growth(0.3f, 1);
	Part stem, branch, bud;
	stem.kind = branch.kind = PartKind::axis;
	stem.length_min = stem.length_max = 0.3f;
	stem.width = 0.004f;
	branch.length_min = branch.length_max = 0.1f;
	branch.width = 0.002f;
	bud.length_min = bud.length_max = bud_length;
	bud.width = 0.003f;
	int kind = 0;
	for (const Part &part : { stem, branch, bud }) {
		REQUIRE(growth.add_kind(part, kind) == "");
	}
	Arrangement tuft, around, buds;
	tuft.layout = Layout::ground;
	tuft.count_min = tuft.count_max = STEMS;
	around.count_min = around.count_max = BRANCHES;
	around.from = 0.2f;
	around.angle = { 0.9f, 0.5f };
	buds.count_min = buds.count_max = 60;
	buds.from = 0.2f;
	buds.angle = { 0.9f, 0.5f };
	std::vector<int> stems, branches, all;
	REQUIRE(growth.arrange(0, tuft, { ON_GROUND }, stems) == "");
	REQUIRE(growth.arrange(1, around, stems, branches) == "");
	REQUIRE(growth.arrange(2, buds, branches, all) == "");
	return growth.finish();
}

} // namespace

TEST_CASE("heads and flat fronds are found, single parts are not") {
	const std::vector<CardGroup> grass = find_card_groups(grow_grass(2));
	REQUIRE(grass.size() == 1);
	CHECK(grass[0].shape == CardShape::strip);
	const std::vector<CardGroup> daisy = find_card_groups(grow_daisy(2));
	REQUIRE(daisy.size() == 1);
	CHECK(daisy[0].carried.size() == 2); // Florets and rays.
	CHECK(daisy[0].shape == CardShape::head);
	const std::vector<CardGroup> fern = find_card_groups(grow_fern(2));
	REQUIRE(fern.size() == 1);
	CHECK(fern[0].shape == CardShape::flat);
	CHECK(find_card_groups(grow_alone(Part())).empty());
}

TEST_CASE("flowers of few petals are heads") {
	const std::vector<CardGroup> tulip = find_card_groups(grow_tulip(2));
	REQUIRE(tulip.size() == 1);
	CHECK(tulip[0].shape == CardShape::head);
	CHECK(tulip[0].carried.size() == 3); // Two kinds of tepals, and stamens.
}

TEST_CASE("twigs with tiny parts have a picture each for near forms, and one for several of them for far forms") {
	const PlantForm form = grow_heath(0.008f);
	const CardSheet sheet = make_card_sheet(form);
	REQUIRE(sheet.groups.size() == 2);
	CHECK(sheet.has_far_cards());
	const CardPlaces near = place_cards(form, sheet.groups, CardReach::near);
	const CardPlaces far = place_cards(form, sheet.groups, CardReach::far);
	CHECK(near.places.size() == STEMS * BRANCHES);
	CHECK(far.places.size() == STEMS);
	for (const CardPlaces *places : { &near, &far }) {
		for (const CardPlace &place : places->places) {
			CHECK(sheet.groups[static_cast<size_t>(place.group)].shape == CardShape::strip);
		}
	}
	CHECK_FALSE(make_card_sheet(grow_fern(2)).has_far_cards());
}

TEST_CASE("leaves that are seen one by one are not in the picture of a twig") {
	CHECK(find_card_groups(grow_heath(0.03f)).empty());
}

TEST_CASE("a bell is in the picture of its flower") {
	for (const bool has_lobes : { false, true }) {
		CAPTURE(has_lobes);
		const PlantForm form = grow_bell(has_lobes);
		const std::vector<CardGroup> groups = find_card_groups(form);
		REQUIRE(groups.size() == 1);
		CHECK(groups[0].carried == std::vector<int>{ 1, 2 });
		CHECK(groups[0].shape == CardShape::head);
		const CardPlaces all = place_cards(form, groups);
		REQUIRE(all.places.size() == 1);
		CHECK(all.places[0].count == (has_lobes ? 11 : 6));
	}
}

TEST_CASE("the wall of a bell is shaded evenly") {
	const PlantForm form = grow_bell(false);
	const std::vector<CardGroup> groups = find_card_groups(form);
	REQUIRE(groups.size() == 1);
	HeadOutline outline;
	const CardPicture side = draw_card(form, place_cards(form, groups), 0, CardShape::head, 64, 64, outline).front();
	float largest = 0.0f;
	int compared = 0;
	for (size_t row = 8; row < 40; row++) { // Above the sepals.
		for (size_t column = 24; column < 40; column++) {
			const CardTexel &own = side.texels[row * 64 + column];
			const CardTexel &next = side.texels[row * 64 + column + 1];
			if (own.coverage == 1.0f && next.coverage == 1.0f) {
				largest = std::max(largest, std::abs(own.light.y / next.light.y - 1.0f));
				compared++;
			}
		}
	}
	CHECK(compared > 200);
	CHECK(largest < 0.05f);
}

TEST_CASE("leaves of few lobes in the plane of their stalk stay in this plane") {
	Growth growth(0.3f, 1);
	Part stalk, lobe;
	stalk.kind = PartKind::axis;
	stalk.length_min = stalk.length_max = 0.1f;
	lobe.length_min = lobe.length_max = 0.03f;
	lobe.width = 0.015f;
	int stalk_kind = 0, lobe_kind = 0;
	REQUIRE(growth.add_kind(stalk, stalk_kind) == "");
	REQUIRE(growth.add_kind(lobe, lobe_kind) == "");
	Arrangement tuft, lobes;
	tuft.layout = Layout::ground;
	tuft.count_min = tuft.count_max = 5;
	lobes.count_min = lobes.count_max = 6;
	lobes.from = 0.95f;
	lobes.per_node = 2;
	lobes.turn = 0.0f;
	lobes.phase = 1.5708f;
	lobes.angle = { 1.6f, 0.3f };
	lobes.flat = true;
	std::vector<int> stalks, leaves;
	REQUIRE(growth.arrange(stalk_kind, tuft, { ON_GROUND }, stalks) == "");
	REQUIRE(growth.arrange(lobe_kind, lobes, stalks, leaves) == "");
	const std::vector<CardGroup> groups = find_card_groups(growth.finish());
	REQUIRE(groups.size() == 1);
	CHECK(groups[0].shape == CardShape::leaf);
}

TEST_CASE("fresh and faded heads on stems of one kind have their own pictures") {
	const PlantForm form = grow_faded(false);
	const std::vector<CardGroup> groups = find_card_groups(form);
	REQUIRE(groups.size() == 2);
	CHECK(groups[0].carried.size() == 1);
	CHECK(groups[1].carried != groups[0].carried);
}

TEST_CASE("fresh and faded heads with the same bracts have their own pictures") {
	const PlantForm form = grow_faded(true);
	const std::vector<CardGroup> groups = find_card_groups(form);
	REQUIRE(groups.size() == 2);
	const CardPlaces all = place_cards(form, groups);
	REQUIRE(all.places.size() == 2);
	CHECK(all.places[0].group != all.places[1].group);
	CHECK(all.places[0].count == HEAD_PARTS + BRACTS);
	CHECK(all.places[1].count == HEAD_PARTS + BRACTS);
}

TEST_CASE("mipmaps whose sizes are odd cover as much as the picture") {
	const CardSheet sheet = make_card_sheet(grow_faded(true));
	CHECK(sheet.width == 80); // Halved to 5 and 2.
	for (const CardLayer &layer : sheet.pictures) {
		const HeadOutline &head = layer.head;
		CHECK(head.half > 0.0f);
		const Alphas alphas = { sheet.width, sheet.height, layer.colors.data() };
		const double finest = alphas.drawn();
		double covered = 0.0;
		for (size_t i = 3; i < static_cast<size_t>(4 * sheet.width * sheet.height); i += 4) {
			covered += layer.colors[i] / 255.0;
		}
		CHECK(finest == doctest::Approx(covered / (sheet.width * sheet.height)).epsilon(0.06));
	}
}

TEST_CASE("the picture of an ear of two rows is not from its narrow side") {
	double areas[2];
	for (int i = 0; i < 2; i++) {
		Growth growth(0.3f, 1);
		Part stem, spikelet;
		stem.kind = spikelet.kind = PartKind::axis;
		stem.length_min = stem.length_max = 0.3f;
		stem.width = 0.003f;
		spikelet.length_min = spikelet.length_max = 0.03f;
		spikelet.width = 0.002f;
		int stem_kind = 0, spikelet_kind = 0;
		REQUIRE(growth.add_kind(stem, stem_kind) == "");
		REQUIRE(growth.add_kind(spikelet, spikelet_kind) == "");
		Arrangement ground, ear;
		ground.layout = Layout::ground;
		ear.count_min = ear.count_max = 24;
		ear.from = 0.8f;
		ear.turn = 3.14159265f;
		ear.phase = 1.57079633f * static_cast<float>(i);
		ear.angle = { 0.7f, 0.7f };
		std::vector<int> stems, spikelets;
		REQUIRE(growth.arrange(stem_kind, ground, { ON_GROUND }, stems) == "");
		REQUIRE(growth.arrange(spikelet_kind, ear, stems, spikelets) == "");
		const PlantForm form = growth.finish();
		CardGroup group = { stem_kind, { spikelet_kind }, CardShape::strip };
		const CardPlaces all = place_cards(form, { group });
		HeadOutline outline;
		const CardPicture picture = draw_card(form, all, 0, CardShape::strip, 64, 128, outline).front();
		areas[i] = 0.0;
		for (const CardTexel &texel : picture.texels) {
			areas[i] += static_cast<double>(texel.coverage);
		}
		const CardBox &box = picture.box;
		areas[i] *= static_cast<double>(2.0f * box.half * (box.high - box.low)) / (64.0 * 128.0);
	}
	CHECK(areas[1] == doctest::Approx(areas[0]).epsilon(0.15));
}

TEST_CASE("each carrier has one card with everything on it") {
	const PlantForm form = grow_grass(3);
	const CardPlaces all = place_cards(form, find_card_groups(form));
	CHECK(all.places.size() == 3); // Culms.
	for (const CardPlace &place : all.places) {
		CHECK(place.count == 12 * 3); // Twigs with two spikelets.
		CHECK(place.from == doctest::Approx(0.835f).epsilon(0.02));
		CHECK(place.extent.high - place.extent.low > 0.05f);
	}
}

TEST_CASE("mipmaps cover as much as the picture") {
	for (const Grow grow : SPECIES) {
		const CardSheet sheet = make_card_sheet(grow(2));
		for (const CardLayer &layer : sheet.pictures) {
			Alphas alphas = { sheet.width, sheet.height, layer.colors.data() };
			const double whole = alphas.drawn();
			CHECK(whole > 0.005);
			while (std::min(alphas.width, alphas.height) > 4) {
				CAPTURE(alphas.width);
				CHECK(alphas.drawn() == doctest::Approx(whole).epsilon(0.12));
				alphas.bytes += 4 * alphas.width * alphas.height;
				alphas.width /= 2;
				alphas.height /= 2;
			}
		}
	}
}

TEST_CASE("dense and sparse parts of a picture cover as much as their geometry") {
	constexpr int WINDOW = 16;
	for (const Grow grow : SPECIES) {
		const PlantForm form = grow(2);
		const CardSheet sheet = make_card_sheet(form);
		const CardPlaces all = place_cards(form, sheet.groups);
		const int place = place_of(all, sheet.pictures[0]);
		REQUIRE(place >= 0);
		HeadOutline outline;
		const std::vector<CardPicture> pictures =
				draw_card(form, all, place, sheet.groups[0].shape, sheet.width, sheet.height, outline);
		for (size_t layer = 0; layer < pictures.size(); layer++) {
			const Alphas alphas = { sheet.width, sheet.height, sheet.pictures[layer].colors.data() };
			double apart = 0.0, whole = 0.0;
			for (int y = 0; y < sheet.height; y += WINDOW) {
				for (int x = 0; x < sheet.width; x += WINDOW) {
					double covered = 0.0;
					for (int i = 0; i < WINDOW * WINDOW; i++) {
						const int at = (y + i / WINDOW) * sheet.width + x + i % WINDOW;
						covered += static_cast<double>(pictures[layer].texels[static_cast<size_t>(at)].coverage);
					}
					covered /= WINDOW * WINDOW;
					apart += std::abs(alphas.drawn(x, y, WINDOW, WINDOW) - covered);
					whole += covered;
				}
			}
			CAPTURE(layer);
			CHECK(apart < 0.06 * whole);
		}
	}
}

TEST_CASE("stalks below the flowers of an umbel are darker than these") {
	Part stem, stalk, flower;
	stem.kind = stalk.kind = PartKind::axis;
	stem.length_min = stem.length_max = 0.3f;
	stalk.length_min = stalk.length_max = 0.04f;
	stem.width = stalk.width = 0.001f;
	flower.kind = PartKind::bead;
	flower.length_min = flower.length_max = 0.003f;
	flower.width = 0.014f;
	Arrangement single, umbel, tips;
	single.layout = Layout::ground;
	umbel.count_min = umbel.count_max = 40;
	umbel.from = 0.97f;
	umbel.angle = { 0.6f, 0.1f };
	tips.from = 1.0f;
	Growth growth(0.3f, 1);
	std::vector<int> stems, stalks, flowers;
	int kind = 0;
	for (Part *part : { &stem, &stalk, &flower }) {
		part->colors.base = part->colors.tip = glm::vec4(0.5f);
		REQUIRE(growth.add_kind(*part, kind) == "");
	}
	REQUIRE(growth.arrange(0, single, { ON_GROUND }, stems) == "");
	REQUIRE(growth.arrange(1, umbel, stems, stalks) == "");
	REQUIRE(growth.arrange(2, tips, stalks, flowers) == "");
	const PlantForm form = growth.finish();
	const std::vector<CardGroup> groups = find_card_groups(form);
	REQUIRE(groups.size() == 1);
	REQUIRE(groups[0].shape == CardShape::head);
	HeadOutline outline;
	const CardPicture side = draw_card(form, place_cards(form, groups), 0, CardShape::head, 64, 128, outline).front();
	double light[2] = {}, covered[2] = {};
	for (size_t i = 0; i < side.texels.size(); i++) {
		const size_t half = 2 * i / side.texels.size();
		light[half] += static_cast<double>(side.texels[i].light.y * side.texels[i].coverage);
		covered[half] += static_cast<double>(side.texels[i].coverage);
	}
	CHECK(light[1] / covered[1] < 0.9 * light[0] / covered[0]);
}

TEST_CASE("the mean of a group's colours is 1") {
	for (const Grow grow : SPECIES) {
		const CardSheet sheet = make_card_sheet(grow(2));
		REQUIRE(sheet.groups.size() == 1);
		double sum = 0.0, weight = 0.0;
		for (const CardLayer &layer : sheet.pictures) {
			for (size_t i = 0; i < static_cast<size_t>(4 * sheet.width * sheet.height); i += 4) {
				const double root = 2.0 * layer.colors[i + 1] / 255.0;
				sum += root * root * layer.colors[i + 3];
				weight += layer.colors[i + 3];
			}
		}
		CHECK(sum / weight == doctest::Approx(1.0).epsilon(0.05));
	}
}

TEST_CASE("a sheet of cards fits the video memory of a species") {
	for (const Grow grow : SPECIES) {
		const CardSheet sheet = make_card_sheet(grow(2));
		CHECK(sheet.size() > 0);
		CHECK(sheet.size() <= MAX_SHEET_BYTES);
	}
	CHECK(make_card_sheet(grow_alone(Part())).is_empty());
}

TEST_CASE("the pictures of cards are the same on every platform") {
	const uint64_t goldens[3] = { 0x2aa8be2d7ade9287ull, 0x9ac9d54e6a7e1f42ull, 0xc9eed80fccdac1b1ull };
	for (size_t i = 0; i < 3; i++) {
		GoldenHash hash;
		for (const CardLayer &layer : make_card_sheet(SPECIES[i](4)).pictures) {
			hash.add(layer.colors).add(layer.surfaces);
		}
		CHECK(hash.value() == goldens[i]);
	}
}
