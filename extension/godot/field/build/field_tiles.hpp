#pragma once

#include "field/build/ground_sampler.hpp"
#include "field/build/tile_build.hpp"
#include "base/stopwatch.hpp"

#include <functional>
#include <memory>
#include <set>
#include <vector>

namespace undergrowth {

/// The existing tiles of a field with a view distance, and the jobs that build new ones, nearest first. Main thread.
class FieldTiles {
public:
	/// Inputs of one call, and the functions that receive results.
	struct Scene {
		godot::Node3D *field;
		const FieldProperties &properties;
		const PlantStore &store;
		const FieldRenderSetup &setup;
		const FieldMotion &motion;
		const FieldGround &ground;
		const EditLog &edits;
		FieldSettings settings;
		FieldView &view;
		std::function<ChangeSet(StoreEdit &&, ArrivingChunks *)> apply;
		std::function<void(const godot::String &)> fault;
		double budget_usec; ///< Of the main thread for building, per frame.
	};

	/// Returns the tiles for the start of a build: those around the cameras and streaming targets. Without any of
	/// these, it returns the existing tiles if their size is unchanged.
	std::vector<TileKey> choose_all(const Scene &scene, const PlacementRequest &request) const;
	/// Sets the existing tiles. Later tiles are built from this request.
	void set_existing(const std::vector<TileKey> &tiles, const PlacementRequest &request);
	/// Call after set_existing(): its tiles are the first part of a build, and the next choice adds the rest.
	void begin_build();
	/// True if tiles of that build are missing. Tiles that a moving camera needs later do not count.
	bool is_building() const { return has_build_to_choose || !due.empty(); }
	void end_build();
	/// Progress of the build since begin_build(), 0 to 1.
	float build_progress() const;
	/// The ground queries of all tiles.
	GroundQueryQueue &query_queue() { return ground_queue; }
	/// Waits for all worker jobs. The jobs themselves remain.
	void wait_for_jobs();
	/// Clears the lists of tiles and jobs. The plants stay in the store.
	void clear();
	bool contains(const TileKey &tile) const { return existing.count(tile) > 0; }
	int existing_count() const { return int(existing.size()); }
	/// Number of tiles to build.
	int waiting_count() const { return int(jobs.size() + to_build.size()); }

	/// Positions of all cameras and streaming targets (m, field axes).
	static std::vector<glm::vec2> places_of(const Scene &scene);
	/// Sets all of a tile's input except spacing and setup, from a request without its map. Returns false if that
	/// fails; the build of the whole field reports the fault.
	static bool describe(const Scene &scene, const PlacementRequest &base, TileBuildInput &input);

	/// Continues in a physics frame or another frame: chooses tiles from time to time, removes and builds them.
	/// `edits`: the store may be edited. One call uses a part of a millisecond, and the next one continues its work.
	/// Returns true if plants were added.
	bool resume(const Scene &scene, bool physics, bool edits);
	/// Cancels all unfinished tiles, removes their plants, and starts them again later.
	void interrupt(const Scene &scene);
	/// The same for tiles that meet a box (m, field axes).
	void interrupt(const Scene &scene, const AreaBox &box);
	/// Call after a change of styles or motion.
	void forget_style() { outline.reset(); }

private:
	std::set<TileKey> existing; ///< Including those that jobs build.
	std::vector<TileKey> to_build; ///< To build, nearest last.
	std::vector<TileKey> to_remove; ///< To remove, farthest last.
	std::vector<std::unique_ptr<TileBuild>> jobs;
	std::set<TileKey> due; ///< Unfinished tiles of a build.
	size_t due_at_first = 0;
	bool has_build_to_choose = false; ///< `due` is unknown until the next choice.
	PlacementRequest base; ///< For all tiles, without its map.
	AreaBox area;
	std::shared_ptr<const FieldRenderSetup> outline;
	GroundQueryQueue ground_queue;
	const TileBuild *querying = nullptr;
	int frames_since_choice = 0;

	void choose(const Scene &scene);
	void choose_due();
	void leave(const Scene &scene, const TileKey &tile);
	bool begin(const Scene &scene);
	void poll_ground(const Scene &scene, bool physics);
	/// Returns true if the job is done.
	bool resume(const Scene &scene, TileBuild &job, bool edits, double until_usec, const Stopwatch &watch);
};

} // namespace undergrowth
