#pragma once

#include "climb/climb_growth.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstddef>

using namespace undergrowth;

inline void add_quad(ClimbSupport &support, const glm::vec3 &a, const glm::vec3 &b, const glm::vec3 &c,
		const glm::vec3 &d, int body = 0) {
	support.corners.insert(support.corners.end(), { a, b, c, a, c, d });
	support.bodies.insert(support.bodies.end(), { body, body });
}

/// A wall in the plane z = 0 that faces +z, as high below y = 0 as above.
inline ClimbSupport wall_of(float width, float height) {
	ClimbSupport support;
	const float x = 0.5f * width;
	add_quad(support, { -x, -height, 0.0f }, { -x, height, 0.0f }, { x, height, 0.0f }, { x, -height, 0.0f });
	return support;
}

/// A closed box from `low` to `high`.
inline void add_box(ClimbSupport &support, const glm::vec3 &low, const glm::vec3 &high, int body = 0) {
	const auto at = [&](int i) {
		return glm::vec3((i & 1) ? high.x : low.x, (i & 2) ? high.y : low.y, (i & 4) ? high.z : low.z);
	};
	const int faces[6][4] = { { 0, 1, 3, 2 }, { 4, 6, 7, 5 }, { 0, 2, 6, 4 }, { 1, 5, 7, 3 }, { 0, 4, 5, 1 },
		{ 2, 3, 7, 6 } };
	for (const int (&face)[4] : faces) {
		add_quad(support, at(face[0]), at(face[1]), at(face[2]), at(face[3]), body);
	}
}

inline ClimbSupport sphere_of(float radius, int rows = 24) {
	ClimbSupport support;
	const auto at = [&](int row, int column) {
		const double up = 3.14159265358979 * row / rows;
		const double around = 3.14159265358979 * column / rows;
		return radius * glm::vec3(std::sin(up) * std::cos(around), -std::cos(up), std::sin(up) * std::sin(around));
	};
	for (int row = 0; row < rows; row++) {
		for (int column = 0; column < 2 * rows; column++) {
			add_quad(support, at(row, column), at(row + 1, column), at(row + 1, column + 1), at(row, column + 1));
		}
	}
	return support;
}

inline Climb grown_on(const ClimbSupport &support, const ClimbSettings &settings) {
	Climb climb;
	const std::string fault = grow_climb(support, settings, climb);
	INFO(fault);
	CHECK(fault.empty());
	return climb;
}

/// The tip of a leaf's blade and both sides of it (m).
struct LeafOutline {
	glm::vec3 tip, left, right;

	LeafOutline(const ClimbLeaf &leaf, float reach) {
		const float size = reach * leaf.size;
		const glm::vec3 raised = leaf.place + leaf.out * (0.25f * size);
		const glm::vec3 side = glm::cross(leaf.out, leaf.down) * (0.5f * size);
		tip = raised + leaf.down * size;
		left = raised + leaf.down * (0.6f * size) + side;
		right = raised + leaf.down * (0.6f * size) - side;
	}
};
