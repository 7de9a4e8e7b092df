#pragma once

#include "base/frame_cost.hpp"
#include "base/stopwatch.hpp"
#include "base/worker_task.hpp"
#include "field/build/build_input.hpp"
#include "field/build/dirty_tiles.hpp"
#include "field/build/ground_sampler.hpp"
#include "field/build/habitat_surveyor.hpp"
#include "field/build/species_sampler.hpp"
#include "field/field_edits.hpp"
#include "field/field_trampling.hpp"
#include "field/motion/field_motion.hpp"
#include "field/view/field_materials.hpp"
#include "field/view/listed_styles.hpp"
#include "field/view/skeleton_view.hpp"
#include "placement/placed_area.hpp"

#include <godot_cpp/classes/geometry_instance3d.hpp>

#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace undergrowth {

/// The parts of a PlantField3D, and the way of an edit through them. PlantStore contains the plants, FieldMotion moves
/// them, and FieldView and SkeletonView draw them. Each part owns its state, and a ChangeSet updates the other parts.
/// FieldBuild builds on a worker thread, and its result is applied between two frames. Main thread.
class FieldRuntime {
public:
	/// Callbacks of the node.
	struct Listener {
		std::function<void(const godot::String &)> fault; ///< Empty: there is no fault now.
		std::function<void(const godot::String &)> failed; ///< A build failed, with the reason.
		/// Advice on what to check. Empty: ground was found, or none is queried.
		std::function<void(const godot::String &)> no_ground;
		std::function<void(float)> progressed; ///< 0 to 1.
		std::function<void()> finished;
		SkeletonView::Callback skeleton;
	};

	FieldRuntime(godot::GeometryInstance3D *node, const FieldProperties &set_by_users, Listener &&callbacks);
	~FieldRuntime();

	/// Builds the field again: placement, styles and motion (`places`), or only styles and motion. If styles do not
	/// change (not `styles`), a build with new places works tile by tile.
	void rebuild(bool places, bool styles = true);
	/// The phases of a build. A build that places plants has the phases sampling and placing. If it is large, tiles
	/// follow, and then joining, if the field does not stream. Parts of tiles are built in the phases idle and tiles.
	enum class Phase {
		idle,
		sampling, ///< Species are read.
		styling, ///< Meshes, materials and motion of existing plants are rebuilt.
		placing, ///< A part or all of the field is placed.
		tiles, ///< Tiles are built one by one.
		joining, ///< Pages and multimeshes of those tiles are joined.
	};
	Phase phase() const;
	/// True if a build is in progress that replaces the whole field at once.
	bool is_at_work() const { return sampler || job; }
	/// True if it places plants, refines drafts, builds tiles, or joins tiles that were placed one by one.
	bool is_building() const { return is_placing() || drafted || tiles.is_building(); }
	/// Builds everything that is missing before it returns. Returns false if that is not possible.
	bool build_now();
	/// True if it streams, and the tile size of the properties is not that of the store.
	bool needs_other_tiles() const { return streams() && float(properties.tile_size) != store.tile_size(); }
	/// Repeats an edit of the plants in a box (m, field axes) for plants that the first build adds later.
	void repeat_in_first_build(const AreaBox &box, std::function<void()> &&edit);
	void forget_repeated_edits() { repeated.clear(); }
	/// Call after painting in a box (m, field axes). A worker places plants there again, and all other plants stay
	/// unchanged. Builds the whole field if it has no levels yet or too many tiles changed.
	void touch(const AreaBox &box);
	bool is_building_parts() const { return tiles.is_building_parts(); }
	/// Call after a change of the outline or of an exclusion. Builds the area between the old and the new paths again.
	void follow_area();
	/// True if only tiles near the cameras and streaming targets exist.
	bool streams() const { return properties.view_distance > 0.0; }
	/// True if it needs poll() each frame.
	bool needs_frames() const {
		return is_at_work() || is_building() || is_building_parts() || streams() || !retired.empty() ||
				!retired_materials.empty() || reports_parts || holds_free_memory;
	}
	/// True while motion is transferred to a build. This frame must not wait for any part of it.
	bool is_transferring() const { return job && job->handover == FieldBuild::Handover::transferring; }
	/// Continues builds in a frame of `delta` seconds, paused or not. `physics`: this is a physics frame, in which rays
	/// may be cast.
	void poll(double delta, bool physics);

	/// Call between two polls: strokes appear in the frame in which they are ready.
	void follow_strokes(DirtyTiles::Moment moment, double delta);

	/// True if it has plants that can move now.
	bool can_step() const { return motion.is_ready() && store.plant_count() > 0 && !is_transferring(); }
	/// Call once per frame of `delta` seconds that is not paused. Returns the µs of this thread that steps took.
	double advance(double delta, bool simulates);
	void preview(double delta, const godot::Ref<PlantWind> &blowing);
	/// Draws all changes since the last frame.
	void refresh();
	/// Call when the node enters a world or leaves it.
	void note_world();

	/// Call before each frame is drawn, paused or not. Hides plants that are too far from all cameras, and prepares
	/// motion vectors.
	void cull();

	/// Returns the index of the style of a function whose plants code adds, and creates it if needed. Returns -1, with
	/// an error, if it cannot be built.
	int species_for(const godot::Ref<PlantFunction> &function);
	/// Returns the ids of the added plants. With `ids` they are restored under these ids, which must be unused and
	/// ascending.
	std::vector<PlantId> add(std::vector<PlacedPlant> &&plants, std::vector<PlantId> &&ids = {});
	/// Returns the number of plants that are removed.
	int remove(std::vector<PlantRef> &&places);
	/// Sets the height of each plant, as a fraction of its full height.
	void mow(std::vector<PlantRef> &&places, const std::vector<float> &shares);
	/// The list's entry with this function, or null.
	godot::Ref<PlantFieldSpecies> listed_entry(const godot::Ref<PlantFunction> &function) const {
		return undergrowth::listed_entry(properties, function);
	}
	/// The listed species with this name in the map, or null.
	godot::Ref<PlantFunction> listed_species(const godot::String &name) const {
		return undergrowth::listed_species(properties, name);
	}
	/// Edits of plants appear in the next frame, or at once if the node does not process.
	void show_soon();
	/// Removed plants in these boxes (m, field axes) may grow again.
	void grow_again(const std::vector<AreaBox> &boxes);
	void settle();

	/// Call after a change of a species' motion. Its plants stay, and moving plants continue their motion.
	void read_motion(const PlantFunction *function, bool is_still);
	/// Updates the shapes of stems if the kind of wind has changed.
	void update_wind_kind(const godot::Ref<PlantWind> &blowing);
	/// Applies changed distances of levels, or shadows. Returns false if they need other meshes.
	bool update_levels();
	void update_render_flags(const InstanceRenderFlags &flags);
	/// Call after a species' material was replaced.
	void change_materials();
	/// True if the present materials need meshes with or without cards, other than the present meshes.
	bool needs_other_meshes() const;
	/// Copies the parameters of users' materials, of one species per call, in turns.
	void follow_materials() { materials.follow(setup); }
	void skeletons_changed();

	/// Call after a change of the ground, before a rebuild.
	void forget_ground() { surveyor.forget(); }
	void enter_tree();
	void exit_tree();
	void moved();
	void set_visible(bool visible);

	FieldMotion motion;
	PlantStore store;
	FieldRenderSetup setup;
	SkeletonView skeletons;
	FieldEdits own_edits; ///< By code.
	FieldTrampling trampling;
	int64_t seed() const { return properties.seed; }
	DirtyTiles tiles;
	FrameCost build_cost; ///< Time of this thread for builds.
	double tiles_usec = 0.0; ///< Time of this thread for tiles in the last frame.
	double upload_usec = 0.0; ///< Time of this thread in the last refresh().
	double thin_usec = 0.0; ///< Of the last selection of drawn plants.
	/// An upper bound (field axes) of everything that is drawn. It has no volume if there are no plants.
	godot::AABB box() const;
	bool is_listing_shadows() const { return view.is_listing_shadows(); }
	const std::vector<int> &count_drawn(const godot::Vector3 &camera) { return view.count_drawn(setup, camera); }

private:
	godot::GeometryInstance3D *node;
	const FieldProperties &properties;
	Listener listener;
	FieldMaterials materials;
	std::vector<FieldRenderSetup> retired; ///< Used by multimeshes that draw nothing, until all of them are freed.
	std::vector<std::vector<godot::Ref<godot::ShaderMaterial>>> retired_materials; ///< As `retired`.
	FieldView view;
	MotionVectors vectors;
	InstanceRenderFlags flags;
	std::set<TileKey> unseen; ///< Tiles with added or removed plants of code that are not drawn yet.
	bool is_unshown = false; ///< Plants were removed or changed since the last refresh().
	std::unique_ptr<SpeciesSampler> sampler; ///< Runs before the job begins.
	HabitatSurveyor surveyor; ///< Runs after the sampler.
	std::unique_ptr<FieldBuild> job;
	/// A first build whose plants are drafts, until their styles are refined. The rest of the field follows then.
	std::unique_ptr<FieldBuild> drafted;
	bool joins = false; ///< The job joins tiles that were built one by one.
	WorkerTask clearing; ///< Frees the data of the last job.
	bool holds_free_memory = false; ///< A large build has freed memory since return_memory().
	GroundQueryQueue ground_queue;
	bool is_of_tiles = false; ///< The last build was one of tiles.
	/// An edit that the first build repeats.
	struct Repeated {
		AreaBox box; ///< m, field axes.
		std::function<void()> edit;
	};

	std::vector<Repeated> repeated; ///< Until the first build ends.
	std::vector<TileKey> arrived; ///< Tiles with new plants, for which edits are to be repeated.
	bool was_built = false; ///< A build has ended.
	bool has_failed = false; ///< The present or last build failed.
	float built_before = 0.0f; ///< progress() at which the tiles of the first build begin.
	godot::String tile_fault; ///< Reason why a tile or a painted area cannot be built.
	enum class Caller {
		none,
		frame,
		build_now, ///< No budgets.
	};
	Caller caller = Caller::none; ///< Of the poll() in progress.
	Stopwatch poll_watch; ///< Started by it.
	FieldGround ground; ///< As at the last build.
	std::vector<PlantId> removed_meanwhile; ///< While the job runs.
	PlacedArea placed_area;
	bool reports_parts = false; ///< When no part of a tile is dirty any more, a build ends.
	bool is_due_again = false; ///< Its style changed during a build of styles.
	bool has_other_materials = false; ///< Users changed materials after the job made its own.
	float reported_progress = -1.0f;
	godot::AABB seen_box; ///< All plants some frames ago (field axes).
	unsigned frames_since_box = 0;

	uint64_t world = 0; ///< Instance id of the node's World3D; 0: none.
	bool has_felt = false; ///< All styles know the kind of wind `felt_air`.
	bool felt_air = false;

	void refresh(const godot::Transform3D &axes);
	void write_vectors(const std::vector<DrawingCamera> &cameras);
	SeenDistances seen_distances(const godot::Transform3D &axes);

	/// Render settings of skeletons, which are drawn at the first level.
	InstanceRenderFlags near_flags() const;
	void send_stems();
	void show_precipitation(const godot::Ref<PlantWind> &wind);
	FieldMotion::Frame frame(double delta, const godot::Ref<PlantWind> &wind) const;
	FieldSettings settings() const;
	/// Excludes streamed tiles of a first build.
	bool is_placing() const {
		return tiles.is_building_list() || joins || (sampler ? sampler->places : job && job->places());
	}
	bool is_urgent() const { return caller == Caller::build_now; }
	/// µs of this thread for building, per frame.
	double budget_usec() const;
	/// What is left of it in this call of poll().
	double left_usec() const { return budget_usec() - poll_watch.usec(); }
	/// As GroundQueryQueue::usual_usec().
	double ground_usec(double delta) const;
	/// Of the whole build, 0 to 1.
	float progress() const;
	/// Ends a build with an error.
	void fail(const godot::String &fault);
	/// True if a tile or a painted area failed since the last call. `builds`: that is the failure of a build.
	bool report_tile_fault(bool builds);
	void finish_build();
	void split_first_build(BuildInput &input);
	/// True if no build has shown more than drafts.
	bool is_first_build() const;
	/// True if a build may show drafts first.
	bool may_need_drafts() const;
	bool needs_drafts(const BuildInput &input) const;
	void refine(std::unique_ptr<FieldBuild> &&shown);
	/// Continues with what a first build left, after its plants are no drafts.
	void follow(const FieldBuild &finished);
	void begin_rest(const FieldBuild &finished);
	void repeat_edits();
	void wait_for_jobs();
	bool can_query_ground() const;
	/// Reports each value once.
	void report_progress(float progress) {
		if (std::exchange(reported_progress, progress) != progress) {
			listener.progressed(progress);
		}
	}
	bool start_tile_rebuild();
	/// Returns true if the build has the survey of the ground that its habitats need. Else one begins, or a fault is
	/// set.
	bool has_survey(godot::String &fault);
	void join_tiles();
	godot::String begin_sampling(bool places);
	void resume_sampling();
	/// As rebuild(), but plants that were removed meanwhile stay removed.
	void restart_build(bool places);
	void take_existing_plants(BuildInput &input) const;
	godot::String make_build_input(BuildInput &input);
	void poll_parts(DirtyTiles::Moment moment, double delta);
	void drop_job();
	/// Returns false while more has to be prepared.
	bool make_ready();
	void return_memory();
	void poll_all(double delta, bool physics);
	void serve_ground(double delta, bool physics);
	void poll_job(bool physics);
	/// Returns false if the build failed.
	bool adopt(FieldBuild &finished);
	DirtyTiles::Scene tile_scene();
	void poll_tiles(bool physics);
	void finish_tiles();
	ChangeSet apply(StoreEdit &&edit, ArrivingChunks *arriving = nullptr);
};

} // namespace undergrowth
