#pragma once

#include "motion/bend_encoding.hpp"
#include "motion/columns.hpp"
#include "motion/joint_constants.hpp"
#include "motion/kernel_tables.hpp"
#include "motion/motion_species.hpp"
#include "motion/stem_blows.hpp"
#include "motion/stem_step.hpp"
#include "wind/air_ahead.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace undergrowth {

/// Plants of one species in struct-of-arrays, stepped together, by any whole number of steps at once; the page's
/// constants belong to that interval. All that moves in this add-on moves here: a field has many pages, whose bends are
/// textures' layers, and plants with skeletons of their own share pages that keep directions.
///
/// Elasticity law (thesis, formulas 3.1 and 3.2): the tip feels (1 + e)·m·g·|y| upwards, m·g downwards, the wind and
/// -friction·velocity, held on the sphere: equilibrium under a horizontal force F is F·w = m·g·tan φ·((1 + e)·cos φ -
/// 1). Both norms are kept by an exact rotation; kicks are scaled (by sinc²(ω·step/2) without friction) so that a small
/// swing has exactly ω² = e·g/L and friction's decay at any step length up to a third of its period; stiffer joints
/// swing at about that period and stay stable. The rate is that of the middle of the last step (kick, then drift).
///
/// Spring law: the state is the gnomonic image t = (x, z)/y of the direction, which obeys
/// t'' = -ω²·(t - rest - F·w/(m·ω²·L)) - 2·ζ·ω·t'. The step is the closed-form solution for a force that is constant
/// during it, so there is no step-length error, nothing can become unstable, and the tip never reaches the ground.
/// The equilibrium of an upright plant under a horizontal force F is tan φ = F·w/(m·ω²·L).
///
/// Stem law: a stem that bends along its length (stem/stem_beam.hpp, motion/stem_step.hpp). One or two oscillators a
/// plant in the frame of its rest; what is called its direction here is where the tip points, and tip() lies where the
/// bent stem ends. The equilibrium of an upright plant under a horizontal force F is tan φ =
/// F·StemConstants::dead_slope.
///
/// Winds are horizontal in the axes of the roots. Directions may have axes of their own, in which the wind's way is
/// given to step(). Numbers out of a species' or a state's range are brought to the nearest safe one; nothing becomes
/// NaN. Only adding allocates; a page has the same bits at every SimdLevel, however plants are divided among pages.
class MotionPage {
public:
	static constexpr int PAGE_PLANTS = 4096; ///< Of a page of a field: a layer of 64 by 64 texels.
	/// What a page keeps of each plant before its last step and after it, for those who draw it.
	enum class Keeps {
		bends, ///< Half floats, ready for the graphics card.
		directions, ///< Floats, for skeletons; such a page has no bends.
	};

	/// At rest, upright (elasticity law) or along `rest` (spring law), for steps of `step` seconds.
	/// Of `plants`, `count` valid ones; a page that does not swing holds places only: its plants stand upright.
	MotionPage(int species_index, const MotionSpecies &species, const MotionPlant *plants, int count, float step,
			bool swings, Keeps keeps = Keeps::bends);

	int species() const { return species_number; }
	/// Rows, those of plants that are gone included.
	int size() const { return rows.size(); }
	/// Plants that are not gone.
	int standing() const { return size() - gone; }
	/// Whether a plant was dropped: its row keeps its index, and its length is 0.
	bool is_gone(int index) const { return lengths()[index] <= 0.0f; }
	bool swings() const { return is_swinging; }
	/// Whether it keeps bends for a texture: it swings and does not keep directions.
	bool has_bends() const { return is_swinging && !keeps_directions; }
	/// Whether a second mode of its stems has bends of its own.
	bool has_second_bends() const { return has_bends() && modes() == 2; }
	/// How many modes of each stem are stepped, as many as the species' stem has unless set_modes() said less; 0 under
	/// another law.
	int modes() const { return kind.law == Law::stem ? kind.stem.modes : 0; }
	int most_modes() const { return kind.law == Law::stem ? whole.modes : 0; }
	/// Of a page that does not keep directions: steps one mode of stems that have two, with the shape of a steady wind
	/// (in_one_mode()), for half the time, or both again. Who goes over to one keeps its tip, and its stem takes that
	/// shape; who goes over to two keeps all that is seen, what was drawn as the last bend included. Allocates nothing.
	void set_modes(int count);
	/// Of a page that steps two: its next step leaves second modes nearer by `share` of the way to where, beside the
	/// first, a steady wind would bend them.
	void ease_second(float share) { easing = share; }
	/// Whether move_tip() moved anybody since this was asked last.
	bool take_moved() { return std::exchange(was_moved, false); }
	Law law() const { return kind.law; }
	/// Seconds of the step that the constants are for.
	float step_length() const { return step_time; }

	/// Columns of roots and lengths (m), size() each.
	const float *roots_x() const { return rows.column(0); }
	const float *roots_y() const { return rows.column(1); }
	const float *roots_z() const { return rows.column(2); }
	const float *lengths() const { return rows.column(3); }
	float collision_radius() const { return kind.collision_radius; }
	/// What a blow on the tip moves (kg).
	float mass() const { return kind.law == Law::stem ? stem_mass(kind.stem, 1.0f) : kind.joint.mass; }
	glm::vec3 root(int index) const;
	float length(int index) const;
	/// The direction of a plant in calm air.
	glm::vec3 rest(int index) const;
	/// Where a plant points: unit, root to tip.
	glm::vec3 direction(int index) const;
	/// From the root to a place on the plant (m), the root itself (share 0) to the tip (1), in the directions' axes: on
	/// the straight line along the direction, or on the bent stem.
	glm::vec3 arm(int index, float share) const;
	glm::vec3 tip(int index) const { return root(index) + arm(index, 1.0f); }
	/// m/s, of a tip.
	glm::vec3 tip_velocity(int index) const;
	TipState state(int index) const;
	StemSecond second(int index) const;
	/// Puts a plant into a state; what is drawn as the last one is this state's.
	void set_state(int index, const TipState &state, const StemSecond &second = {});
	/// Plant `from` of another page, of any law, goes on as plant `index`, and is drawn where it was; about another
	/// rest direction, as far from it.
	void take_motion(int index, const MotionPage &other, int from);
	/// Where a plant pointed before its last step, as it is drawn.
	glm::vec3 before(int index) const;
	void set_before(int index, const glm::vec3 &direction);
	/// Of the stem law only, in the frame of the rest, whose bend in the axes of directions is rest_bend().
	const StemConstants &stem_constants() const { return kind.stem; }
	/// The same of all modes that its stems have.
	const StemConstants &whole_stem() const { return whole; }
	StemState stem(int index) const;
	void set_stem(int index, const StemState &state);
	/// Amplitudes before the last step, of a page that keeps directions.
	StemState stem_before(int index) const;
	void set_stem_before(int index, const StemState &state);
	glm::vec2 rest_bend(int index) const;
	/// What the second mode adds to the tip's bend, `alpha` of the way of the last step, of a page that keeps
	/// directions: as a vector across the rest direction, in the directions' axes.
	glm::vec3 second_bend(int index, float alpha) const;
	/// Of the stem law: moves a tip by `way` (m), and its velocity by `faster` (m/s), as far as they go across the
	/// stem.
	void move_tip(int index, const glm::vec3 &way, const glm::vec3 &faster);
	/// A blow on a joint, 1 to StemConstants::joints, whose last one is the tip, or on the head (joints + 1).
	void apply_impulse_at(int index, int joint, const glm::vec3 &impulse);
	/// A blow on the tip (N·s): changes the velocity by impulse/mass, along the sphere. What goes along the stem is
	/// held by the root, so a blow upwards straightens a bent plant and does nothing to an upright one.
	void apply_impulse(int index, const glm::vec3 &impulse);
	/// Puts all plants into their rest directions, without velocity; both bends of each are those.
	void settle();
	/// Makes room for `plants` in all, so that add() does not allocate until there are more.
	void reserve(int plants);
	/// Appends `count` valid plants, at rest.
	void add(const MotionPlant *plants, int count);
	/// Takes plant `index` away and leaves its row, upright and without length. Nothing where it is gone.
	void drop(int index);
	/// Another place, length and rest direction of plant `index`; its motion goes on.
	void set_plant(int index, const MotionPlant &plant);
	/// Removes plant `index`; the last one takes its index.
	void remove(int index);

	/// Other constants; the motion goes on. A page of the elasticity law keeps no rest directions: where the law
	/// changes, plants rest upright until set_rests().
	void set_species(const MotionSpecies &species);
	/// Other rest directions (unit, as MotionPlant::rest) of `count` plants from `first` on; plants swing there.
	/// Without effect where the law has none.
	void set_rests(int first, const glm::vec3 *rests, int count);
	/// Constants for steps of another length (s); the motion goes on. Allocates nothing.
	void set_step_length(float step);
	/// When in a step its wind is to be taken, as a share of it: the elasticity law's kick stands at the start of the
	/// drift (its rate is that of the middle), the closed forms of the others hold the force of the middle.
	double wind_moment() const { return kind.law == Law::elasticity ? 0.0 : 0.5; }
	/// One step under `wind`, which blows along (along.x, along.z) of the directions' axes. `level` chooses the code,
	/// not the result.
	void step(const TravellingWind &wind, const PlantWinds &along, SimdLevel level = best_simd_level());

	/// For a page of many steps, before each: its air may be sampled ahead (AirAhead) of its step at `moment` (s), in
	/// turn with other pages. Without it, all of it is sampled in each step.
	void look_ahead(const FieldWind &wind, const PlantWinds &along, double moment, int turn,
			SimdLevel level = best_simd_level());
	/// Room for what is sampled ahead. Allocates where there are more plants than before.
	void make_room_ahead() { ahead.make_room(is_swinging ? size() : 0); }

	/// Of a page that keeps directions: unit directions of all plants, `alpha` of the way from before the last step (0)
	/// to after it (1), to out[0 .. size()).
	void interpolate(float alpha, glm::vec3 *out) const;
	/// Of the others that swing: pairs of bends, 2·size(), each plant's before its last step and after it.
	const Bend *bends() const { return pairs.data(); }
	Bend *bends() { return pairs.data(); }
	/// Of the second mode: its part of the tip's bend in the frame of the rest, as many.
	const Bend *second_bends() const { return second_pairs.data(); }
	Bend *second_bends() { return second_pairs.data(); }

	/// The box (m) that holds all roots and every place that a tip can reach.
	const glm::vec3 &low() const { return box_low; }
	const glm::vec3 &high() const { return box_high; }
	/// Of the heap.
	std::size_t bytes() const;
	/// It is stepped soon: the beginnings of its columns come into the cache.
	void prefetch() const;

private:
	int species_number;
	bool is_swinging;
	bool keeps_directions;
	float step_time; ///< s.
	int gone = 0;
	bool was_moved = false;
	float easing = 0.0f; ///< Of the next step.
	MotionSpecies kind;
	StemConstants whole; ///< Of the stem law: with all modes. The kind's has those that are stepped.
	SpringConstants spring = {};
	ElasticityConstants elasticity = {};
	StemStep stems = {};
	float most_load_scale = 1.0f; ///< Of the stem law: none of LOAD_SCALE is above it, eased or not.
	float fastest = 1.0f; ///< Of graded stems, over the species'.
	float most_lean = 0.0f; ///< Of the stem law: no rest's bend is larger.
	glm::vec3 box_low = { 0.0f, 0.0f, 0.0f };
	glm::vec3 box_high = { 0.0f, 0.0f, 0.0f };
	Columns rows;
	std::vector<Bend> pairs;
	std::vector<Bend> second_pairs;
	AirAhead ahead;

	float *column(int which) { return rows.column(which); }
	const float *column(int which) const { return rows.column(which); }
	ElasticityPage elasticity_page(int begin);
	SpringPage spring_page(int begin);
	StemPage stem_page(int begin);
	/// Of the plants from `begin` on, or up to `end`.
	void update_constants(int begin) { update_constants(begin, size()); }
	void update_constants(int begin, int end);
	bool is_graded() const { return kind.law == Law::stem && whole.has_grades(); }
	StemGrades grades(int begin);
	void update_stems(int begin, int end);
	void put_place(int index, const MotionPlant &plant);
	void put_state(int index, const TipState &state);
	void put_stem(int index, const StemState &state);
	void change_columns(const MotionSpecies &species);
	bool has_same_columns(const MotionSpecies &species) const;
	bool has_room_for_second() const { return has_bends() && most_modes() == 2; }
	void ease_modes(int begin, int count);
	void put_modes(int index, const StemConstants &from);
	void put_pair_of_modes(std::size_t bend, const glm::vec2 &rest);
	void put_rest(int index, const glm::vec3 &rest);
	void remember();
	float quickest_swing() const;
	void step_block(const KernelSet &set, int begin, int count, const PlantWinds &winds, const PlantAir &air);
	void settle(int index);
	void grow_box(int index, bool is_first);
	void update_box();
};

} // namespace undergrowth
