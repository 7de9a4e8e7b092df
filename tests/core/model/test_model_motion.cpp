#include "model_fixture.hpp"
#include "motion/part_bend.hpp"
#include "stem/stem_recipe.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace undergrowth;

TEST_CASE("model: the stem of a plant bends along its height and its base is still") {
	const MadeSurface made = leafy_stem();
	const ModelMotion motion = motion_of({ made.surface() });
	CHECK(motion.roots == 1);
	CHECK(motion.leaves == 8);
	CHECK(motion.twigs == 0);
	for (int i = 0; i < 6 * 5 * 4; i++) {
		const glm::vec3 &place = motion.vertices.places[size_t(i)];
		CHECK(motion.vertices.custom0[size_t(i)].x == doctest::Approx(place.y / 0.8f).epsilon(0.02));
		CHECK(motion.vertices.custom0[size_t(i)].y == 0.0f);
	}
}

TEST_CASE("model: the middle of a leaning stem of few rows is between them") {
	const float lean = 0.5f;
	const float heights[] = { 0.0f, 0.56f, 1.2f };
	const auto at = [&](int row, int side) {
		const float turn = 1.5707963f * static_cast<float>(side);
		return glm::vec3(lean * heights[row] + 0.02f * std::cos(turn), heights[row], 0.02f * std::sin(turn));
	};
	MadeSurface made;
	for (int row = 0; row < 2; row++) {
		for (int side = 0; side < 4; side++) {
			made.quad(at(row, side), at(row, side + 1), at(row + 1, side + 1), at(row + 1, side));
		}
	}
	const ModelMotion motion = motion_of({ made.surface() });
	float aside = 0.0f;
	float count = 0.0f;
	for (size_t i = 0; i < motion.vertices.places.size(); i++) {
		const float place = motion.vertices.places[i].y;
		aside += place > 0.3f && place < 0.9f ? motion.vertices.custom2[i].x : 0.0f;
		count += place > 0.3f && place < 0.9f ? 1.0f : 0.0f;
	}
	CHECK(count == 16.0f);
	CHECK(std::fabs(aside / count) < 0.15f * lean * heights[1]);
}

TEST_CASE("model: loose islands are leaves with a pivot at the stem and a weight that grows to the tip") {
	const MadeSurface made = leafy_stem();
	const ModelMotion motion = motion_of({ made.surface() });
	for (size_t first = 6 * 5 * 4; first < motion.vertices.places.size(); first += 4) {
		const glm::vec3 pivot(motion.vertices.custom1[first]);
		CHECK(glm::length(glm::vec2(pivot.x, pivot.z)) < 0.03f);
		CHECK(motion.vertices.custom0[first].y < 0.1f);
		CHECK(std::max(motion.vertices.custom0[first + 2].y, motion.vertices.custom0[first + 3].y) ==
				doctest::Approx(1.0f));
		for (size_t i = first; i < first + 4; i++) {
			CHECK(motion.vertices.custom0[i].x == motion.vertices.custom0[first].x);
			CHECK(motion.vertices.custom0[i].x == doctest::Approx(pivot.y / 0.8f).epsilon(0.03));
		}
	}
}

TEST_CASE("model: leaves lag behind a stem that moves") {
	const MadeSurface made = leafy_stem();
	const ModelMotion motion = motion_of({ made.surface() });
	const glm::vec4 code = motion.vertices.custom1.back();
	const PartMotion swing = decode_part_motion({ code.w, motion.vertices.custom2.back().w });
	StemMotion stem;
	stem.rate = { 1.0f, 0.0f };
	CHECK(part_bend(swing, stem).x < -0.01f);
}

TEST_CASE("model: leaves on a twig move with the twig, and the twig with its place on the stem") {
	MadeSurface made;
	made.stem(1.0f, 0.02f);
	const int of_stem = int(made.positions.size());
	made.leaf({ 0.02f, 0.5f, 0.0f }, { 0.4f, 0.1f, 0.0f }, 0.02f);
	for (int i = 0; i < 4; i++) {
		made.leaf({ 0.12f + 0.08f * float(i), 0.52f + 0.02f * float(i), 0.012f }, { 0.0f, 0.02f, 0.1f }, 0.03f);
	}
	const ModelMotion motion = motion_of({ made.surface() });
	CHECK(motion.twigs == 1);
	CHECK(motion.leaves == 4);
	for (size_t i = size_t(of_stem); i < motion.vertices.places.size(); i++) {
		CHECK(motion.vertices.custom0[i].x == doctest::Approx(0.5f).epsilon(0.03));
	}
	CHECK(motion.vertices.custom0[size_t(of_stem) + 2].y == 0.0f);
}

TEST_CASE("model: petals around the tip of a stem are one head that turns as a whole") {
	MadeSurface made;
	made.stem(0.5f, 0.004f);
	for (int i = 0; i < 6; i++) {
		const float turn = 1.0472f * float(i);
		const glm::vec3 side(std::cos(turn), 0.0f, std::sin(turn));
		made.leaf(glm::vec3(0.0f, 0.5f, 0.0f) + 0.004f * side, 0.04f * side, 0.02f);
	}
	const ModelMotion motion = motion_of({ made.surface() });
	CHECK(motion.heads == 1);
	CHECK(motion.leaves == 0);
	const glm::vec4 last = motion.vertices.custom1.back();
	CHECK(last.y == doctest::Approx(0.5f));
	CHECK(motion.vertices.custom0.back().y == 1.0f);
	CHECK(motion.bones.names().front() == "head_1");
}

TEST_CASE("model: blades of a tuft bend by their own height and swing to their own side") {
	MadeSurface made;
	for (int i = 0; i < 9; i++) {
		const float turn = 0.7f * float(i);
		const glm::vec3 side(std::cos(turn), 0.0f, std::sin(turn));
		made.leaf(0.03f * side, 0.3f * glm::normalize(0.5f * side + glm::vec3(0.0f, 1.0f, 0.0f)), 0.01f);
	}
	const ModelMotion motion = motion_of({ made.surface() });
	CHECK(motion.roots == 9);
	CHECK(motion.leaves == 9);
	for (size_t i = 0; i < motion.vertices.places.size(); i++) {
		const float height = motion.vertices.places[i].y;
		CHECK(motion.vertices.custom0[i].x == doctest::Approx(height / 0.268f).epsilon(0.02));
	}
}

TEST_CASE("model: a surface with a cut-out material is apart from the stem that it touches") {
	MadeSurface trunk, crown;
	trunk.stem(1.0f, 0.03f);
	crown.is_foliage = true;
	for (int i = 0; i < 20; i++) {
		const float turn = 2.4f * float(i);
		const glm::vec3 side(std::cos(turn), 0.0f, std::sin(turn));
		crown.leaf(0.03f * side + glm::vec3(0.0f, 0.4f + 0.03f * float(i), 0.0f), 0.3f * side, 0.2f);
	}
	const ModelMotion motion = motion_of({ trunk.surface(), crown.surface() });
	CHECK(motion.roots == 1);
	CHECK(motion.leaves == 20);
	CHECK(motion.vertices.custom0.front().w == 0.0f);
	CHECK(motion.vertices.custom0.back().w == 1.0f);
}

TEST_CASE("model: many leaves share bones, and all weights sum to 1") {
	MadeSurface made;
	made.stem(1.0f, 0.02f);
	for (int i = 0; i < 300; i++) {
		const float turn = 2.4f * float(i);
		const glm::vec3 side(std::cos(turn), 0.0f, std::sin(turn));
		made.leaf(0.02f * side + glm::vec3(0.0f, 0.1f + 0.003f * float(i), 0.0f), 0.1f * side, 0.02f);
	}
	const ModelMotion motion = motion_of({ made.surface() });
	CHECK(motion.bones.bones().size() <= size_t(FormBones::MAX_BONES - FormBones::FIRST));
	for (size_t i = 0; i < motion.vertices.places.size(); i++) {
		int32_t bones[4];
		float weights[4];
		motion.bones.bind(motion.vertices.swingers[i], motion.vertices.custom0[i].x, motion.vertices.bone_weights[i],
				bones, weights);
		CHECK(weights[0] + weights[1] + weights[2] + weights[3] == 1.0f);
	}
}

TEST_CASE("model: the beam of a model has a solution") {
	const MadeSurface made = leafy_stem();
	StemRecipe recipe;
	recipe.beam = motion_of({ made.surface() }).beam;
	CHECK(recipe.beam.diameter == doctest::Approx(0.02f).epsilon(0.1));
	CHECK(recipe.beam.loads.size() > 2);
	recipe.beam.natural_frequency = 1.0f;
	recipe.wind_weight = -1.0f;
	recipe.own_length = recipe.beam.length;
	CHECK(solve_recipe(recipe).fault == StemFault::none);
}

TEST_CASE("model: a single body without loose parts bends as one") {
	MadeSurface made;
	made.stem(0.6f, 0.1f, glm::vec3(0.0f), 12, 8);
	const ModelMotion motion = motion_of({ made.surface() });
	CHECK(motion.roots == 1);
	CHECK(motion.leaves + motion.heads + motion.twigs == 0);
	CHECK(motion.bones.bones().empty());
}

namespace {

// A vertex as the shader of a field shows it.
glm::vec3 shown(const ModelVertices &vertices, size_t i, const StemMotion &stem, const PosedStem &posed) {
	const PartMotion swing = decode_part_motion({ vertices.custom1[i].w, vertices.custom2[i].w });
	const glm::vec3 pivot(vertices.custom1[i]);
	glm::vec3 place = vertices.places[i];
	if (vertices.custom0[i].y > 0.0f) {
		const glm::vec2 bend = part_bend(swing, stem);
		place = pivot +
				(swing.is_head() ? turned(place - pivot, bend) : bent_way(place - pivot, bend, vertices.custom0[i].y));
	}
	return posed.place_of(place, vertices.stem_places[i]);
}

// Largest way of a vertex on the ground, and the sum of all edges over that at rest, in a strong wind.
void check_shown(const std::vector<ModelSurface> &surfaces) {
	const ModelMotion motion = motion_of(surfaces);
	StemRecipe recipe;
	recipe.beam = motion.beam;
	recipe.wind_weight = -1.0f;
	recipe.own_length = recipe.beam.length;
	const SolvedStem solved = solve_recipe(recipe);
	REQUIRE(solved.fault == StemFault::none);
	StemMotion stem;
	stem.bend = { 0.25f, 0.1f }; // The tip leans by 30 degrees.
	stem.rate = { 0.5f, -0.3f };
	stem.air = 8.0f;
	const PosedStem posed(*solved.in_air, motion.beam.length, stem);
	float farthest = 0.0f, base = 0.0f, before = 0.0f, after = 0.0f;
	size_t first = 0;
	for (const ModelSurface &surface : surfaces) {
		for (int i = 0; i < surface.index_count; i++) {
			const size_t from = first + size_t(surface.indices[i]);
			const size_t to = first + size_t(surface.indices[i % 3 == 2 ? i - 2 : i + 1]);
			const glm::vec3 place = shown(motion.vertices, from, stem, posed);
			const float way = glm::distance(place, motion.vertices.places[from]);
			farthest = std::max(farthest, way);
			base = motion.vertices.places[from].y <= 0.0f ? std::max(base, way) : base;
			before += glm::distance(motion.vertices.places[from], motion.vertices.places[to]);
			after += glm::distance(place, shown(motion.vertices, to, stem, posed));
		}
		first += size_t(surface.vertices);
	}
	CHECK(farthest > 0.2f * motion.beam.length);
	CHECK(base < 1e-3f);
	CHECK(after / before == doctest::Approx(1.0f).epsilon(0.01));
}

// A blade of many rows that arches outward.
void add_blade(MadeSurface &made, const glm::vec3 &side, const glm::vec3 &root, float length, float width = 0.012f) {
	const glm::vec3 across = 0.5f * width * glm::normalize(glm::cross(side, glm::vec3(0.0f, 1.0f, 0.0f)));
	const auto at = [&](float share) {
		return root + length * (share * glm::vec3(0.0f, 1.0f, 0.0f) + 0.4f * share * share * side);
	};
	for (int row = 0; row < 8; row++) {
		const glm::vec3 low = at(float(row) / 8.0f);
		const glm::vec3 high = at(float(row + 1) / 8.0f);
		made.quad(low - across, low + across, high + across, high - across);
	}
}

} // namespace

TEST_CASE("model: plants of a field keep their base and their length in a strong wind") {
	SUBCASE("a stem with leaves") {
		const MadeSurface made = leafy_stem();
		check_shown({ made.surface() });
	}
	SUBCASE("a tuft of blades") {
		MadeSurface made;
		for (int i = 0; i < 40; i++) {
			const glm::vec3 side(std::cos(2.4f * float(i)), 0.0f, std::sin(2.4f * float(i)));
			add_blade(made, side, (0.01f + 0.002f * float(i % 9)) * side, 0.4f);
		}
		check_shown({ made.surface() });
	}
	SUBCASE("spread cards") {
		MadeSurface made;
		made.is_foliage = true;
		for (int i = 0; i < 12; i++) {
			const glm::vec3 side(std::cos(2.4f * float(i)), 0.0f, std::sin(2.4f * float(i)));
			add_blade(made, side, 0.12f * side, 0.35f, 0.2f);
		}
		check_shown({ made.surface() });
	}
	SUBCASE("a trunk with many cards") {
		MadeSurface trunk, crown;
		trunk.stem(2.0f, 0.05f, glm::vec3(0.0f), 12, 8);
		crown.is_foliage = true;
		for (int i = 0; i < 500; i++) {
			const glm::vec3 side(std::cos(2.4f * float(i)), 0.3f, std::sin(2.4f * float(i)));
			crown.leaf(0.04f * side + glm::vec3(0.0f, 0.7f + 0.0025f * float(i), 0.0f), 0.25f * side, 0.15f);
		}
		check_shown({ trunk.surface(), crown.surface() });
	}
}

TEST_CASE("model: channels of vertex colours stiffen stems, calm leaves and set phases") {
	MadeSurface made = leafy_stem();
	made.colors.assign(made.positions.size(), glm::vec4(0.5f, 0.25f, 0.75f, 1.0f));
	const std::vector<ModelSurface> surfaces = { made.surface() };
	const ModelFrame frame = find_model_frame(surfaces, {});
	const ModelVertices found = find_model_motion(surfaces, frame).vertices;
	const ModelVertices painted = find_model_motion(surfaces, frame, { 0, 1, 2 }).vertices;
	const size_t of_stem = 6 * 5 * 4;
	for (size_t i = 0; i < found.places.size(); i++) {
		const float bend = i < of_stem ? 0.5f : 1.0f;
		CHECK(painted.custom0[i].x == doctest::Approx(bend * found.custom0[i].x));
		CHECK(painted.custom0[i].y == doctest::Approx(0.25f * found.custom0[i].y));
	}
	const PartMotion swing = decode_part_motion({ painted.custom1[of_stem].w, painted.custom2[of_stem].w });
	CHECK(swing.phase == doctest::Approx(0.75f));
}
