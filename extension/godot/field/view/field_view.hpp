#pragma once

#include "base/piece_cost.hpp"
#include "field/motion/field_motion.hpp"
#include "field/view/batch_plans.hpp"
#include "field/view/near_plants.hpp"
#include "field/view/shadow_plants.hpp"
#include "placement/plant_store.hpp"

#include <godot_cpp/classes/rendering_server.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <map>
#include <optional>
#include <set>
#include <vector>

namespace undergrowth {

/// The multimeshes of a field, one for each level, square, species and mesh. Transforms never change: the motion's
/// textures contain what moves, and each instance has the number of its texel. The texel also hides a removed plant.
/// Main thread.
class FieldView {
public:
	FieldView() = default;
	~FieldView();
	FieldView(const FieldView &) = delete;
	FieldView &operator=(const FieldView &) = delete;

	/// Creates the multimesh of a plan, for exchange() or show_tile() with the same setup.
	void prepare(const FieldRenderSetup &setup, const BatchPlan &plan);
	/// Expected µs of prepare().
	double expected_usec(const BatchPlan &plan) const { return preparing.expected_usec(plan.count); }
	/// Discards all prepared multimeshes.
	void forget_prepared();
	/// Passes prepared multimeshes to the renderer for about `usec`, while their materials draw nothing. All of them in
	/// one frame would take longer than everything else in it. Returns false if none is left.
	bool reveal_some(double usec);
	/// Shows all prepared multimeshes, of this setup, instead of all others. The materials of the old ones draw nothing
	/// from now on.
	void exchange(const FieldRenderSetup &setup);
	/// Hides and frees replaced multimeshes, for about `usec`; `hides_all`: hides all of them now. Returns false if
	/// none is left.
	bool free_some(double usec, bool hides_all = false);

	/// Shows these plans in addition.
	void show(const FieldRenderSetup &setup, const std::vector<BatchPlan> &plans);
	/// Rebuilds the multimeshes of added plants in these tiles, where a chunk grew or was dropped.
	void show_added(const FieldRenderSetup &setup, const FieldMotion &motion, const PlantStore &store,
			const std::set<TileKey> &tiles);
	/// The same for all added plants.
	void show_all_added(const FieldRenderSetup &setup, const FieldMotion &motion, const PlantStore &store);

	/// Removes the multimeshes of a chunk of new plants, before show() of its new plans.
	void replace_new_chunk(const TileKey &tile, int number);

	/// Hides the generated plants of a tile, except those in wider squares and in chunks of new plants.
	void drop_tile(const TileKey &tile);
	/// Call after drop_tile(): shows the prepared multimeshes of this tile, with the present materials, distances and
	/// shadows of `setup`. Levels and species must be those of prepare().
	void show_tile(const FieldRenderSetup &setup, const TileKey &tile);
	/// Discards the prepared multimeshes of a tile.
	void forget_tile(const TileKey &tile);

	/// Removes the multimeshes of a chunk of new plants, which is gone.
	void drop_new_chunk(int number);

	/// Applies changed distances of levels, or shadows. The number of levels and their meshes are unchanged.
	void update_levels(const FieldRenderSetup &setup);
	/// Scenario of the world to draw in, or an invalid RID.
	void set_scenario(const godot::RID &scenario);
	void set_transform(const godot::Transform3D &transform);
	/// Call before a frame is drawn. Tilts the plants that these cameras see by this x of their y axis, in the field's
	/// axes, and no others: see MotionVectors. It changes instances only if the tilt or what is seen has changed.
	void set_tilt(float now, const std::vector<DrawingCamera> &cameras);
	void set_visible(bool visible);
	void set_flags(const InstanceRenderFlags &flags);
	/// Call before a frame is drawn: draws of each multimesh only what the nearest camera of `cameras` (world axes)
	/// shows, and no shadows of distant ones. No cameras: draws everything. The cost depends on the number of
	/// multimeshes, and only after a camera moved.
	void cull(const std::vector<DrawingCamera> &cameras);
	/// As ShadowPlants::is_listing().
	bool is_listing_shadows() const { return shadows.is_listing(); }
	/// Call before a frame is drawn.
	void note_drawing() { has_unflushed = false; }
	/// Call once per frame. If no frame was drawn, as in a headless process, the renderer processes the new multimeshes
	/// now. Without it the renderer would process everything ever shown as soon as one is freed.
	void flush_if_undrawn();
	/// True if cull() has an effect.
	bool culls() const;
	/// Applies the new materials of `setup`.
	void set_materials(const FieldRenderSetup &setup);
	/// Sets the owner of the instances, which the editor selects by rays.
	void set_owner(uint64_t object);

	/// Number of plants that a camera at `camera` (world axes) shows at each level. Counts again after the camera has
	/// moved by 0.25 m or multimeshes have changed.
	const std::vector<int> &count_drawn(const FieldRenderSetup &setup, const godot::Vector3 &camera);

private:
	struct Batch {
		godot::RID multimesh;
		godot::RID instance;
		int species = 0;
		int count = 0;
		bool has_parts = false;
		RankCounts rank_counts;
		godot::AABB roots; ///< Field axes, m.
		godot::Vector3 middle; ///< Centre of the drawn box, to which the engine measures distances.
		float radius = 0.0f; ///< m, largest distance of a root from `middle`.
		std::shared_ptr<NearSquare> near; ///< Without a multimesh: NearPlants and ShadowPlants draw from it.
		int shown = RANK_STEPS; ///< Highest drawn rank, times RANK_STEPS.
		bool is_within_shadows = true; ///< So near to a camera that its plants cast shadows.
		float tilt = 0.0f; ///< As set_tilt() set it.
		bool is_revealed = false; ///< The renderer has it, even if its materials draw nothing.
	};

	using Batches = std::map<BatchKey, std::vector<Batch>>;

	Batches batches;
	Batches prepared; ///< Not drawn yet.
	PieceCost preparing;
	std::vector<Batches> leaving; ///< Replaced: materials draw nothing, and the instances are not hidden yet.
	std::vector<Batch> gone; ///< Hidden, not freed yet.
	std::map<int, TileKey> new_chunks; ///< Tiles by the number of a drawn chunk of new plants.
	using Levels = std::vector<std::vector<FieldLevel>>; ///< By species.
	Levels levels; ///< As last shown.
	Levels prepared_levels;
	NearPlants near;
	ShadowPlants shadows;
	bool has_other_near = false; ///< Squares of `near` and `shadows` came or went.
	std::optional<BatchKey> next_revealed; ///< Next square for reveal_some(). Empty: the first one.
	ListSurroundings around;
	float tilt = 0.0f; ///< Of plants in sight.
	float largest_scale = 1.0f; ///< Of the field's axes.
	bool has_unflushed = false; ///< Multimeshes were shown since the last drawn frame.
	std::vector<DrawingCamera> culled_for; ///< Cameras of the last cull().
	bool is_culled = false; ///< False: something changed since.
	std::vector<int> counted; ///< Drawn plants by level.
	godot::Vector3 counted_for; ///< The camera.
	bool has_counted = false; ///< `counted` is up to date for it.

	void note_change() { is_culled = has_counted = false; }
	Batch make(const FieldRenderSetup &setup, const BatchPlan &plan) const;
	godot::Transform3D place_of(const Batch &batch) const;
	bool is_seen(const Batch &batch, const FieldLevel &level, const DrawingCamera &camera) const;
	void reveal(Batch &batch);
	void set_visible(const Batch &batch, bool visible) const;
	static void set_material(
			godot::RenderingServer *server, const FieldRenderSetup &setup, const BatchKey &place, const Batch &batch);
	int level_count() const { return levels.empty() ? 0 : int(levels.front().size()); }
	static void free_batch(const Batch &batch);
	void clear(const BatchKey &place);
	void show_prepared(const FieldRenderSetup &setup, const BatchKey &place, Batch &&batch);
	static bool has_near(const std::vector<Batch> &group);
	template <class Act> static void take_parts(Batches &from, const BatchKey &place, const Act &act);
	void set_range(const Batch &batch, const FieldLevel &level) const;
	void apply_flags(const Batch &batch, const FieldLevel &level) const;
	/// Smallest distance (m) of its plants to a camera, never too large. No cameras: 0.
	float distance_to(const Batch &batch, const std::vector<DrawingCamera> &cameras) const;
	int steps_for(const FieldLevel &level, const Batch &batch, float distance) const;
	void set_caster(const Batch &batch, const FieldLevel &level) const;
	static Levels levels_of(const FieldRenderSetup &setup);
	const FieldLevel &level_of(const BatchKey &place, const Batch &batch) const {
		return levels[size_t(batch.species)][size_t(place.level)];
	}
	void place_near();
	void bind_lists(const FieldRenderSetup &setup);
	void pass_surroundings();
	/// Calls act(server, level, batch) for all multimeshes, prepared ones included.
	template <class Act> void for_each(Act &&act) const;
};

} // namespace undergrowth
