#pragma once

#include "bodies/group_bodies.hpp"
#include "field/field_options.hpp"
#include "field/field_settings.hpp"
#include "field/field_style.hpp"
#include "motion/joint.hpp"
#include "motion/part_bend.hpp"
#include "stand/kept_plants.hpp"
#include "stand/plant_store.hpp"
#include "wind/travelling_wind.hpp"

#include <godot_cpp/variant/rid.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace undergrowth {

/// Location of a block's poses for the shader: plant `slot` has texel first + slot of a layer.
struct PoseTexels {
	int layer = -1;
	int first = 0;
};

/// A motion's data for a field that is being built on a worker thread. FieldMotion::adopt() uses it.
class PreparedMotion {
public:
	virtual ~PreparedMotion() = default;
	/// Texels of block i of the list that it was prepared for.
	virtual PoseTexels texels(int block) const = 0;
	/// Adds all plants of this list, at rest. Call it once, on any thread. Another thread may make the style's
	/// materials and meshes at the same time.
	virtual void fill(const std::vector<PlantBlock> &blocks, const FieldStyle &style) = 0;
	/// True if it needs more texture layers than graphics cards have.
	virtual bool is_too_large() const = 0;
};

/// A motion's data for a new block of an existing field, made on a worker thread. FieldMotion::apply() uses it.
class PreparedBlock {
public:
	virtual ~PreparedBlock() = default;
};

/// New blocks of an existing field.
struct ArrivingBlocks {
	std::vector<std::unique_ptr<PreparedBlock>> prepared; ///< In the order of the edit's `stood`.
	/// Plants that continue their motion, from blocks that the same edit drops.
	std::vector<KeptPlant> kept;
	/// Multimeshes of dropped plants remain. Their texels then draw nothing and are not reused.
	bool leaves_texels = false;
};

/// The interface of a field's motion and of its textures for the graphics card. CpuMotion implements it with the core's
/// simulation on worker threads; another implementation may use the graphics card. No other class uses pages, steps or
/// threads.
///
/// A motion follows the PlantStore by change sets; block numbers are the store's. A method with a name that ends in
/// `_now` waits until the state is valid.
class FieldMotion {
public:
	/// Inputs of a frame.
	struct Frame {
		double delta = 0.0; ///< s.
		godot::Transform3D axes; ///< From the field's to the world's, invertible.
		godot::Ref<PlantWind> wind; ///< Null: still air.
		std::vector<godot::Vector3> eyes; ///< World axes: the cameras.
		godot::SceneTree *tree = nullptr;
		uint64_t world = 0; ///< Instance id of the field's World3D.
	};
	/// Delays of plants that follow prototypes, for the shader: steps per metre of world x, y and z, and steps at the
	/// world's origin.
	struct Delays {
		godot::Vector4 after, before;
		float share = 1.0f; ///< Weight of `after` during a change from `before` to it.
	};
	/// Allocates the data for blocks of a style, for PreparedMotion::fill() and then adopt(), under a wind at its
	/// start. On any thread.
	using Prepare = std::unique_ptr<PreparedMotion> (*)(const std::vector<PlantBlock> &blocks, const FieldStyle &style,
			const FieldSettings &settings, const FieldWind &wind);

	FieldMotion() = default;
	virtual ~FieldMotion() = default;
	FieldMotion(const FieldMotion &) = delete;
	FieldMotion &operator=(const FieldMotion &) = delete;

	virtual Prepare prepare() const = 0;
	/// Prepares a block of a style for apply(). On any thread.
	using PrepareBlock = std::unique_ptr<PreparedBlock> (*)(
			const PlantBlock &block, const FieldStyle &style, const FieldSettings &settings);
	virtual PrepareBlock prepare_block() const = 0;
	/// Waits until no other thread works on it, including a transfer of motion.
	virtual void wait() = 0;
	virtual bool is_ready() const = 0;
	/// True if the next advance() uses Frame::eyes. Most do not.
	virtual bool wants_eyes() const = 0;
	/// Starts an empty field, for plants that code adds.
	virtual void start(const FieldSettings &settings) = 0;
	/// Begins to transfer motion from existing plants to `prepared` on another thread, for adopt(). Nothing steps until
	/// then. Both arguments must remain valid until forget_hand_over() or adopt().
	virtual void hand_over(PreparedMotion &prepared, const std::vector<KeptPlant> &kept) = 0;
	virtual bool is_handing_over() const = 0;
	/// Cancels the transfer: there is no adopt().
	virtual void forget_hand_over() = 0;
	/// Uses the data of a build: block i of `prepared` is block changes.grown[i] of the store. Plants that existed
	/// before continue their motion.
	virtual void adopt(PreparedMotion &prepared, const std::vector<KeptPlant> &kept, const ChangeSet &changes,
			const PlantStore &store, const FieldStyle &style) = 0;
	/// Follows an edit that does not replace all generated plants. Removed plants may be visible until the next wait().
	/// With `arriving` only its blocks grew; null: no block is prepared.
	virtual void apply(
			const ChangeSet &changes, const PlantStore &store, const FieldStyle &style, ArrivingBlocks *arriving) = 0;
	/// Reserves the texels of a prepared block until apply() or give_up(). Call it between two steps.
	virtual PoseTexels reserve(PreparedBlock &prepared) = 0;
	virtual void give_up(PreparedBlock &prepared) = 0;
	/// Adds texture layers for about `plants` plants in `blocks` blocks that come later. Without it the textures are
	/// made again several times while the field grows.
	virtual void make_room(double plants, int blocks) = 0;
	virtual void add_species(const FieldLook &look) = 0;
	/// True if the textures have layers for another species. Call it only if is_ready().
	virtual bool has_room_for_species() const = 0;
	/// Changes the constants of a species without interrupting the motion. If nothing moves (`is_still`), plants at
	/// rest change to a new rest direction at once.
	virtual void set_species(int index, const FieldLook &look, const PlantStore &store, bool is_still) = 0;
	virtual void set_update_interval(int steps) = 0;
	/// Switches contact on or off. Call it again after tips changed their spheres.
	virtual void fit_contact(bool on) = 0;
	/// True if too many tips touch, so that some pairs are left out.
	virtual bool is_crowded() const = 0;

	/// Runs the steps of a frame. The last step continues on other threads and is shown in the next frame. Returns the
	/// µs of this thread that steps took; steps of small fields run on this thread.
	virtual double advance(const Frame &frame, const MotionOptions &options) = 0;
	/// Runs steps for a tool, at the wind's own clock and without bodies, and returns when they are done.
	virtual void preview(const Frame &frame, const MotionOptions &options) = 0;
	/// s of the wind's clock, of the states of plants.
	virtual double motion_time() const = 0;
	/// Sets all plants to rest.
	virtual void settle() = 0;

	/// Uploads changes to the textures. Returns true if the textures are new ones, or have heights for the first time.
	virtual bool upload() = 0;
	/// Hides a plant in the textures, for example while a skeleton shows it, or shows it again.
	virtual void set_hidden(const PlantPlace &place, bool hidden) = 0;
	/// Sets the drawn height of a plant, as a fraction of its full height. It moves as `plant` from now on. This may
	/// take effect only at the next wait().
	virtual void set_height(const PlantPlace &place, float share, const MotionPlant &plant) = 0;
	/// True if any plant has less than its full height.
	virtual bool has_heights() const = 0;
	/// Texels of an existing block of the store.
	virtual PoseTexels texels(int block) const = 0;
	/// Bends before and after, and a blend for each row of texels. Invalid before the first upload().
	virtual godot::RID pose_texture() const = 0;
	virtual godot::RID blend_texture() const = 0;
	/// For each row of texels: steps per second, and the layers of rests, of second modes and of heights, or -1.
	virtual godot::RID beat_texture() const = 0;
	/// Drawn time of the swing clock: 0 to 1, a fraction of SWING_PERIOD.
	virtual float swing_clock() const = 0;
	/// Mean lean of a species' plants over the last seconds: displacement of their tips from calm air, in heights.
	virtual float mean_lean(int species) const = 0;
	/// History of a species' prototypes for the shader: first layer, newest slot, blend. x is -1 if each plant is
	/// simulated.
	virtual godot::Vector4 history_of(int species) const = 0;
	virtual bool follows_prototypes() const = 0;
	virtual Delays follower_delays(const godot::Transform3D &axes) const = 0;

	virtual MotionState read_state_now(const PlantPlace &place) = 0;
	/// Position of its tip (m, field axes).
	virtual glm::vec3 read_tip_now(const PlantPlace &place) = 0;
	/// The bend that is drawn in this frame and the remaining values that move a plant's parts, in the field's axes.
	virtual StemMotion read_drawn_stem_now(const PlantPlace &place) const = 0;
	virtual bool is_point_in_plants_now(const glm::vec3 &point, float margin) = 0;
	virtual void write_state(const PlantPlace &place, const MotionState &state) = 0;
	virtual void apply_impulse(const PlantPlace &place, const glm::vec3 &impulse) = 0;

	virtual int simulated_count() const = 0;
	virtual double bytes_per_plant() const = 0;
	virtual double busy_usec() const = 0;

	GroupBodies bodies;
	/// Returns the bodies that entered or left plants since the last call.
	std::vector<GroupBodies::Event> take_events() { return std::exchange(events, {}); }

protected:
	std::vector<GroupBodies::Event> events;
};

} // namespace undergrowth
