#pragma once

#include "field/ground_survey.hpp"
#include "field/tile_job.hpp"
#include "stopwatch.hpp"

#include <functional>
#include <memory>
#include <set>
#include <vector>

namespace undergrowth {

/// Which tiles of a field stand that has a view distance, and the jobs for those that come, nearest first. Main thread.
class FieldTiles {
public:
	/// What it needs to know, and whom it tells.
	struct Scene {
		godot::Node3D *field;
		const FieldProperties &properties;
		const PlantStore &store;
		const FieldStyle &style;
		const FieldMotion &motion;
		const FieldGround &ground;
		const StandChanges &changes;
		FieldSettings settings;
		FieldView &view;
		std::function<ChangeSet(StandEdit &&, ArrivingBlocks *)> apply;
		std::function<void(const godot::String &)> fault;
		double budget_usec; ///< Main thread time for building, a frame.
	};

	/// Tiles that a filling is to begin with: those around whoever looks, and those that stand and are not too far.
	std::vector<TileKey> choose_all(const Scene &scene, const PlacementRequest &request) const;
	/// They stand now, and no others; later ones are of this request.
	void stand(const std::vector<TileKey> &tiles, const PlacementRequest &request);
	/// After stand(): these tiles are the first part of a build. The next choice adds the rest.
	void begin_build();
	/// Whether tiles of that build are missing. Tiles that a moving camera needs later do not count.
	bool is_building() const { return has_build_to_choose || !due.empty(); }
	void end_build();
	/// Of begin_build(), 0 to 1.
	float build_progress() const;
	/// The ground queries of all tiles.
	GroundAsker &ground_asker() { return asker; }
	/// Waits for all worker jobs. They stay as they are.
	void wait_for_jobs();
	/// None of them does.
	void clear();
	bool stands(const TileKey &tile) const { return standing.count(tile) > 0; }
	int standing_count() const { return int(standing.size()); }
	/// Tiles that are to come.
	int waiting_count() const { return int(jobs.size() + coming.size()); }

	/// Whoever looks, and whatever else the field is to stand around, in its axes (m).
	static std::vector<glm::vec2> places_of(const Scene &scene);
	/// Fills in how the tile of a recipe is to grow by a request without its map, but for spacing and style. False
	/// where it cannot, by a fault of which whoever asks for the whole field is told.
	static bool describe(const Scene &scene, const PlacementRequest &base, TileRecipe &recipe);

	/// Goes on in a frame of physics or another one: chooses now and then, lets tiles go and come. `edits`: the store
	/// may be edited. Where it does something it takes a part of a millisecond, and ends in the midst of it.
	void go_on(const Scene &scene, bool physics, bool edits);
	/// All tiles that are on their way begin anew; what stands of them goes.
	void interrupt(const Scene &scene);
	/// The same of those that meet a box (m, field axes).
	void interrupt(const Scene &scene, const AreaBox &box);
	/// What they look like or how they move is another.
	void forget_style() { outline.reset(); }

private:
	std::set<TileKey> standing; ///< Or begin to.
	std::vector<TileKey> coming; ///< Nearest last.
	std::vector<TileKey> going; ///< Farthest last.
	std::vector<std::unique_ptr<TileJob>> jobs;
	std::set<TileKey> due; ///< Tiles of a build that are not live yet.
	size_t due_at_first = 0;
	bool has_build_to_choose = false; ///< `due` is unknown until the next choice.
	PlacementRequest base; ///< Of all tiles, without its map.
	AreaBox area;
	std::shared_ptr<const FieldStyle> outline;
	GroundAsker asker;
	const TileJob *asking = nullptr;
	int frames_since_choice = 0;

	void choose(const Scene &scene);
	void choose_due();
	void leave(const Scene &scene, const TileKey &tile);
	bool begin(const Scene &scene);
	void ask_ground(const Scene &scene, bool physics);
	/// Whether the job is done.
	bool go_on(const Scene &scene, TileJob &job, bool edits, double until_usec, const Stopwatch &watch);
};

} // namespace undergrowth
