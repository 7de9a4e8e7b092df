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

/// Where the shader finds the poses of a block: plant `slot` at texel first + slot of a layer.
struct PoseTexels {
	int layer = -1;
	int first = 0;
};

/// What a motion makes of a field that is being grown, on a worker thread. FieldMotion::adopt() takes it over.
class PreparedMotion {
public:
	virtual ~PreparedMotion() = default;
	/// Of block i of the list that it was prepared for.
	virtual PoseTexels texels(int block) const = 0;
	/// Has all plants of this list at rest. Once, on any thread, beside whoever dresses the style and makes its meshes.
	virtual void fill(const std::vector<PlantBlock> &blocks, const FieldStyle &style) = 0;
	/// Whether it needs more than a graphics card has.
	virtual bool is_too_large() const = 0;
};

/// What a motion makes of a block that comes to a field that stands, on a worker thread. FieldMotion::apply() takes it.
class PreparedBlock {
public:
	virtual ~PreparedBlock() = default;
};

/// Blocks that come to a field that stands.
struct ArrivingBlocks {
	std::vector<std::unique_ptr<PreparedBlock>> prepared; ///< As the edit's `stood`.
	/// Who goes on with its motion, from blocks that the same edit drops.
	std::vector<KeptPlant> kept;
	bool leaves_texels = false; ///< Some of what draws who goes stays. It shall find nobody there, whoever comes.
};

/// How the plants of a field move, and the textures that tell the graphics card of it. This class says what a field
/// asks of a motion; CpuMotion answers it with the core's simulation on worker threads, and another one, say on the
/// graphics card, may stand in its place: nobody else knows pages, steps or threads.
///
/// A motion follows the PlantStore by change sets; block numbers are the store's. What reads a state ends in `_now`:
/// it waits until the state is known.
class FieldMotion {
public:
	/// What a frame is about.
	struct Frame {
		double delta = 0.0; ///< s.
		godot::Transform3D axes; ///< From the field's to the world's, invertible.
		godot::Ref<PlantWind> wind; ///< Null: still air.
		std::vector<godot::Vector3> eyes; ///< World axes: whoever looks.
		godot::SceneTree *tree = nullptr;
		uint64_t world = 0; ///< Instance id of the field's World3D.
	};
	/// How late followers of prototypes are, as the shader takes it: steps by metre of world x, y and z, and at the
	/// world's origin.
	struct Delays {
		godot::Vector4 after, before;
		float share = 1.0f; ///< Of `after`, while they go over to it.
	};
	/// Has room for blocks of a style, for PreparedMotion::fill() and then adopt(), under a wind at its start. On any
	/// thread.
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
	/// Until nothing of it is at work beside this thread, a hand-over included.
	virtual void wait() = 0;
	virtual bool is_ready() const = 0;
	/// Whether the next advance() asks for Frame::eyes. It does so now and then only.
	virtual bool wants_eyes() const = 0;
	/// An empty field, for plants that code adds.
	virtual void start(const FieldSettings &settings) = 0;
	/// Begins, beside this thread, to give plants of `prepared` the motion of those that they were, for adopt(). Until
	/// then nothing steps. Both stay where they are until forget_hand_over() or adopt().
	virtual void hand_over(PreparedMotion &prepared, const std::vector<KeptPlant> &kept) = 0;
	virtual bool is_handing_over() const = 0;
	/// It is not adopted after all.
	virtual void forget_hand_over() = 0;
	/// Takes over what was grown: block i of `prepared` is block changes.grown[i] of the store. Plants that stood
	/// before go on with their motion.
	virtual void adopt(PreparedMotion &prepared, const std::vector<KeptPlant> &kept, const ChangeSet &changes,
			const PlantStore &store, const FieldStyle &style) = 0;
	/// Follows an edit that fills nothing. Who goes may be seen until the next wait(). With `arriving` only its blocks
	/// grew; null: nothing is prepared.
	virtual void apply(
			const ChangeSet &changes, const PlantStore &store, const FieldStyle &style, ArrivingBlocks *arriving) = 0;
	/// Where the shader will find a prepared block, before it is one of the store; until apply() takes it, or it is
	/// given up. Between two steps.
	virtual PoseTexels reserve(PreparedBlock &prepared) = 0;
	virtual void give_up(PreparedBlock &prepared) = 0;
	/// Makes room in the textures for about as many plants, in so many blocks, that come later. Without it the textures
	/// are made again and again as the field grows.
	virtual void make_room(double plants, int blocks) = 0;
	virtual void add_species(const FieldLook &look) = 0;
	/// Whether the textures have layers left for another species. Once it is ready.
	virtual bool has_room_for_species() const = 0;
	/// The species' constants are others; the motion goes on. Where nothing moves (`is_still`), plants at rest take
	/// another rest direction at once and show it.
	virtual void set_species(int index, const FieldLook &look, const PlantStore &store, bool is_still) = 0;
	virtual void set_update_interval(int steps) = 0;
	/// On or off, and anew where tips got other spheres.
	virtual void fit_contact(bool on) = 0;
	/// Whether so many tips touch that some pairs are left out.
	virtual bool is_crowded() const = 0;

	/// Steps for a frame: the last one goes on beside it and is shown in the next one. Tells how many µs of this
	/// thread steps took, which small fields take here.
	virtual double advance(const Frame &frame, const MotionOptions &options) = 0;
	/// Steps for a tool, at the wind's own clock and without bodies; done when it returns.
	virtual void preview(const Frame &frame, const MotionOptions &options) = 0;
	/// s of the wind's clock: the moment that the states of plants belong to.
	virtual double motion_time() const = 0;
	/// All plants into their rest.
	virtual void settle() = 0;

	/// Sends what is new to the textures; tells whether they are other ones now, or show heights for the first time.
	virtual bool upload() = 0;
	/// The textures show a plant, or a skeleton does instead.
	virtual void set_hidden(const PlantPlace &place, bool hidden) = 0;
	/// A plant is drawn so high, as a share of its own height, and moves as `plant` does from now on. It may take
	/// effect at the next wait() only.
	virtual void set_height(const PlantPlace &place, float share, const MotionPlant &plant) = 0;
	/// Whether any plant is drawn in another height than its own.
	virtual bool has_heights() const = 0;
	/// A block of the store that stands.
	virtual PoseTexels texels(int block) const = 0;
	/// Bends before and after, and a blend for each row of texels. Invalid until something was uploaded.
	virtual godot::RID pose_texture() const = 0;
	virtual godot::RID blend_texture() const = 0;
	/// Steps a second, and the layers of rests, of second modes and of heights, or -1, for each row of texels.
	virtual godot::RID beat_texture() const = 0;
	/// What is drawn in this frame by the clock of swings: 0 to 1, a share of SWING_PERIOD.
	virtual float swing_clock() const = 0;
	/// Where the shader finds the history of a species' prototypes: first layer, newest slot, blend; x is -1 where
	/// plants swing by themselves.
	virtual godot::Vector4 history_of(int species) const = 0;
	virtual bool follows_prototypes() const = 0;
	virtual Delays follower_delays(const godot::Transform3D &axes) const = 0;

	virtual MotionState read_state_now(const PlantPlace &place) = 0;
	/// Where its tip is (m), in the field's axes.
	virtual glm::vec3 read_tip_now(const PlantPlace &place) = 0;
	/// The bend that is drawn in this frame and all else that a plant's parts go by, in the field's axes.
	virtual StemMotion read_drawn_stem_now(const PlantPlace &place) const = 0;
	virtual bool is_point_in_plants_now(const glm::vec3 &point, float margin) = 0;
	virtual void write_state(const PlantPlace &place, const MotionState &state) = 0;
	virtual void apply_impulse(const PlantPlace &place, const glm::vec3 &impulse) = 0;

	virtual int simulated_count() const = 0;
	virtual double bytes_per_plant() const = 0;
	virtual double busy_usec() const = 0;

	GroupBodies bodies;
	/// Bodies that came among plants, or left them, since it was asked last.
	std::vector<GroupBodies::Event> take_events() { return std::exchange(events, {}); }

protected:
	std::vector<GroupBodies::Event> events;
};

} // namespace undergrowth
