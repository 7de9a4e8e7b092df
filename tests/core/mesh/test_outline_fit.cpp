#include "base/random.hpp"
#include "mesh/outline_fit.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace undergrowth;

// Upright sheets with given widening and turns.

namespace {

constexpr float GOAL = 0.015f; // The size of the dots of the pictures.

struct Sheets {
	std::vector<glm::vec3> positions;
	std::vector<glm::vec3> normals;
	std::vector<glm::vec4> asides;
	std::vector<int32_t> indices;
	std::vector<WrittenUnit> units;

	/// On an upright midrib at `place`, 1 m high.
	void add(const glm::vec3 &place, const glm::vec3 &aside, bool is_flower = false) {
		const int32_t first = static_cast<int32_t>(positions.size());
		units.push_back({ first, static_cast<int>(indices.size()), 1.0f, is_flower, 1e9f });
		for (const float up : { 0.0f, 1.0f }) {
			for (const float side : { -1.0f, 1.0f }) {
				positions.push_back(place + glm::vec3(0.0f, up, 0.0f) + aside * side);
				normals.push_back(glm::normalize(glm::vec3(-aside.z, 0.0f, aside.x)));
				asides.emplace_back(aside * side, 0.0f);
			}
		}
		indices.insert(indices.end(), { first, first + 2, first + 1, first + 2, first + 3, first + 1 });
	}
	/// A sheet that grows in height as in width, as a bead does.
	void add_bead(const glm::vec3 &aside, float height) {
		add({ 0.0f, 0.0f, 0.0f }, aside);
		for (size_t i = positions.size() - 4; i < positions.size(); i++) {
			asides[i].y = height * (positions[i].y - 0.5f);
			positions[i].y = height * positions[i].y;
		}
	}
	void end() { units.push_back({ static_cast<int>(positions.size()), static_cast<int>(indices.size()) }); }
	FormBuffers buffers() {
		FormBuffers all = {};
		all.positions = positions.data();
		all.normals = normals.data();
		all.custom2 = asides.data();
		all.indices = indices.data();
		return all;
	}
	Outlines outlines(const SightBox &box) const {
		return outline_areas({ positions.data(), static_cast<int>(positions.size()), indices.data(),
									 static_cast<int>(indices.size()) },
				box);
	}
};

glm::vec3 facing(float width, float turn) {
	return { width * std::cos(turn), 0.0f, width * std::sin(turn) };
}

float worst_of(const Outlines &areas, const Outlines &wanted) {
	float worst = 0.0f;
	for (size_t side = 0; side < OUTLINES; side++) {
		worst = std::max(worst, std::abs(areas[side] / wanted[side] - 1.0f));
	}
	return worst;
}

constexpr SightBox BOX = { 1.0f, 0.0f, 1.0f };

} // namespace

TEST_CASE("sheets with one orientation are turned and widened until every side shows its area") {
	Sheets wanted;
	wanted.add({ -0.5f, 0.0f, 0.1f }, facing(0.12f, 0.9f));
	wanted.add({ 0.3f, 0.0f, 0.4f }, facing(0.07f, -0.6f));
	wanted.add({ 0.1f, 0.0f, -0.5f }, facing(0.2f, 0.1f));
	Sheets sheets;
	for (const glm::vec3 &place : { glm::vec3(-0.5f, 0.0f, 0.1f), { 0.3f, 0.0f, 0.4f }, { 0.1f, 0.0f, -0.5f } }) {
		sheets.add(place, facing(0.08f, 0.0f));
	}
	sheets.end();
	const FormBuffers mesh = sheets.buffers();
	const Outlines areas = wanted.outlines(BOX);
	float worst = worst_of(sheets.outlines(BOX), areas);
	CHECK(worst > 0.5f);
	OutlineFit fit(sheets.units, mesh);
	fit.detach();
	fit.search(BOX, areas, GOAL, worst);
	CHECK(worst <= GOAL);
	CHECK(worst_of(sheets.outlines(BOX), areas) == doctest::Approx(worst).epsilon(1e-3));
	for (size_t i = 0; i < sheets.normals.size(); i++) { // The normals turn with the sheets.
		CHECK(std::abs(glm::length(sheets.normals[i]) - 1.0f) < 1e-6f);
	}
}

TEST_CASE("a sheet stays finite when its wanted outlines are impossible") {
	bool are_numbers = true;
	for (int i = 0; i < 300; i++) {
		const auto chance = [i](uint64_t which) { return 0.5f + 0.5f * signed_noise(which, static_cast<uint64_t>(i)); };
		Sheets sheets;
		sheets.add_bead(facing(500.0f, 3.0f * chance(0)), 700.0f);
		sheets.end();
		const FormBuffers mesh = sheets.buffers();
		OutlineFit fit(sheets.units, mesh);
		Outlines areas, wanted;
		for (size_t side = 0; side < OUTLINES; side++) {
			areas[side] = 1e5f * (0.2f + chance(2 + side));
			wanted[side] = areas[side] * (0.05f + 0.3f * chance(6 + side));
		}
		for (int step = 0; step < 50; step++) {
			fit.approach(areas, wanted);
			for (const glm::vec3 &place : sheets.positions) {
				are_numbers = are_numbers && std::isfinite(place.x + place.y + place.z);
			}
		}
	}
	CHECK(are_numbers);
}

TEST_CASE("a sheet of nearly no size does not affect other sheets") {
	Sheets sheets;
	sheets.add_bead(facing(1e-21f, 0.3f), 1e-20f);
	sheets.add({ 0.3f, 0.0f, 0.0f }, facing(0.2f, 0.5f));
	sheets.end();
	const FormBuffers mesh = sheets.buffers();
	OutlineFit fit(sheets.units, mesh);
	const Outlines wanted = { 0.1f, 0.1f, 0.1f, 0.1f };
	const float before = worst_of(sheets.outlines(BOX), wanted);
	for (int step = 0; step < 5; step++) {
		fit.approach(sheets.outlines(BOX), wanted);
	}
	for (const glm::vec3 &place : sheets.positions) {
		REQUIRE(std::isfinite(place.x + place.y + place.z));
	}
	CHECK(worst_of(sheets.outlines(BOX), wanted) < 0.5f * before);
}

TEST_CASE("a search preserves the size of flowers and turns no sheet over") {
	Sheets sheets;
	sheets.add({ 0.0f, 0.0f, 0.0f }, facing(0.1f, 0.3f), true);
	sheets.end();
	const FormBuffers mesh = sheets.buffers();
	const Outlines much = { 2.0f, 2.0f, 2.0f, 2.0f };
	float worst = worst_of(sheets.outlines(BOX), much);
	OutlineFit fit(sheets.units, mesh);
	fit.detach();
	fit.search(BOX, much, GOAL, worst);
	const glm::vec3 aside(sheets.asides[1]);
	CHECK(glm::length(aside) < 0.1f * (1.7f + 1.7f * 0.25f) + 1e-4f);
	const glm::vec3 normal = sheets.normals[1];
	CHECK(glm::dot(glm::cross(glm::vec3(0.0f, 1.0f, 0.0f), aside), normal) *
					glm::dot(glm::cross(glm::vec3(0.0f, 1.0f, 0.0f), facing(0.1f, 0.3f)),
							glm::vec3(-std::sin(0.3f), 0.0f, std::cos(0.3f))) >
			0.0f);
}

TEST_CASE("sheets at their max width leave the rest to all other sheets") {
	Sheets sheets;
	sheets.add({ -0.4f, 0.0f, 0.0f }, facing(0.05f, 0.0f));
	sheets.add({ 0.4f, 0.0f, 0.0f }, facing(0.05f, 1.5f));
	sheets.units[0].max = 1.2f;
	sheets.end();
	const FormBuffers mesh = sheets.buffers();
	const Outlines wanted = { 0.14f, 0.2f, 0.2f, 0.2f };
	float worst = worst_of(sheets.outlines(BOX), wanted);
	OutlineFit fit(sheets.units, mesh);
	fit.detach();
	fit.search(BOX, wanted, GOAL, worst);
	CHECK(worst < 0.2f);
	CHECK(glm::length(glm::vec3(sheets.asides[1])) < 0.05f * 1.2f * 1.85f + 1e-4f);
}
