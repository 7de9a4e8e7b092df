#pragma once

#include "base/worker_task.hpp"
#include "bodies/group_bodies.hpp"
#include "field/contact.hpp"
#include "field/field_settings.hpp"
#include "field/mean_lean.hpp"
#include "field/motion/field_drift.hpp"
#include "field/motion/field_steps.hpp"
#include "field/motion/prepared_motion.hpp"
#include "field/resources/field_options.hpp"
#include "motion/fixed_step.hpp"
#include "motion/part_air.hpp"
#include "motion/part_bend.hpp"
#include "motion/swing_clock.hpp"
#include "placement/plant_store.hpp"
#include "plants/frame_steps.hpp"
#include "wind/plant_wind.hpp"

#include <godot_cpp/variant/rid.hpp>

#include <array>
#include <memory>
#include <utility>
#include <vector>

namespace undergrowth {

/// The motion of a field by the core's simulation, and its textures for the graphics card. The engine's worker threads
/// step it between two frames. No other class uses pages, steps or threads. It follows the PlantStore by change sets;
/// chunk numbers are the store's. A method that uses data of the workers waits for them; a query with a name that
/// begins with `blocking_` waits until the state is valid. Main thread.
class FieldMotion {
public:
	/// Inputs of a frame.
	struct Frame {
		double delta = 0.0; ///< s.
		FrameSteps steps;
		godot::Transform3D axes; ///< From the field's to the world's, invertible.
		godot::Ref<PlantWind> wind; ///< Null: still air.
		std::vector<godot::Vector3> cameras; ///< World axes: the cameras.
		uint64_t world = 0; ///< Instance id of the field's World3D.
	};
	/// Delays of plants that follow prototypes, for the shader: steps per metre of world x, y and z, and steps at the
	/// world's origin.
	struct Delays {
		godot::Vector4 after, before;
		float share = 1.0f; ///< Weight of `after` during a change from `before` to it.
	};

	FieldMotion();
	~FieldMotion();
	FieldMotion(const FieldMotion &) = delete;
	FieldMotion &operator=(const FieldMotion &) = delete;

	/// Waits until no other thread works on it, including a transfer of motion.
	void wait();
	bool is_ready() const { return simulation != nullptr; }
	/// True if the next advance() uses Frame::cameras. Most do not.
	bool needs_cameras() const;
	/// Starts an empty field, for plants that code adds.
	void start(const FieldSettings &settings);
	/// Begins to transfer motion from existing plants to `prepared` on another thread, for adopt(). Nothing steps until
	/// then. Both arguments must remain valid until cancel_transfer() or adopt().
	void begin_transfer(PreparedMotion &prepared, const std::vector<PlantMatch> &matches);
	bool is_transferring() const { return transfer.is_running(); }
	/// Cancels the transfer: there is no adopt().
	void cancel_transfer();
	/// Uses the data of a build: chunk i of `prepared` is chunk changes.grown[i] of the store. Plants that existed
	/// before continue their motion. Returns the old simulation, which any thread can free.
	std::unique_ptr<FieldSimulation> adopt(PreparedMotion &prepared, const std::vector<PlantMatch> &matches,
			const ChangeSet &changes, const PlantStore &store, const FieldRenderSetup &setup);
	/// Follows an edit that does not replace all generated plants. Removed plants may be visible until the next wait().
	/// With `arriving` only its chunks grew; null: no chunk is prepared.
	void apply(
			const ChangeSet &changes, const PlantStore &store, const FieldRenderSetup &setup, ArrivingChunks *arriving);
	/// Reserves the texels of a prepared chunk until apply() or release_texels(). Call it between two steps.
	PoseTexels reserve(PreparedChunk &prepared);
	void release_texels(PreparedChunk &prepared);
	/// Adds texture layers for about `plants` plants in `chunks` chunks that come later. Without it the textures are
	/// made again several times while the field grows.
	void make_room(double plants, int chunks);
	void add_species(const SpeciesStyle &style);
	/// True if the textures have layers for another species. Call it only if is_ready().
	bool has_room_for_species();
	/// Changes the constants of a species without interrupting the motion. If nothing moves (`is_still`), plants at
	/// rest change to a new rest direction at once.
	void set_species(int index, const SpeciesStyle &style, const PlantStore &store, bool is_still);
	void set_update_interval(int steps);
	/// Switches contact on or off. Call it again after tips changed their spheres.
	void fit_contact(bool on);
	/// True if too many tips touch, so that some pairs are left out.
	bool is_crowded() const { return touches && touching.is_crowded(); }

	/// Runs the steps of a frame. The last step continues on other threads and is shown in the next frame. Returns the
	/// µs of this thread that steps took; steps of small fields run on this thread.
	double advance(const Frame &frame, const MotionOptions &options);
	/// Runs steps for a tool, at the wind's own clock and without bodies, and returns when they are done.
	void preview(Frame frame, const MotionOptions &options);
	/// s of the wind's clock, of the states of plants.
	double motion_time() const { return time_after_step; }
	/// Sets all plants to rest.
	void settle();

	/// Uploads changes to the textures. Returns true if the textures are new ones, or have heights for the first time.
	bool upload();
	/// Hides a plant in the textures, for example while a skeleton shows it, or shows it again.
	void set_hidden(const PlantRef &ref, bool hidden);
	/// Sets the drawn height of a plant, as a fraction of its full height. It moves as `plant` from now on. This may
	/// take effect only at the next wait().
	void set_height(const PlantRef &ref, float share, const MotionPlant &plant);
	/// True if any plant has less than its full height.
	bool has_heights() const { return textures && textures->has_heights(); }
	/// Texels of an existing chunk of the store.
	PoseTexels texels(int chunk) const { return textures->texels(rows_of(chunk)); }
	/// Bends before and after, and a blend for each row of texels. Invalid before the first upload().
	godot::RID pose_texture() const { return textures ? textures->poses() : godot::RID(); }
	godot::RID blend_texture() const { return textures ? textures->blends() : godot::RID(); }
	/// For each row of texels: steps per second, and the layers of rests, of second modes and of heights, or -1.
	godot::RID beat_texture() const { return textures ? textures->beats() : godot::RID(); }
	/// Drawn time of the swing clock: 0 to 1, a fraction of SWING_PERIOD.
	float swing_clock() const { return swings.now(shown_alpha); }
	/// What makes parts of a species flutter: speed of the air, speed of sources (m/s), turns and drops, as in
	/// StemMotion.
	glm::vec4 part_air(int species) const;
	/// Water and snow on plants.
	Precipitation precipitation() const { return simulation ? simulation->wind().precipitation : Precipitation(); }
	/// Position of the drawn frame in the steps of the motion.
	double shown_steps() const { return shown_at; }
	/// Length of a step (s).
	float step_length() const { return simulation ? simulation->settings().step : 0.0f; }
	/// Mean lean of a species' plants over the last seconds: displacement of their tips from calm air, in heights.
	float mean_lean(int species) const { return leans.of(species); }
	/// History of a species' prototypes for the shader: first layer, newest slot, blend. x is -1 if each plant is
	/// simulated.
	godot::Vector4 history_of(int species) const;
	bool follows_prototypes() const { return textures && textures->follows(); }
	Delays follower_delays(const godot::Transform3D &axes) const;

	MotionState blocking_read_state(const PlantRef &ref);
	/// Position of its tip (m, field axes).
	glm::vec3 blocking_read_tip(const PlantRef &ref);
	/// The bend that is drawn in this frame and the remaining values that move a plant's parts, in the field's axes.
	StemMotion blocking_read_drawn_stem(const PlantRef &ref) const;
	/// What grows around a plant that does not belong to the field (CanopyGrid::around()). Does not wait.
	PlantCanopy canopy_around(const glm::vec3 &place, float height, int species) const {
		return simulation ? simulation->canopy_around(place, height, species) : PlantCanopy();
	}
	/// As FieldSimulation::air_around(), as a vector of the field's axes; 0 before the field is built.
	godot::Vector3 blocking_air_around(const godot::Vector3 &root, float height);
	bool blocking_is_point_in_plants(const glm::vec3 &point, float margin);
	void write_state(const PlantRef &ref, const MotionState &state);
	/// Lasting bends of a chunk's plants, by slot. Empty if it has none.
	std::vector<glm::vec2> blocking_read_lasting_bends(int chunk);
	void set_lasting_bend(const PlantRef &ref, const glm::vec2 &bend);
	void forget_lasting_bends();
	/// Lets the bend of a plant last whose tip points along `direction` (unit, field axes); upright: none. Returns
	/// false for laws without lasting bends and for followers.
	bool trample(const PlantRef &ref, const glm::vec3 &direction);
	void apply_impulse(const PlantRef &ref, const glm::vec3 &impulse);

	/// Number of plants of `store` that are stepped. Does not wait. With prototypes, that of the last step that ended.
	int simulated_count(const PlantStore &store) const;
	/// Memory of plants and their motion, divided by the plants. Waits and counts only if plants came or left since the
	/// last call.
	double bytes_per_plant(const PlantStore &store);
	/// Does not wait.
	double busy_usec() const { return steps.busy_usec(); }

	GroupBodies bodies;
	/// Returns the bodies that entered or left plants since the last call.
	std::vector<GroupBodies::Event> take_events() { return std::exchange(events, {}); }

private:
	std::vector<GroupBodies::Event> events;
	std::unique_ptr<FieldSimulation> simulation;
	std::unique_ptr<PoseTexture> textures;
	std::vector<PageRows> rows; ///< By chunk.
	std::vector<PlantRef> pending_removals; ///< Removed plants that the simulation still contains.
	struct Height {
		PlantRef ref;
		float share;
		MotionPlant plant;
	};
	std::vector<Height> heights; ///< Changed heights that are not in the simulation yet.
	/// Pages with plants that are shown again or follow other prototypes, not written yet.
	std::vector<int> dirty_pages;
	TipContact touching;
	bool touches = false;
	MeanLean leans;
	int simulated_before = 0; ///< With prototypes: plants that are stepped, before the running step.
	std::array<int64_t, 4> counted = {}; ///< What `counted_bytes` depends on.
	double counted_bytes = 0.0; ///< Per plant.
	double time_after_step = 0.0; ///< s of the wind's clock, at the end of the last step that was started.
	FieldSteps steps; // Declared after the data that it uses, so it is destroyed first.
	WorkerTask transfer; // For the same reason.
	bool is_transferred = false; ///< The motion of matched plants is transferred for adopt(), and nothing moved since.
	FixedStep preview_clock;
	FieldDrift drift;
	std::vector<AirSource> stirring; ///< In the present step.
	bool showed_heights = false; ///< At the last upload().
	float shown_alpha = 0.0f; ///< Of the next frame to draw.
	double shown_at = 0.0; ///< In steps: what upload() passed to the textures.
	SwingClock swings;
	std::vector<PartAir> airs; ///< By species.
	std::vector<float> air_speeds; ///< m/s: last readings, by species.
	unsigned air_step = 0;
	float stirred = 0.0f; ///< m/s.
	int frames_since_far = 0;
	std::vector<glm::vec3> pushed_at; ///< m, field axes: bodies of the last step.

	const PageRows &rows_of(int chunk) const { return rows[size_t(chunk)]; }
	int row_of(const PlantRef &ref) const { return rows_of(ref.chunk).first + ref.slot; }
	void begin_clock();
	void follow_air(double step);
	void write_all();
	int modes_of_prototypes(int species) const; ///< 0: it has none.
	void grow(const ChangeSet::Grown &grown, const PlantStore &store, const FieldRenderSetup &setup);
	void take_in(int chunk, PreparedChunk &prepared);
	void drop(int page, int row);
	void exchange_chunks(const ChangeSet &changes, ArrivingChunks &arriving);
	void drop_rows(const PageRows &own, bool leaves_texels);
	void take_added(const PlantStore &store, const FieldRenderSetup &setup, const FieldSimulation *old,
			const std::vector<PageRows> &old_rows);
	void set_rests(const PageRows &plants, const std::vector<glm::vec3> &rests, bool is_still);
	void update_far(const Frame &frame, const MotionOptions &options);
	void push(double ago);
	void stir(const Frame &frame, const MotionOptions &options, double ago);
	void find_events(double margin);
	void follow_wind(const Frame &frame, int index);
	void start_step(const Frame &frame, const MotionOptions &options, bool with_contact);
};

} // namespace undergrowth
