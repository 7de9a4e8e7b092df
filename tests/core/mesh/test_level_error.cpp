#include "../form/form_species.hpp"
#include "form_mesh_fixture.hpp"
#include "mesh/level_error.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace undergrowth;

namespace {

SeenMesh seen(const BuiltForm &mesh) {
	return { mesh.positions.data(), mesh.size(), mesh.indices.data(), static_cast<int>(mesh.indices.size()) };
}

BuiltForm level_of(const PlantForm &form, int segments) {
	return build(form, plan_form(form, measure_form(form), vertex_budget(segments)));
}

/// A ribbon of 1 m height and 2 cm width.
struct Ribbon {
	std::vector<glm::vec3> positions;
	std::vector<int32_t> indices = { 0, 1, 2, 2, 1, 3 };

	explicit Ribbon(float aside) {
		for (const float y : { 0.0f, 1.0f }) {
			positions.emplace_back(aside - 0.01f, y, 0.0f);
			positions.emplace_back(aside + 0.01f, y, 0.0f);
		}
	}
	SeenMesh mesh() const { return { positions.data(), 4, indices.data(), 6 }; }
};

} // namespace

TEST_CASE("the error of an equal outline is half a dot") {
	const Ribbon ribbon(0.0f);
	const LevelError error(ribbon.mesh());
	CHECK(error.dot() > 0.0f);
	CHECK(error.of(ribbon.mesh()) == doctest::Approx(0.5f * error.dot()));
}

TEST_CASE("the error of a moved outline is the way that it moved") {
	const LevelError error(Ribbon(0.0f).mesh());
	// From the side it is moved along the view, so that two of three views show it.
	CHECK(error.of(Ribbon(0.06f).mesh()) == doctest::Approx(0.06f).epsilon(0.15));
	CHECK(error.of(Ribbon(0.1f).mesh()) == doctest::Approx(0.1f).epsilon(0.15));
}

TEST_CASE("few wrong dots above the leaves count as much as many below") {
	const auto plant = [](float head) {
		Ribbon made(0.0f);
		const auto add = [&](const Ribbon &other, float top, float from) {
			const int32_t first = static_cast<int32_t>(made.positions.size());
			for (const glm::vec3 &point : other.positions) {
				made.positions.emplace_back(point.x, from + point.y * (top - from), point.z);
			}
			for (const int32_t index : { 0, 1, 2, 2, 1, 3 }) {
				made.indices.push_back(first + index);
			}
		};
		for (int i = 0; i < 20; i++) {
			add(Ribbon(0.03f * static_cast<float>(i)), 0.5f, 0.0f);
		}
		add(Ribbon(head), 1.0f, 0.8f);
		return made;
	};
	const Ribbon whole = plant(0.08f);
	const Ribbon level = plant(-0.08f);
	const SeenMesh seen_whole = { whole.positions.data(), static_cast<int>(whole.positions.size()),
		whole.indices.data(), static_cast<int>(whole.indices.size()) };
	const SeenMesh seen_level = { level.positions.data(), static_cast<int>(level.positions.size()),
		level.indices.data(), static_cast<int>(level.indices.size()) };
	CHECK(LevelError(seen_whole).of(seen_level) > 0.03f);
}

TEST_CASE("coarser levels of a plant have larger errors") {
	for (const auto grow : { grow_grass, grow_daisy }) {
		const PlantForm form = grow(4);
		const LevelError error = measure_outline(form);
		const BuiltForm fine = level_of(form, 24);
		const BuiltForm coarse = level_of(form, 3);
		CHECK(error.of(seen(fine)) < 0.01f * form.height);
		CHECK(error.of(seen(coarse)) > 2.0f * error.of(seen(fine)));
		CHECK(error.of(seen(coarse)) == LevelError(measure_outline(form)).of(seen(coarse)));
	}
}

TEST_CASE("a plant without any surface has no error") {
	const LevelError error(SeenMesh{});
	CHECK(error.of(Ribbon(0.0f).mesh()) == 0.0f);
}
