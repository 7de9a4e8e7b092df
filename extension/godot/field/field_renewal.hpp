#pragma once

#include "field/field_tiles.hpp"
#include "field/skeleton_view.hpp"

#include <memory>
#include <vector>

namespace undergrowth {

/// Grows all tiles of a field anew that stands, one after the other, while the others go on standing as they did. A
/// tile is exchanged in one frame, when all of it is ready to be drawn. Main thread.
class FieldRenewal {
public:
	using Scene = FieldTiles::Scene;

	/// Beside what it shares with tiles that come.
	struct Way {
		FieldMotion &motion;
		SkeletonView &skeletons;
		bool joins = false; ///< What is drawn wider than a tile stays for now.
	};

	/// Tiles that are to be grown anew by a request, those near whoever looks last: all that stand, and those that
	/// will. None where tiles are too many or too empty for it to be worth while, plants too many, or two would have
	/// one name.
	static std::vector<TileKey> list(const Scene &scene, const PlacementRequest &request, const FieldTiles &tiles);
	/// All tiles of a field that does not stream and has none yet, the nearest last. None where they are too many or
	/// too empty to be built one by one.
	static std::vector<TileKey> list_first(const Scene &scene, const PlacementRequest &request);
	/// These are to stand by a request from now on, the last one first.
	void begin(std::vector<TileKey> &&tiles, const PlacementRequest &request);
	bool is_at_work() const { return !waiting.empty() || !jobs.empty(); }
	/// 0 to 1.
	float progress() const;
	/// Goes on in a frame of physics or another one, as FieldTiles does.
	void go_on(const Scene &scene, const Way &way, bool physics);
	/// The ground queries of all tiles.
	GroundAsker &ground_asker() { return asker; }
	/// Waits for all worker jobs. They stay as they are.
	void wait_for_jobs();
	/// What is on its way begins anew.
	void interrupt(const Scene &scene, FieldMotion &motion);
	/// The same of what meets a box (m, field axes).
	void interrupt(const Scene &scene, FieldMotion &motion, const AreaBox &box);
	/// It is given up. What stands, stands.
	void stop(const Scene &scene, FieldMotion &motion);
	/// Some who stand in this tile are no more.
	void note_removed(const TileKey &tile);

private:
	/// A tile on its way.
	struct Coming {
		std::unique_ptr<TileJob> job;
		bool is_planned = false;
		bool lost_some = false; ///< Plants that were removed meanwhile.
	};

	std::vector<TileKey> waiting; ///< The next one last.
	size_t tile_count = 0; ///< At first.
	std::vector<Coming> jobs;
	PlacementRequest base; ///< Without its map.
	double placed_at = 1.0; ///< m, spacing.
	std::shared_ptr<const FieldStyle> outline;
	GroundAsker asker;
	const TileJob *asking = nullptr;

	bool begin_one(const Scene &scene);
	void ask_ground(const Scene &scene, bool physics);
	/// Whether the tile is as it is to be.
	bool go_on(const Scene &scene, const Way &way, Coming &coming, double until_usec, const Stopwatch &watch);
	void exchange(const Scene &scene, const Way &way, Coming &coming);
	void give_up(const Scene &scene, FieldMotion &motion, size_t number, bool again);
};

} // namespace undergrowth
