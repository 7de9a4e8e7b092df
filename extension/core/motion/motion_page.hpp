#pragma once

#include "motion/bend_encoding.hpp"
#include "motion/columns.hpp"
#include "motion/joint.hpp"
#include "motion/joint_constants.hpp"
#include "motion/kernel_tables.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// What all plants of one species in a field share.
struct MotionSpecies {
	Law law = Law::elasticity;
	Joint joint; ///< Without `length` and `rest`, which each plant has of its own.
	float collision_radius = 0.05f; ///< m, of the sphere at a tip.
	// Of the prototypes only, which stand for all plants of the species.
	float shortest = 0.5f; ///< m.
	float longest = 1.0f; ///< m.
	float lean = 0.0f; ///< rad, from upright to the rest direction (spring law).
};

/// One plant as it enters a field.
struct MotionPlant {
	glm::vec3 root = { 0.0f, 0.0f, 0.0f }; ///< m, field axes.
	float length = 1.0f; ///< m, > 0.
	glm::vec3 rest = { 0.0f, 1.0f, 0.0f }; ///< Unit; of the spring law only, as Joint::rest.
};

/// Whether all numbers are finite, the length > 0 and the rest direction above the ground.
bool is_valid(const MotionPlant &plant);

/// Up to PAGE_PLANTS plants of one species in struct-of-arrays, with their bends. A page may be stepped by any whole
/// number of steps at once; its constants belong to that interval.
class MotionPage {
public:
	static constexpr int PAGE_PLANTS = 4096;

	/// At rest, upright (elasticity law) or along `rest` (spring law), for steps of `step` seconds.
	/// Of `plants`, `count` <= PAGE_PLANTS valid ones; a page that does not swing holds places only: its plants stand
	/// upright.
	MotionPage(int species_index, const MotionSpecies &species, const MotionPlant *plants, int count, float step,
			bool swings);

	int species() const { return species_number; }
	/// Rows, those of plants that are gone included.
	int size() const { return rows.size(); }
	/// Plants that are not gone.
	int standing() const { return size() - gone; }
	/// Whether a plant was dropped: its row keeps its index, and its length is 0.
	bool is_gone(int index) const { return lengths()[index] <= 0.0f; }
	bool swings() const { return is_swinging; }
	Law law() const { return kind.law; }
	/// Seconds of the step that the constants are for.
	float step_length() const { return step_time; }

	/// Columns of roots and lengths (m), size() each.
	const float *roots_x() const { return rows.column(0); }
	const float *roots_y() const { return rows.column(1); }
	const float *roots_z() const { return rows.column(2); }
	const float *lengths() const { return rows.column(3); }
	float collision_radius() const { return kind.collision_radius; }
	float mass() const { return kind.joint.mass; }
	glm::vec3 root(int index) const;
	float length(int index) const;
	/// The direction of a plant in calm air.
	glm::vec3 rest(int index) const;
	/// Where a plant points: unit, root to tip.
	glm::vec3 direction(int index) const;
	/// The root's place plus length times the direction.
	glm::vec3 tip(int index) const;
	TipState state(int index) const;
	/// Puts a plant into a state; the bend that is drawn as the last one is this state's.
	void set_state(int index, const TipState &state);
	/// Plant `from` of another page, of any law, goes on as plant `index`, and is drawn where it was.
	void take_motion(int index, const MotionPage &other, int from);
	/// Another direction in calm air (unit, y > 0), of the spring law; the motion goes on.
	void set_rest(int index, const glm::vec3 &rest);
	/// Puts all plants into their rest directions, without velocity; both bends of each are those.
	void settle();
	/// Makes room for `plants` in all, so that add() does not allocate until there are more.
	void reserve(int plants);
	/// Appends `count` valid plants, at rest; no more than PAGE_PLANTS in all.
	void add(const MotionPlant *plants, int count);
	/// Takes plant `index` away and leaves its row, upright and without length. Nothing where it is gone.
	void drop(int index);
	/// Removes plant `index`; the last one takes its index.
	void remove(int index);

	/// Other constants; the motion goes on. Where the law changes, plants of the spring law rest upright.
	void set_species(const MotionSpecies &species);
	/// Constants for steps of another length (s); the motion goes on. Allocates nothing.
	void set_step_length(float step);
	/// When in a step its wind is to be taken, as a share of it: the elasticity law's kick stands at the start of the
	/// drift (its rate is that of the middle), the spring law's closed form holds the force of the middle.
	double wind_moment() const { return kind.law == Law::elasticity ? 0.0 : 0.5; }
	/// One step under `wind`, and the bends after it.
	void step(const TravellingWind &wind, const PlantWinds &along);

	/// Pairs of bends, 2·size(), of a page that swings: each plant's before its last step and after it.
	const Bend *bends() const { return pairs.data(); }
	Bend *bends() { return pairs.data(); }

	/// The box (m) that holds all roots and every place that a tip can reach.
	const glm::vec3 &low() const { return box_low; }
	const glm::vec3 &high() const { return box_high; }
	/// Of the heap.
	std::size_t bytes() const;

private:
	int species_number;
	bool is_swinging;
	float step_time; ///< s.
	int gone = 0;
	MotionSpecies kind;
	SpringConstants spring = {};
	ElasticityConstants elasticity = {}; ///< Only what does not depend on a plant's length.
	glm::vec3 box_low = { 0.0f, 0.0f, 0.0f };
	glm::vec3 box_high = { 0.0f, 0.0f, 0.0f };
	Columns rows;
	std::vector<Bend> pairs;

	float *column(int which) { return rows.column(which); }
	const float *column(int which) const { return rows.column(which); }
	ElasticityPage elasticity_page(int begin);
	SpringPage spring_page(int begin);
	/// Of the plants from `begin` on.
	void update_constants(int begin);
	void put_state(int index, const TipState &state);
	void settle(int index);
	void grow_box(const MotionPlant &plant);
	void update_box();
};

} // namespace undergrowth
