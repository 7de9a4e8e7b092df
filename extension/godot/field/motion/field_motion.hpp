#pragma once

#include "bodies/group_bodies.hpp"
#include "field/field_settings.hpp"
#include "field/resources/field_options.hpp"
#include "field/view/field_render_setup.hpp"
#include "motion/joint.hpp"
#include "motion/part_bend.hpp"
#include "placement/plant_matches.hpp"
#include "placement/plant_store.hpp"
#include "wind/field_wind.hpp"

#include <godot_cpp/variant/rid.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace undergrowth {

/// Location of a chunk's poses for the shader: plant `slot` has texel first + slot of a layer.
struct PoseTexels {
	int layer = -1;
	int first = 0;
};

/// A motion's data for a field that is being built on a worker thread. FieldMotion::adopt() uses it.
class PreparedMotion {
public:
	virtual ~PreparedMotion() = default;
	/// Texels of chunk i of the list that it was prepared for.
	virtual PoseTexels texels(int chunk) const = 0;
	/// Adds all plants of this list, at rest. Call it once, on any thread. Another thread may make the setup's
	/// materials and meshes at the same time.
	virtual void build(const std::vector<PlantChunk> &chunks, const FieldRenderSetup &setup) = 0;
	/// True if it needs more texture layers than graphics cards have.
	virtual bool is_too_large() const = 0;
};

/// A motion's data for a new chunk of an existing field, made on a worker thread. FieldMotion::apply() uses it.
class PreparedChunk {
public:
	virtual ~PreparedChunk() = default;
};

/// New chunks of an existing field.
struct ArrivingChunks {
	std::vector<std::unique_ptr<PreparedChunk>> prepared; ///< In the order of the edit's `stood`.
	/// Plants that continue their motion, from chunks that the same edit drops.
	std::vector<PlantMatch> matches;
	/// Multimeshes of dropped plants remain. Their texels then draw nothing and are not reused.
	bool leaves_texels = false;
};

/// The interface of a field's motion and of its textures for the graphics card. CpuMotion implements it with the core's
/// simulation on worker threads; another implementation may use the graphics card. No other class uses pages, steps or
/// threads.
///
/// A motion follows the PlantStore by change sets; chunk numbers are the store's. A method with a name that begins with
/// `blocking_` waits until the state is valid.
class FieldMotion {
public:
	/// Inputs of a frame.
	struct Frame {
		double delta = 0.0; ///< s.
		godot::Transform3D axes; ///< From the field's to the world's, invertible.
		godot::Ref<PlantWind> wind; ///< Null: still air.
		std::vector<godot::Vector3> cameras; ///< World axes: the cameras.
		godot::SceneTree *tree = nullptr;
		uint64_t world = 0; ///< Instance id of the field's World3D.
	};
	/// Delays of plants that follow prototypes, for the shader: steps per metre of world x, y and z, and steps at the
	/// world's origin.
	struct Delays {
		godot::Vector4 after, before;
		float share = 1.0f; ///< Weight of `after` during a change from `before` to it.
	};
	/// Allocates the data for chunks of a setup, for PreparedMotion::build() and then adopt(), under a wind at its
	/// start. On any thread.
	using Prepare = std::unique_ptr<PreparedMotion> (*)(const std::vector<PlantChunk> &chunks,
			const FieldRenderSetup &setup, const FieldSettings &settings, const FieldWind &wind);

	FieldMotion() = default;
	virtual ~FieldMotion() = default;
	FieldMotion(const FieldMotion &) = delete;
	FieldMotion &operator=(const FieldMotion &) = delete;

	virtual Prepare prepare() const = 0;
	/// Prepares a chunk of a setup for apply(). On any thread.
	using PrepareChunk = std::unique_ptr<PreparedChunk> (*)(
			const PlantChunk &chunk, const FieldRenderSetup &setup, const FieldSettings &settings);
	virtual PrepareChunk prepare_chunk() const = 0;
	/// Waits until no other thread works on it, including a transfer of motion.
	virtual void wait() = 0;
	virtual bool is_ready() const = 0;
	/// True if the next advance() uses Frame::cameras. Most do not.
	virtual bool needs_cameras() const = 0;
	/// Starts an empty field, for plants that code adds.
	virtual void start(const FieldSettings &settings) = 0;
	/// Begins to transfer motion from existing plants to `prepared` on another thread, for adopt(). Nothing steps until
	/// then. Both arguments must remain valid until cancel_transfer() or adopt().
	virtual void begin_transfer(PreparedMotion &prepared, const std::vector<PlantMatch> &matches) = 0;
	virtual bool is_transferring() const = 0;
	/// Cancels the transfer: there is no adopt().
	virtual void cancel_transfer() = 0;
	/// Uses the data of a build: chunk i of `prepared` is chunk changes.grown[i] of the store. Plants that existed
	/// before continue their motion.
	virtual void adopt(PreparedMotion &prepared, const std::vector<PlantMatch> &matches, const ChangeSet &changes,
			const PlantStore &store, const FieldRenderSetup &setup) = 0;
	/// Follows an edit that does not replace all generated plants. Removed plants may be visible until the next wait().
	/// With `arriving` only its chunks grew; null: no chunk is prepared.
	virtual void apply(const ChangeSet &changes, const PlantStore &store, const FieldRenderSetup &setup,
			ArrivingChunks *arriving) = 0;
	/// Reserves the texels of a prepared chunk until apply() or release_texels(). Call it between two steps.
	virtual PoseTexels reserve(PreparedChunk &prepared) = 0;
	virtual void release_texels(PreparedChunk &prepared) = 0;
	/// Adds texture layers for about `plants` plants in `chunks` chunks that come later. Without it the textures are
	/// made again several times while the field grows.
	virtual void make_room(double plants, int chunks) = 0;
	virtual void add_species(const SpeciesStyle &style) = 0;
	/// True if the textures have layers for another species. Call it only if is_ready().
	virtual bool has_room_for_species() = 0;
	/// Changes the constants of a species without interrupting the motion. If nothing moves (`is_still`), plants at
	/// rest change to a new rest direction at once.
	virtual void set_species(int index, const SpeciesStyle &style, const PlantStore &store, bool is_still) = 0;
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
	virtual void set_hidden(const PlantRef &ref, bool hidden) = 0;
	/// Sets the drawn height of a plant, as a fraction of its full height. It moves as `plant` from now on. This may
	/// take effect only at the next wait().
	virtual void set_height(const PlantRef &ref, float share, const MotionPlant &plant) = 0;
	/// True if any plant has less than its full height.
	virtual bool has_heights() const = 0;
	/// Texels of an existing chunk of the store.
	virtual PoseTexels texels(int chunk) const = 0;
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

	virtual MotionState blocking_read_state(const PlantRef &ref) = 0;
	/// Position of its tip (m, field axes).
	virtual glm::vec3 blocking_read_tip(const PlantRef &ref) = 0;
	/// The bend that is drawn in this frame and the remaining values that move a plant's parts, in the field's axes.
	virtual StemMotion blocking_read_drawn_stem(const PlantRef &ref) const = 0;
	virtual bool blocking_is_point_in_plants(const glm::vec3 &point, float margin) = 0;
	virtual void write_state(const PlantRef &ref, const MotionState &state) = 0;
	virtual void apply_impulse(const PlantRef &ref, const glm::vec3 &impulse) = 0;

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
