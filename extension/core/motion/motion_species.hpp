#pragma once

#include "motion/joint.hpp"
#include "motion/lasting_bends.hpp"
#include "stem/stem_constants.hpp"

#include <glm/vec3.hpp>

namespace undergrowth {

/// Parameters that all plants of one species share.
struct MotionSpecies {
	Law law = Law::elasticity;
	Joint joint; ///< `length` and `rest` are per plant and unused here. Stems use only `above_ground`.
	StemConstants stem; ///< Stem law.
	float collision_radius = 0.05f; ///< m, of the sphere at a tip.
	Trampling trampling; ///< Stem law.
	float canopy_height = 0.0f; ///< m, canopy that shelters its plants; 0: isolated plants.
	// For prototypes only, which represent all plants of the species.
	float shortest = 0.5f; ///< m; of all, where air is sampled ahead.
	float longest = 1.0f; ///< m.
	float lean = 0.0f; ///< rad, from upright to the rest direction (not of the elasticity law).
	bool has_parts = false; ///< Which swing by themselves; it does not matter to the motion.
};

/// Whether plants of both move alike, so that they may share a page.
bool is_same_motion(const MotionSpecies &a, const MotionSpecies &b);

/// Whether plants of the same length have the same MotionPage::drag_area() and the same canopy in both.
bool has_same_drag(const MotionSpecies &a, const MotionSpecies &b);

/// One plant as it enters a page.
struct MotionPlant {
	glm::vec3 root = { 0.0f, 0.0f, 0.0f }; ///< m; only x and z matter to the wind.
	float length = 1.0f; ///< m, > 0.
	glm::vec3 rest = { 0.0f, 1.0f, 0.0f }; ///< Unit; not of the elasticity law; as Joint::rest.
	/// Of the whole plant, the stem's diameter included, > 0; `length` contains it. A larger plant of the same
	/// proportions swings more slowly and bends as far in the air.
	float scale = 1.0f;
	float own = 0.0f; ///< Place of its frequency among plants of its size, -1 to 1; see StemConstants::spread.
};

/// MotionPlant::own of the plant of a field with this root, by x and z: uniform, the same on every platform.
float own_of_root(const glm::vec3 &root);

/// Whether all numbers are finite and in range, the length > 0 and the rest direction above the ground.
bool is_valid(const MotionPlant &plant);

} // namespace undergrowth
