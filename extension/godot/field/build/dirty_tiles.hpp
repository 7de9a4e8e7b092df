#pragma once

#include "base/piece_cost.hpp"
#include "base/stopwatch.hpp"
#include "field/build/ground_sampler.hpp"
#include "field/build/tile_build_task.hpp"
#include "field/view/field_view.hpp"
#include "placement/tile_queue.hpp"

#include <godot_cpp/classes/geometry_instance3d.hpp>

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace undergrowth {

/// The tiles of a field that differ from its properties, and the tasks that build them, nearest to the cameras first.
/// A tile is dirty as a whole, if it is missing or its placement changed, or in a part, after painting. A whole tile is
/// replaced in one frame, when all of it is ready to be drawn. It also loads and unloads the tiles of a field with a
/// view distance. Main thread.
class DirtyTiles {
public:
	/// For more tiles with dirty parts than this, building all of them as a whole is faster.
	static constexpr size_t MAX_PARTS = 64;

	/// Inputs of one call, and the functions that receive results.
	struct Scene {
		godot::GeometryInstance3D *field;
		const FieldProperties &properties;
		const PlantStore &store;
		const FieldRenderSetup &setup;
		FieldMotion &motion;
		const FieldGround &ground;
		const EditLog &edits;
		FieldSettings settings;
		FieldView &view;
		std::function<ChangeSet(StoreEdit &&, ArrivingChunks *)> apply;
		std::function<void(const godot::String &)> fault;
		double budget_usec; ///< Of the main thread for building, per frame.

		bool streams() const { return properties.view_distance > 0.0; }
	};

	/// The time of a call of resume_parts().
	enum class Moment {
		physics, ///< In a physics frame: rays may be cast at the ground.
		begun, ///< In a frame, while plants do not move: new plants may be added to the store.
		ending, ///< During the next step, for which nothing may wait.
	};

	/// Positions of all cameras and streaming targets (m, field axes).
	static std::vector<glm::vec2> places_of(const Scene &scene);
	/// Returns the tiles around the cameras and streaming targets, nearest first. Without any of these, it returns the
	/// existing tiles if their size is unchanged.
	std::vector<TileKey> choose_all(const Scene &scene, const PlacementRequest &request) const;
	/// Returns all tiles of a field that does not stream and has none yet, nearest first. Returns none if they are too
	/// many or too empty to be built one by one.
	static std::vector<TileKey> list_first(const Scene &scene, const PlacementRequest &request);
	/// Returns the tiles to build again from a request: all existing ones, and all new ones. Returns none if the tiles
	/// are too many or too empty, or the plants are too many. It also returns none if two plants would have the same
	/// id.
	std::vector<TileKey> list_again(const Scene &scene, const PlacementRequest &request) const;

	/// Sets the tiles that exist in a field that streams. Later tiles are built from this request. Cancels everything.
	void set_existing(const Scene &scene, const std::vector<TileKey> &tiles, const PlacementRequest &request);
	/// Starts to build these tiles from a request.
	void begin_build(const Scene &scene, const std::vector<TileKey> &tiles, const PlacementRequest &request);
	/// Call after set_existing(): its tiles are the first part of a build, and the next choice adds the rest.
	void begin_streamed_build() { has_build_to_choose = true; }
	/// True if tiles of a build are missing. Tiles that a moving camera needs later do not count.
	bool is_building() const { return has_build_to_choose || !due.empty(); }
	/// True if tiles of begin_build() are missing.
	bool is_building_list() const { return is_list && !due.empty(); }
	/// Progress of the build, 0 to 1.
	float progress() const;
	/// The ground queries of all whole tiles.
	GroundQueryQueue &query_queue() { return ground_queue; }
	/// Waits for all worker tasks. The tasks themselves remain.
	void wait_for_tasks();
	int existing_count() const { return int(existing.size()); }
	/// Number of whole tiles to build.
	int waiting_count() const;

	/// Continues with whole tiles in a physics frame or another frame: chooses, removes and builds them. One call uses
	/// a part of a millisecond, and the next one continues its work. Returns true if plants were added.
	bool resume(const Scene &scene, bool physics);
	/// Cancels all whole tiles in progress. They start again later. Call it after a change of styles or motion.
	void interrupt(const Scene &scene);
	/// Cancels all whole tiles of begin_build(). Existing plants stay.
	void stop_list(const Scene &scene);

	/// Marks a box (m, field axes) to be placed again, in tiles of `tile_size`.
	void touch(const Scene &scene, const AreaBox &changed, float tile_size);
	/// Cancels all parts in progress. They start again later.
	void interrupt_parts();
	/// Call if all tiles are placed again.
	void forget_parts() { parts.clear(); }
	/// Call if all multimeshes are made again.
	void forget_undrawn() { undrawn.clear(); }
	bool is_building_parts() const;
	size_t part_count() const { return parts.size(); }
	/// Continues with parts as far as possible: shows what is ready, and begins what is next. Only at the end of a
	/// frame it waits a part of a millisecond for plans. Ground queries take about `ground_usec`. Returns true if plants
	/// were added or removed.
	bool resume_parts(const Scene &scene, Moment moment, double ground_usec);

	/// Call after each edit of the store. Updates the chunks to draw, and restarts parts that used old plants.
	void follow(const ChangeSet &changes, const PlantStore &store);
	/// Call before plants are removed from this tile.
	void note_removed(const TileKey &tile);

private:
	/// A tile in progress.
	struct Job {
		std::unique_ptr<TileBuildTask> task;
		bool is_planned = false;
		bool lost_some = false; ///< Plants were removed meanwhile.

		bool is_part() const { return task->part().has_value(); }
	};

	/// The pieces of one call of resume(). The first one always begins, so that each call makes progress.
	struct Pace {
		Stopwatch watch;
		double budget_usec;
		bool has_begun = false;

		/// True if a piece of about `usec` may begin.
		bool allows(double usec) {
			const bool allowed = !has_begun || watch.usec() + usec < budget_usec;
			has_begun = has_begun || allowed;
			return allowed;
		}
	};

	TileQueue queue; ///< Whole tiles.
	std::map<TileKey, AreaBox> parts;
	std::vector<Job> jobs; ///< At most one per tile.
	std::unique_ptr<TileBuildTask> drawing; ///< Of chunks of new plants.
	std::set<int> undrawn; ///< Chunks of new plants.
	std::set<int> dropped; ///< Chunks dropped since `drawing` began.
	std::set<TileKey> existing; ///< Of a field that streams.
	std::vector<TileKey> to_remove; ///< Farthest last.
	std::set<TileKey> due; ///< Unfinished tiles of a build.
	size_t due_at_first = 0;
	bool is_list = false; ///< `due` is from begin_build().
	bool has_build_to_choose = false; ///< `due` is unknown until the next choice.
	PlacementRequest base; ///< For all tiles, without its map.
	double spacing = 1.0; ///< m, of `base`.
	AreaBox area;
	float size = 16.0f; ///< m, of a tile.
	std::shared_ptr<const FieldRenderSetup> outline;
	GroundQueryQueue ground_queue, part_ground_queue;
	const TileBuildTask *querying = nullptr; ///< In `ground_queue`.
	const TileBuildTask *querying_part = nullptr;
	int frames_since_choice = 0;
	PieceCost exchanging; ///< By the plants that arrive.

	const std::shared_ptr<const FieldRenderSetup> &need_outline(const Scene &scene);
	void set_base(const PlacementRequest &request);
	void end_build(const Scene &scene);
	void choose(const Scene &scene);
	void choose_due();
	void leave(const Scene &scene, const TileKey &tile);
	Job *job_of(const TileKey &tile);
	/// Cancels a whole tile. `again`: it starts again later.
	void cancel(const Scene &scene, Job &job, bool again);
	/// Removes a job from the list.
	Job take_job(size_t number);
	bool may_begin(bool is_part) const;
	/// Sets the input of a whole tile. Returns false if that fails; the build of the whole field reports the fault.
	bool describe(const Scene &scene, TileBuildInput &input) const;
	/// Returns false if no whole tile may begin.
	bool begin(const Scene &scene);
	/// Returns the first task, of parts or of whole tiles, that needs ground, or null.
	Job *find_job_for_ground(bool is_part);
	void poll_ground(const Scene &scene, bool physics);
	/// Returns true if a whole tile may be exchanged.
	bool resume(const Scene &scene, Job &job, Pace &pace);
	void exchange(const Scene &scene, Job &&job);
	void remove_gone(const Scene &scene, const ChangeSet &changes);

	void add_part(const TileKey &tile, const AreaBox &box);
	void begin_parts(const Scene &scene);
	void begin_part(const Scene &scene, const TileKey &tile, const AreaBox &box, size_t &copied_count);
	void poll_part_ground(const Scene &scene, bool physics, double usec);
	bool apply_parts(const Scene &scene);
	void draw_parts(const Scene &scene);
	void show_parts(const Scene &scene);
};

} // namespace undergrowth
