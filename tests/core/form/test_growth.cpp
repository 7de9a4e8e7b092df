#include "form/growth.hpp"
#include "form_species.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

using namespace undergrowth;

namespace {

constexpr float NOT_A_NUMBER = std::numeric_limits<float>::quiet_NaN();

bool mentions(const std::string &text, const char *word) {
	return text.find(word) != std::string::npos;
}

std::string fault_of(const Arrangement &arrangement) {
	Recipe recipe;
	recipe.kinds.push_back(Part());
	recipe.lines.push_back({ 0, arrangement, ON_GROUND });
	return find_recipe_fault(recipe, true);
}

/// A recipe of `depth` lines, each on the one before.
Recipe chain(int depth, int count) {
	Recipe recipe;
	recipe.kinds.push_back(Part());
	for (int i = 0; i < depth; i++) {
		Arrangement a;
		a.count_min = a.count_max = count;
		recipe.lines.push_back({ 0, a, i - 1 });
	}
	return recipe;
}

Arrangement counted(int min, int max) {
	Arrangement a;
	a.count_min = min;
	a.count_max = max;
	return a;
}

} // namespace

TEST_CASE("one seed gives the same plant, another a different one") {
	const PlantForm one = grow_grass(7);
	const PlantForm again = grow_grass(7);
	const PlantForm other = grow_grass(8);
	REQUIRE(one.placed.size() == again.placed.size());
	bool differs = false;
	for (size_t i = 0; i < one.placed.size(); i++) {
		CHECK(one.placed[i].base == again.placed[i].base);
		CHECK(one.placed[i].length == again.placed[i].length);
		differs = differs || one.placed[i].length != other.placed[i].length;
	}
	CHECK(differs);
}

TEST_CASE("carriers come before their parts, groups are whole, ranks are spread") {
	for (const PlantForm &form : { grow_grass(1), grow_tulip(1), grow_daisy(1) }) {
		for (size_t i = 0; i < form.placed.size(); i++) {
			CHECK(form.placed[i].carrier < static_cast<int>(i));
		}
		for (const PartGroup &group : form.groups) {
			int below_half = 0;
			for (int i = group.first; i < group.first + group.count; i++) {
				const PlacedPart &part = form.placed[static_cast<size_t>(i)];
				CHECK(&form.groups[static_cast<size_t>(part.group)] == &group);
				below_half += part.rank < 0.5f ? 1 : 0;
			}
			CHECK(form.placed[static_cast<size_t>(group.first)].rank == 0.0f);
			CHECK(std::abs(below_half - 0.5 * group.count) <= 1.0);
		}
	}
}

TEST_CASE("a part is on its carrier and points outward") {
	const PlantForm form = grow_tulip(3);
	for (const PlacedPart &part : form.placed) {
		if (part.carrier == ON_GROUND) {
			continue;
		}
		const PlacedPart &carrier = form.placed[static_cast<size_t>(part.carrier)];
		const glm::vec3 seat = form.point_of(carrier, part.offset);
		CHECK(glm::length(part.base - seat) < 0.0045f);
		CHECK(glm::dot(part.axes.along, form.axes_of(carrier, part.offset).along) > 0.0f);
	}
}

TEST_CASE("the height of a plant without a stem is that of its highest part") {
	const PlantForm form = grow_daisy(4);
	float top = 0.0f;
	for (const PlacedPart &part : form.placed) {
		top = std::max(top, form.point_of(part, 1.0f).y);
	}
	CHECK(std::abs(form.height - top) < 0.02f * top);
}

TEST_CASE("a stem has its given height, and only one stem is allowed") {
	Growth growth(0.8f, 1);
	Part part;
	int stem = 7;
	CHECK(growth.add_stem(part, stem) == "");
	CHECK(stem == 0);
	CHECK(mentions(growth.add_stem(part, stem), "PlantAxis"));
	const PlantForm form = growth.finish();
	CHECK(form.height == 0.8f);
	CHECK(form.placed[0].length == 0.8f);
	CHECK(form.stem == 0);
}

TEST_CASE("counts of 0, of millions and below 0 are detected beforehand") {
	CHECK(mentions(fault_of(counted(0, 0)), "count cannot be 0"));
	CHECK(mentions(fault_of(counted(-5, 3)), "count cannot be -5"));
	CHECK(mentions(fault_of(counted(1, 1000000)), "count cannot be 1e+06"));
	CHECK(mentions(fault_of(counted(5, 4)), "count cannot be 4. Use 5"));
	CHECK(fault_of(counted(1, 4)) == "");
	CHECK(mentions(find_recipe_fault(chain(2, 100), false), "10100 parts"));
}

TEST_CASE("parts that are too deep, carry themselves or have an unknown carrier are detected beforehand") {
	CHECK(find_recipe_fault(chain(6, 2), false) == "");
	CHECK(mentions(find_recipe_fault(chain(6, 2), true), "6 levels"));
	CHECK(mentions(find_recipe_fault(chain(7, 2), false), "6 levels"));
	Recipe recipe = chain(2, 2);
	recipe.lines[1].on = 1;
	CHECK(mentions(find_recipe_fault(recipe, false), "carries itself"));
	recipe.lines[1].on = 99;
	CHECK(mentions(find_recipe_fault(recipe, false), "carries itself"));
	recipe.lines[1] = { 3, Arrangement(), 0 };
	CHECK(mentions(find_recipe_fault(recipe, false), "part is unknown"));
}

TEST_CASE("branches of three orders on a stem grow on the curves of what carries them") {
	Recipe recipe = chain(5, 3);
	recipe.kinds[0].kind = PartKind::axis;
	recipe.kinds[0].curve = { 0.6f, 1.5f, 0.3f };
	recipe.lines[0].arrangement.layout = Layout::ground;
	for (size_t i = 1; i < recipe.lines.size(); i++) {
		recipe.lines[i].arrangement.angle = { 0.9f, 0.5f };
		recipe.lines[i].arrangement.scale = { 0.5f, 0.4f };
	}
	Growth growth(1.0f, 3);
	REQUIRE(grow(recipe, ON_GROUND, growth) == "");
	const PlantForm form = growth.finish();
	CHECK(form.placed.size() == 3 + 9 + 27 + 81 + 243);
	CHECK(form.groups.back().depth == 5);
	for (const PlacedPart &part : form.placed) {
		if (part.carrier == ON_GROUND) {
			continue;
		}
		const PlacedPart &carrier = form.placed[static_cast<size_t>(part.carrier)];
		CHECK(form.groups[static_cast<size_t>(part.group)].depth ==
				form.groups[static_cast<size_t>(carrier.group)].depth + 1);
		CHECK(glm::length(part.base - form.point_of(carrier, part.offset)) < 1e-6f);
	}
}

TEST_CASE("invalid or out-of-range numbers have a fault") {
	Part part;
	part.curve.bend = NOT_A_NUMBER;
	CHECK(mentions(find_part_fault(part), "bend"));
	part = Part();
	part.length_max = 0.05f; // Below the min.
	CHECK(mentions(find_part_fault(part), "length"));
	part = Part();
	part.blade.teeth = -1;
	CHECK(mentions(find_part_fault(part), "teeth cannot be -1"));
	part = Part();
	part.colors.tip.y = NOT_A_NUMBER;
	CHECK(mentions(find_part_fault(part), "color"));
	part = Part();
	part.widths.samples = { 0.0f, 0.0f };
	CHECK(mentions(find_part_fault(part), "width is 0"));
	Arrangement a;
	a.angle.last = NOT_A_NUMBER;
	CHECK(mentions(find_arrangement_fault(a), "angle"));
	a = Arrangement();
	a.scales = { 1.0f, NOT_A_NUMBER };
	CHECK(mentions(find_arrangement_fault(a), "scale"));
}

TEST_CASE("a failed growth leaves a plant unchanged") {
	Growth growth(1.0f, 1);
	int kind = 0;
	CHECK(growth.add_kind(Part(), kind) == "");
	std::vector<int> handles;
	CHECK(mentions(growth.arrange(kind, Arrangement(), {}, handles), "no carrier"));
	CHECK(mentions(growth.arrange(kind, Arrangement(), { 5 }, handles), "handle"));
	CHECK(mentions(growth.arrange(9, Arrangement(), { ON_GROUND }, handles), "unknown"));
	CHECK(mentions(growth.arrange(kind, counted(4000, 4000), { ON_GROUND, ON_GROUND }, handles), "8000 parts"));
	CHECK(handles.empty());
	CHECK(growth.form().placed.empty());
}

TEST_CASE("a recipe grows the same plant as a script") {
	Recipe recipe = chain(2, 3);
	recipe.lines[0].arrangement.layout = Layout::ground;
	Growth growth(1.0f, 4);
	CHECK(grow(recipe, ON_GROUND, growth) == "");
	const PlantForm form = growth.finish();
	CHECK(form.placed.size() == 3 + 9);
	CHECK(form.groups[1].carrier_group == 0);
	CHECK(form.groups[1].depth == 2);
}

TEST_CASE("a group on carriers of several depths is deeper than the deepest of them, in any order") {
	for (const bool is_deepest_first : { true, false }) {
		Growth growth(1.0f, 4);
		int kind = -1;
		REQUIRE(growth.add_kind(Part(), kind) == "");
		std::vector<int> low, middle, high, higher, highest, on_both, deepest;
		REQUIRE(growth.arrange(kind, counted(1, 1), { ON_GROUND }, low) == "");
		REQUIRE(growth.arrange(kind, counted(1, 1), low, middle) == "");
		REQUIRE(growth.arrange(kind, counted(1, 1), middle, high) == "");
		REQUIRE(growth.arrange(kind, counted(1, 1), high, higher) == "");
		REQUIRE(growth.arrange(kind, counted(1, 1), higher, highest) == "");
		const std::vector<int> carriers =
				is_deepest_first ? std::vector<int>{ highest[0], low[0] } : std::vector<int>{ low[0], highest[0] };
		REQUIRE(growth.arrange(kind, counted(1, 1), carriers, on_both) == "");
		CHECK(growth.form().groups.back().depth == MAX_DEPTH);
		CHECK(mentions(growth.arrange(kind, counted(1, 1), { on_both[0] }, deepest), "6 levels"));
		CHECK(mentions(growth.arrange(kind, counted(1, 1), { on_both[0], low[0] }, deepest), "6 levels"));
	}
}

TEST_CASE("with a min count of 0 some seeds have a part with everything that it carries, and some do not") {
	Recipe recipe = chain(2, 3);
	recipe.lines[0].arrangement = counted(0, 1);
	recipe.lines[0].arrangement.layout = Layout::ground;
	recipe.lines.push_back({ 0, counted(2, 2), ON_GROUND });
	recipe.lines[2].arrangement.layout = Layout::ground;
	int with = 0;
	for (uint64_t seed = 0; seed < 400; seed++) {
		Growth growth(1.0f, seed);
		CHECK(grow(recipe, ON_GROUND, growth) == "");
		const PlantForm form = growth.finish();
		const bool has = form.placed.size() == 1 + 3 + 2;
		CHECK((has || form.placed.size() == 2));
		CHECK(form.groups.size() == (has ? 3u : 1u));
		with += has ? 1 : 0;
	}
	CHECK(std::abs(with - 200) < 50);
}
