#pragma once

#include "motion/bend_encoding.hpp"
#include "motion/columns.hpp"
#include "motion/joint_constants.hpp"
#include "motion/kernel_tables.hpp"
#include "motion/lasting_bends.hpp"
#include "motion/motion_species.hpp"
#include "motion/stem_impulses.hpp"
#include "motion/stem_step.hpp"
#include "wind/air_ahead.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace undergrowth {

/// New states of some stems of a page, in columns, for one call of a kernel.
struct MovedStems {
	static constexpr int MAX = 64;
	int count = 0;
	int index[MAX];
	float place_x[MAX_STEM_MODES][MAX], place_z[MAX_STEM_MODES][MAX];
	float rate_x[MAX_STEM_MODES][MAX], rate_z[MAX_STEM_MODES][MAX];

	void add(int row, const StemState &state) {
		index[count] = row;
		put(count++, state);
	}
	void put(int i, const StemState &state) {
		for (int k = 0; k < MAX_STEM_MODES; k++) {
			place_x[k][i] = state.place[k].x;
			place_z[k][i] = state.place[k].y;
			rate_x[k][i] = state.rate[k].x;
			rate_z[k][i] = state.rate[k].y;
		}
	}
	StemState at(int i) const {
		StemState state;
		for (int k = 0; k < MAX_STEM_MODES; k++) {
			state.place[k] = { place_x[k][i], place_z[k][i] };
			state.rate[k] = { rate_x[k][i], rate_z[k][i] };
		}
		return state;
	}
};

/// A batch of plants of one species in struct-of-arrays layout, stepped together by a whole number of base steps. All
/// simulated plants are in pages: a field has many pages with bends for textures, and `Plant3D`s share pages with
/// directions.
///
/// Elasticity law (thesis, formulas 3.1 and 3.2): the forces on the tip are (1 + e)·m·g·|y| upwards, m·g downwards, the
/// wind and -friction·velocity, held on the sphere: equilibrium under a horizontal force F is F·w = m·g·tan φ·((1 +
/// e)·cos φ - 1). An exact rotation preserves both norms; kicks are scaled (by sinc²(ω·step/2) without friction) so
/// that a small swing has exactly ω² = e·g/L and friction's decay at any step length up to a third of its period;
/// stiffer joints swing at about that period and stay stable. The rate is that of the middle of the last step (kick,
/// then drift).
///
/// Spring law: the state is the gnomonic image t = (x, z)/y of the direction, which obeys
/// t'' = -ω²·(t - rest - F·w/(m·ω²·L)) - 2·ζ·ω·t'. The step is the closed-form solution for a force that is constant
/// during it, so there is no step-length error, nothing can become unstable, and the tip never reaches the ground.
/// The equilibrium of an upright plant under a horizontal force F is tan φ = F·w/(m·ω²·L).
///
/// Stem law: a stem that bends along its length (stem/stem_beam.hpp, motion/stem_step.hpp). One or two oscillators per
/// plant in the frame of its rest. Its direction is that of the tip, and tip() is the end of the bent stem. The
/// equilibrium of an upright plant under a horizontal force F is tan φ = F·StemConstants::dead_slope. The wind's
/// Precipitation makes stems heavier (stem/loaded_stem.hpp); other laws ignore it.
///
/// Winds are horizontal in the axes of the roots. Directions may have other axes; step() takes the wind's direction in
/// those. Values out of range are clamped to the nearest safe one; nothing becomes NaN. Only adding allocates. Results
/// have the same bits at every SimdLevel and for any division of plants into pages.
class MotionPage {
public:
	static constexpr int PAGE_PLANTS = 4096; ///< Of a page of a field: a layer of 64 by 64 texels.
	/// What a page stores of each plant before and after its last step, for drawing.
	enum class Keeps {
		bends, ///< Half floats, ready for the graphics card.
		directions, ///< Floats, for skeletons; such a page has no bends.
	};

	/// Creates `count` valid plants at rest, upright (elasticity law) or along `rest`, for steps of `step` seconds. A
	/// page that does not swing stores positions only, and its plants are upright.
	MotionPage(int species_index, const MotionSpecies &species, const MotionPlant *plants, int count, float step,
			bool swings, Keeps keeps = Keeps::bends);

	int species() const { return species_number; }
	/// Number of rows, removed plants included.
	int size() const { return rows.size(); }
	/// Number of plants that are not removed.
	int live_count() const { return size() - gone; }
	/// True if a plant was removed with drop(): its row remains, with length 0.
	bool is_gone(int index) const { return lengths()[index] <= 0.0f; }
	bool swings() const { return is_swinging; }
	/// True if it stores bends for a texture: it swings and does not store directions.
	bool has_bends() const { return is_swinging && !keeps_directions; }
	/// True if the second mode has bends of its own.
	bool has_second_bends() const { return has_bends() && modes() == 2; }
	/// Number of stepped modes per stem: that of the species, or less after set_modes(). 0 under another law.
	int modes() const { return kind.law == Law::stem ? kind.stem.modes : 0; }
	int max_modes() const { return kind.law == Law::stem ? whole.modes : 0; }
	/// For pages without directions: steps only one of two modes, with the shape of a steady wind (in_one_mode()), in
	/// half the time, or both again. A change to one mode preserves the tip; a change to two preserves the drawn pose,
	/// the last bend included. Allocates nothing.
	void set_modes(int count);
	/// For pages with two stepped modes: the next step moves second modes by `share` towards the value that a steady
	/// wind gives them.
	void ease_second(float share) { easing = share; }
	/// True if move_tip() moved a plant since the last call.
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
	/// Mass that a blow on the tip moves (kg).
	float mass() const { return kind.law == Law::stem ? stem_mass(kind.stem, 1.0f) : kind.joint.mass; }
	glm::vec3 root(int index) const;
	float length(int index) const;
	/// Rest direction of a plant.
	glm::vec3 rest(int index) const;
	/// Direction of a plant: unit, root to tip.
	glm::vec3 direction(int index) const;
	/// Vector from the root to a point on the plant (m), from the root (share 0) to the tip (1), in the directions'
	/// axes: on the straight line along the direction, or on the bent stem.
	glm::vec3 arm(int index, float share) const;
	glm::vec3 tip(int index) const { return root(index) + arm(index, 1.0f); }
	/// m/s, of a tip.
	glm::vec3 tip_velocity(int index) const;
	TipState state(int index) const;
	StemSecond second(int index) const;
	/// Sets the state of a plant; its last drawn pose becomes the same.
	void set_state(int index, const TipState &state, const StemSecond &second = {});
	/// Transfers the motion of plant `from` of another page, of any law, to plant `index`, with the same drawn pose.
	/// With another rest direction, the deflection from it is preserved.
	void transfer_motion(int index, const MotionPage &other, int from);
	/// Drawn direction of a plant before its last step.
	glm::vec3 before(int index) const;
	void set_before(int index, const glm::vec3 &direction);
	/// Stem law only, in the frame of the rest; rest_bend() is the rest's bend in the axes of directions.
	const StemConstants &stem_constants() const { return kind.stem; }
	/// The same with all modes of its stems.
	const StemConstants &whole_stem() const { return whole; }
	StemState stem(int index) const;
	void set_stem(int index, const StemState &state);
	/// The same for several plants. Leaves in `moved` what they have then.
	void set_stems(MovedStems &moved);
	/// What kernels read and write, from row `begin` on.
	StemPage stem_page(int begin);
	/// Amplitudes before the last step, for pages with directions.
	StemState stem_before(int index) const;
	void set_stem_before(int index, const StemState &state);
	glm::vec2 rest_bend(int index) const;
	/// The second mode's part of the tip's bend at `alpha` of the last step, for pages with directions: a vector across
	/// the rest direction, in the directions' axes.
	glm::vec3 second_bend(int index, float alpha) const;
	/// Stem law: lasting bend of a plant (LastingBends). Bodies leave them where species have Trampling and the page
	/// has room; a set bend makes room. The plant swings to it.
	glm::vec2 lasting_bend(int index) const { return lasting.at(index); }
	void set_lasting_bend(int index, const glm::vec2 &bend);
	/// Moves a lasting bend by `share` of the way to `bend`, if that is longer.
	void let_last(int index, const glm::vec2 &bend, float share);
	bool has_lasting_bends() const { return lasting.is_any(); }
	void forget_lasting_bends() { lasting = LastingBends(); }
	/// Makes room for the lasting bends that plants may get in the next steps, if bodies tread them (`is_trodden`) or
	/// if the last step bent one beyond Trampling::yield. Frees unused room.
	void make_room_for_lasting_bends(bool is_trodden);
	const Trampling &trampling() const { return kind.trampling; }
	/// Stem law: moves a tip by `way` (m) and changes its velocity by `faster` (m/s), as far as they are across the
	/// stem.
	void move_tip(int index, const glm::vec3 &way, const glm::vec3 &faster);
	/// A blow on a joint: 1 to StemConstants::joints (the tip), or joints + 1 (the head).
	void apply_impulse_at(int index, int joint, const glm::vec3 &impulse);
	/// A blow on the tip (N·s): changes the velocity by impulse/mass, along the sphere. The root resists
	/// the part along the stem, so a blow upwards straightens a bent plant and does not move an upright one.
	void apply_impulse(int index, const glm::vec3 &impulse);
	/// Sets all plants to rest, without lasting bends, including their last drawn pose.
	void settle();
	/// Sets one plant to rest, in the same way.
	void settle(int index);
	/// True for a plant that does not move, without load and lasting bend, with the bend of its own weight.
	bool is_at_rest(int index);
	/// Reserves room for `plants` in total; add() does not allocate up to that number.
	void reserve(int plants);
	/// Appends `count` valid plants, at rest.
	void add(const MotionPlant *plants, int count);
	/// Removes plant `index`; its row remains, upright, with length 0. Does nothing for removed plants.
	void drop(int index);
	/// Changes position, length and rest direction of plant `index` without interrupting its motion.
	void set_plant(int index, const MotionPlant &plant);
	/// Removes plant `index`; the last plant gets its index.
	void remove(int index);

	/// Changes constants without interrupting the motion. The elasticity law has no rest directions: after a change of
	/// law plants rest upright until set_rests().
	void set_species(const MotionSpecies &species);
	/// Changes the rest directions (unit, as MotionPlant::rest) of `count` plants from `first` on; plants swing there.
	/// No effect under the elasticity law.
	void set_rests(int first, const glm::vec3 *rests, int count);
	/// Sets scale and `own` of `count` plants from `first` on. Without it plants have the default ones after a change
	/// to a species with own frequencies.
	void set_owns(int first, const MotionPlant *plants, int count);
	/// Plants that shelter those of this page from air. A change takes effect at the next step.
	void set_taller_plants(const TallerPlants &plants) { taller = plants; }
	const TallerPlants &taller_plants() const { return taller; }
	/// Drag area (m²) of plant `index`, its drag coefficient included: that of the species times the square of its
	/// relative length.
	float drag_area(int index) const;
	/// Changes the step length (s) without interrupting the motion. Allocates nothing.
	void set_step_length(float step);
	/// Time within a step at which to sample the wind, as a fraction: the elasticity law kicks at the start of the
	/// drift (its rate is that of the middle); the closed forms of the other laws use the force of the middle.
	double wind_moment() const { return kind.law == Law::elasticity ? 0.0 : 0.5; }
	/// Runs one step under `wind`, with the direction (along.x, along.z) in the directions' axes. `level` selects the
	/// code, not the result.
	void step(const WindSnapshot &wind, const PlantWinds &along, SimdLevel level = best_simd_level());

	/// Call before each step to let the page sample its air ahead (AirAhead) of the step at `moment` (s), in turn with
	/// other pages. Without it each step samples all air.
	void sample_air_ahead(const FieldWind &wind, const PlantWinds &along, double moment, int turn,
			SimdLevel level = best_simd_level());
	/// Reserves room for samples ahead. Allocates only for more plants than before.
	void make_room_ahead() { ahead.make_room(is_swinging ? size() : 0); }

	/// For pages with directions: writes the unit directions of all plants at `alpha`, from before the last step (0) to
	/// after it (1), to out[0 .. size()).
	void interpolate(float alpha, glm::vec3 *out) const;
	/// For pages with bends: 2·size() bends, for each plant before and after its last step.
	const Bend *bends() const { return pairs.data(); }
	Bend *bends() { return pairs.data(); }
	/// The same for the second mode: its part of the tip's bend in the frame of the rest.
	const Bend *second_bends() const { return second_pairs.data(); }
	Bend *second_bends() { return second_pairs.data(); }

	/// Bounding box (m) of all roots and all positions that tips can reach.
	const glm::vec3 &low() const { return box_low; }
	const glm::vec3 &high() const { return box_high; }
	/// Rows of a block.
	static constexpr int BLOCK_ROWS = 64;
	/// The same box of the rows from block * BLOCK_ROWS on, seen from above. It does not shrink when plants are
	/// removed.
	struct BlockBox {
		float low_x, high_x, low_z, high_z; ///< m.
	};
	const BlockBox &block_box(int block) const { return blocks[static_cast<std::size_t>(block)]; }
	/// Heap bytes.
	std::size_t bytes() const;
	/// Prefetches the beginnings of its columns into the cache.
	void prefetch() const;

private:
	int species_number;
	bool is_swinging;
	bool keeps_directions;
	float step_time; ///< s.
	int gone = 0;
	bool was_moved = false;
	bool has_yielded = false; ///< A stem without room for its lasting bend.
	float easing = 0.0f; ///< For the next step.
	TallerPlants taller;
	MotionSpecies kind;
	StemConstants whole; ///< Stem law: constants of all modes. `kind` has those of the stepped modes.
	SpringConstants spring = {};
	ElasticityConstants elasticity = {};
	StemStep stems = {};
	float max_load_scale = 1.0f; ///< Stem law: upper bound of LOAD_SCALE, graded or not.
	float fastest = 1.0f; ///< Graded stems: highest frequency relative to the species'.
	Precipitation load; ///< Stem law: what plants carry since the last step, rounded.
	std::vector<StemConstants> unloaded; ///< `whole` without the load, if there is one.
	StemWeight weight; ///< Of the load.
	bool has_stepped = false;
	float max_lean = 0.0f; ///< Stem law: upper bound of the rest's bends.
	glm::vec3 box_low = { 0.0f, 0.0f, 0.0f };
	glm::vec3 box_high = { 0.0f, 0.0f, 0.0f };
	std::vector<BlockBox> blocks;
	Columns rows;
	std::vector<OwnStem> owns; ///< Of stems with own frequencies, else empty.
	std::vector<Bend> pairs;
	std::vector<Bend> second_pairs;
	AirAhead ahead;
	LastingBends lasting;

	float *column(int which) { return rows.column(which); }
	const float *column(int which) const { return rows.column(which); }
	ElasticityPage elasticity_page(int begin);
	SpringPage spring_page(int begin);
	/// For the plants from `begin` on, or up to `end`.
	void update_constants(int begin) { update_constants(begin, size()); }
	void update_constants(int begin, int end);
	bool is_graded() const { return is_swinging && kind.law == Law::stem && whole.has_own_frequencies(); }
	void add_owns(const MotionPlant *plants);
	void put_owns(int first, const MotionPlant *plants, int count);
	StemGrades grades(int begin);
	void update_stems(int begin, int end);
	void put_place(int index, const MotionPlant &plant);
	void put_state(int index, const TipState &state);
	void put_stem(int index, const StemState &state);
	void put_bends(int index, const StemBends &bends);
	void change_columns(const MotionSpecies &species);
	bool has_same_columns(const MotionSpecies &species) const;
	bool has_room_for_second() const { return has_bends() && max_modes() == 2; }
	void ease_modes(int begin, int count);
	void put_modes(int index, const StemConstants &from);
	void put_pair_of_modes(std::size_t bend, const glm::vec2 &rest);
	void put_rest(int index, const glm::vec3 &rest);
	void remember();
	float quickest_swing() const;
	void step_block(const KernelSet &set, int begin, int count, const PlantWinds &winds, const PlantAir &air);
	void straighten(int index);
	void carry(const Precipitation &precipitation);
	/// Bend of a tip under the stem's own weight (StemNod), in the frame of the rest; 0 if stems do not nod.
	glm::vec2 nod(int row);
	void settle_under_weight(int begin, int end);
	bool find_calm_bends(
			const KernelSet &set, const StemPage &block, int begin, int count, const CalmBends &calm) const;
	void lodge(int begin, int count);
	void grow_box(int index, bool is_first);
	void grow_block(int index, const glm::vec3 &low, const glm::vec3 &high);
	void update_box();
};

} // namespace undergrowth
