#pragma once

#include <glm/vec3.hpp>

#include <vector>

namespace undergrowth {

/// A branch in the modes of a branched beam: straight, with an even mass along it.
struct BranchBeam {
	int carrier = -1; ///< Index of the beam that carries it, below its own; -1: a fixed base.
	float offset = 1.0f; ///< Of its base on the carrier, 0 to 1.
	glm::vec3 base = { 0.0f, 0.0f, 0.0f }; ///< m.
	glm::vec3 way = { 0.0f, 1.0f, 0.0f }; ///< m, from its base to its tip.
	glm::vec3 side = { 1.0f, 0.0f, 0.0f }; ///< Unit, across `way`: the direction in which it swings.
	float mass = 1.0f; ///< kg, above 0.
	float frequency = 1.0f; ///< Hz, above 0: on a fixed base, with what it carries rigid.
};

/// Frequencies of a branched beam.
struct BranchModes {
	std::vector<float> modes; ///< Hz, ascending, as many as beams.
	/// Hz, of each beam: of the mode that has most of its energy.
	std::vector<float> of_beams;
};

/// Returns the modes of beams that swing on each other, by component modes (Craig and Bampton 1968): each beam has the
/// first mode of a cantilever with rigid branches on it. The modes are within 3 % of those of finite elements while the
/// branches on a beam weigh up to a quarter of it.
BranchModes find_branch_modes(const std::vector<BranchBeam> &beams);

} // namespace undergrowth
