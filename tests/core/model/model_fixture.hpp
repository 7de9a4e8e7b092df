#pragma once

#include "model/model_motion.hpp"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <vector>

namespace undergrowth {

/// A surface of a model made for a test.
struct MadeSurface {
	std::vector<glm::vec3> positions;
	std::vector<int32_t> indices;
	std::vector<glm::vec4> colors; // Empty: none.
	bool is_foliage = false;

	void quad(const glm::vec3 &a, const glm::vec3 &b, const glm::vec3 &c, const glm::vec3 &d) {
		const int first = int(positions.size());
		positions.insert(positions.end(), { a, b, c, d });
		for (const int corner : { 0, 1, 2, 0, 2, 3 }) {
			indices.push_back(first + corner);
		}
	}
	/// A prism of `rows` along +y, with vertices of its own for each face, as flat shading has them.
	void stem(float height, float radius, const glm::vec3 &root = glm::vec3(0.0f), int rows = 6, int sides = 5) {
		const auto at = [&](int row, int side) {
			const float turn = 6.2831853f * float(side % sides) / float(sides);
			return root +
					glm::vec3(radius * std::cos(turn), height * float(row) / float(rows), radius * std::sin(turn));
		};
		for (int row = 0; row < rows; row++) {
			for (int side = 0; side < sides; side++) {
				quad(at(row, side), at(row, side + 1), at(row + 1, side + 1), at(row + 1, side));
			}
		}
	}
	/// A leaf from `base` with a length along `way`.
	void leaf(const glm::vec3 &base, const glm::vec3 &way, float width) {
		const glm::vec3 up(0.0f, 1.0f, 0.0f);
		const glm::vec3 across = std::fabs(way.y) > 0.99f * glm::length(way) ? glm::vec3(1.0f, 0.0f, 0.0f)
																			 : glm::normalize(glm::cross(way, up));
		const glm::vec3 half = 0.5f * width * across;
		quad(base - half, base + half, base + way + half, base + way - half);
	}
	void transform(const glm::mat3 &by, const glm::vec3 &shift = glm::vec3(0.0f)) {
		for (glm::vec3 &position : positions) {
			position = by * position + shift;
		}
	}
	ModelSurface surface() const {
		return { positions.data(), int(positions.size()), indices.data(), int(indices.size()),
			colors.empty() ? nullptr : colors.data(), is_foliage };
	}
};

/// A stem of 0.8 m with eight leaves of 0.2 m from 0.2 m on, in one surface.
inline MadeSurface leafy_stem() {
	MadeSurface made;
	made.stem(0.8f, 0.01f);
	for (int i = 0; i < 8; i++) {
		const float turn = 2.4f * float(i);
		const glm::vec3 side(std::cos(turn), 0.0f, std::sin(turn));
		made.leaf(0.01f * side + glm::vec3(0.0f, 0.2f + 0.06f * float(i), 0.0f),
				0.2f * glm::normalize(side + glm::vec3(0.0f, 0.4f, 0.0f)), 0.04f);
	}
	return made;
}

inline ModelMotion motion_of(const std::vector<ModelSurface> &surfaces, const ModelFrameOptions &options = {}) {
	return find_model_motion(surfaces, find_model_frame(surfaces, options));
}

} // namespace undergrowth
