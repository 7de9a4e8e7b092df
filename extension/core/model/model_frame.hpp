#pragma once

#include "model/model_surface.hpp"

#include <glm/mat3x3.hpp>

namespace undergrowth {

/// Direction of a file in which a plant grows.
enum class UpAxis {
	automatic,
	plus_y,
	minus_y,
	plus_z,
	minus_z,
	plus_x,
	minus_x,
};

/// What a user sets; everything else is found.
struct ModelFrameOptions {
	UpAxis up = UpAxis::automatic;
	float height = 0.0f; ///< m, of the plant; 0: that of the file.
	bool has_root = false;
	glm::vec3 root = glm::vec3(0.0f); ///< In the file's axes and unit: the point on the ground, if `has_root`.
};

/// From a file's axes to a plant's: y up, the root at the origin, metres.
struct ModelFrame {
	glm::mat3 turn = glm::mat3(1.0f); ///< A rotation.
	float scale = 1.0f;
	glm::vec3 root = glm::vec3(0.0f); ///< In the turned axes and the file's unit.
	float height = 0.0f; ///< m, of the highest vertex above the root.
	UpAxis up = UpAxis::plus_y;

	glm::vec3 place_of(const glm::vec3 &in_file) const { return (turn * in_file - root) * scale; }
	glm::vec3 direction_of(const glm::vec3 &in_file) const { return turn * in_file; }
};

/// Finds the frame of surfaces without a fault.
///
/// - Up is +y, unless the origin of the file is at the base of another axis and not of y. Without such an origin, it is
///   +z only if the largest island, or a narrow base, begins there.
/// - The file's origin is the root if it is within the base of the plant, or below it by a buried part of at most a
///   fifth of the height. Otherwise the root is the centre of the lowest part.
/// - Other units than metres are found by the height: above 20 it is in centimetres, above 2000 in millimetres, below
///   0.01 in units of 100 m.
ModelFrame find_model_frame(const std::vector<ModelSurface> &surfaces, const ModelFrameOptions &options);

} // namespace undergrowth
