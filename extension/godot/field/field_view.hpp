#pragma once

#include "field/field_motion.hpp"
#include "field/field_style.hpp"
#include "stand/plant_store.hpp"

#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <array>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <vector>

namespace undergrowth {

/// A square of the ground at one level of detail: some tiles wide, or a part of one. Plants that code added have
/// multimeshes of their own, and so has each block of newcomers: what was filled is not touched.
struct ClumpPlace {
	bool is_added;
	int level;
	int factor; ///< So many tiles wide.
	TileKey tile; ///< As wider_tile() has it for that factor.
	int newcomers = -1; ///< The number of their block.
	int part = -1; ///< Which part of a tile that is cut.

	bool operator<(const ClumpPlace &other) const {
		return std::tie(is_added, level, factor, tile, newcomers, part) <
				std::tie(other.is_added, other.level, other.factor, other.tile, other.newcomers, other.part);
	}
	/// Whether it is the same but for the part.
	bool is_beside(const ClumpPlace &other) const {
		return std::tie(is_added, level, factor, tile, newcomers) ==
				std::tie(other.is_added, other.level, other.factor, other.tile, other.newcomers);
	}
};

/// How finely a multimesh's plants are counted by rank.
constexpr int RANK_STEPS = 32;
using RankCounts = std::array<int, RANK_STEPS + 1>;
/// As the shader's: so much wider plants are drawn at most (undergrowth_width.gdshaderinc).
constexpr float MOST_WIDENING = 3.0f;

/// One multimesh in the making: plants of one place that show one mesh, by rank.
struct ClumpPlan {
	ClumpPlace place;
	int species = 0;
	int group = 0; ///< Which of the meshes that its level has of the species.
	int count = 0;
	int stride = 0; ///< Floats per plant.
	RankCounts kept = {}; ///< How many have a rank of at most i / RANK_STEPS.
	godot::PackedFloat32Array buffer;
	godot::AABB box; ///< Covers the largest deflection.
	godot::AABB roots; ///< From where to where they stand.
};

/// A block to be drawn.
struct DrawnBlock {
	PoseTexels texels;
	const PlantBlock *block;
	int newcomers = -1; ///< Its number, where it is one of newcomers.
};

/// How all plants of some blocks are drawn. On any thread.
std::vector<ClumpPlan> plan_clumps(const FieldStyle &style, const std::vector<DrawnBlock> &blocks);
/// The same at one level of detail.
std::vector<ClumpPlan> plan_level(const FieldStyle &style, const std::vector<DrawnBlock> &blocks, int level);

/// The multimeshes of a field, one for each level, place, species and mesh. Transforms never change: what moves is in
/// the motion's textures, which each instance names its texel in. A plant that is gone is hidden there. Main thread.
class FieldView {
public:
	FieldView() = default;
	~FieldView();
	FieldView(const FieldView &) = delete;
	FieldView &operator=(const FieldView &) = delete;

	/// Makes a plan ready to be shown by exchange() or exchange_tile(), of the same style.
	void prepare(const FieldStyle &style, const ClumpPlan &plan);
	/// It is not shown after all.
	void forget_prepared();
	/// Hands what was prepared to the renderer, for about `usec`, where its materials draw nothing yet. Telling it of
	/// all in one frame would take longer than all else in it. False: there is nothing left.
	bool reveal_some(double usec);
	/// Shows what was prepared, of this style, instead of all else, whose materials draw nothing from now on.
	void exchange(const FieldStyle &style);
	/// Frees what is shown no more, for about `usec`; before that it hears of it, at once where `hides_all`. False:
	/// there is nothing left.
	bool free_some(double usec, bool hides_all = false);

	/// Shows these plans, beside what is shown.
	void show(const FieldStyle &style, const std::vector<ClumpPlan> &plans);
	/// Draws the plants that were added anew in all places with a block that grew or was dropped.
	void show_added(const FieldStyle &style, const FieldMotion &motion, const PlantStore &store,
			const std::set<TileKey> &tiles);
	/// All plants that were added.
	void show_all_added(const FieldStyle &style, const FieldMotion &motion, const PlantStore &store);

	/// Shows the plans of a block of newcomers instead of what was shown of it.
	void show_newcomers(const FieldStyle &style, const TileKey &tile, int number, const std::vector<ClumpPlan> &plans);

	/// Draws nothing of a tile's plants that were filled, but for those in wider squares; newcomers stay.
	void drop_tile(const TileKey &tile);
	/// After that: shows what was prepared of this tile, as `style` has it by now. What it needs beside what was shown
	/// is as much as before.
	void show_tile(const FieldStyle &style, const TileKey &tile);
	/// What was prepared of it is not shown after all.
	void forget_tile(const TileKey &tile);

	/// Draws nothing of a block of newcomers any more.
	void drop_newcomers(int number);

	/// Where levels begin and end changed, or what casts shadows; their number and meshes have not.
	void update_levels(const FieldStyle &style);
	/// Into which world, or none.
	void set_scenario(const godot::RID &scenario);
	void set_transform(const godot::Transform3D &transform);
	void set_visible(bool visible);
	void wear(const FieldWear &wear);
	/// Before a frame is drawn: draws no more of each multimesh than the nearest of `eyes` (world axes) sees of it. No
	/// eyes: everything. Costs by the multimeshes, and only where an eye has moved.
	void thin(const std::vector<godot::Vector3> &eyes);
	/// A frame is about to be drawn.
	void note_drawing() { has_untold = false; }
	/// Once a frame, where nobody may have drawn the one before, as in a headless process: lets the renderer take in
	/// what it was told. Else it would do that for all that was ever shown as soon as anything is freed.
	void tell_if_undrawn();
	/// Whether thin() has anything to do.
	bool thins() const;
	/// The materials of `style` are other ones.
	void wear_materials(const FieldStyle &style);
	/// Whose instances they are: what a ray of the editor meets.
	void set_owner(uint64_t object) { owner = object; }

	/// Plants that are shown at each level to an eye at `eye` (world axes).
	std::vector<int> count_drawn(const FieldStyle &style, const godot::Vector3 &eye) const;

private:
	struct Clump {
		godot::RID multimesh;
		godot::RID instance;
		int species = 0;
		int count = 0;
		bool has_parts = false;
		RankCounts kept;
		godot::AABB roots; ///< Field axes, m.
		godot::Vector3 middle; ///< Of what is drawn, which the engine measures to.
		float radius = 0.0f; ///< m, about that: the farthest that a root is.
		int shown = RANK_STEPS; ///< Up to which rank, times RANK_STEPS.
		bool is_revealed = false; ///< The renderer has it, whatever its materials draw.
	};

	using Clumps = std::map<ClumpPlace, std::vector<Clump>>;

	Clumps clumps;
	Clumps prepared; ///< Not drawn yet.
	std::vector<Clump> leaving; ///< Materials draw nothing of it, and the renderer is yet to hear of it.
	std::vector<Clump> gone; ///< Not drawn any more, and yet to be freed.
	std::map<int, TileKey> newcomers; ///< Tiles of their blocks that are drawn.
	std::vector<FieldLevel> levels; ///< As they were shown.
	std::vector<FieldLevel> prepared_levels;
	std::optional<ClumpPlace> next_revealed; ///< Where reveal_some() continues. Empty: at the first place.
	godot::RID world; ///< Its scenario.
	godot::Transform3D placed;
	float largest_scale = 1.0f; ///< Of the field's axes.
	bool is_visible = true;
	bool has_untold = false; ///< Something was shown since a frame was drawn.
	FieldWear worn;
	uint64_t owner = 0;
	std::vector<godot::Vector3> thinned_for; ///< Eyes.
	bool is_thinned = false; ///< For these; else something changed.

	Clump make(const FieldStyle &style, const ClumpPlan &plan) const;
	void reveal(Clump &clump);
	static void set_visible(const Clump &clump, bool visible);
	static void let_go(const Clump &clump);
	static void move_all(Clumps &from, std::vector<Clump> &into);
	void clear(const ClumpPlace &place);
	template <class Act> static void take_parts(Clumps &from, const ClumpPlace &place, const Act &act);
	void set_range(const Clump &clump, const FieldLevel &level) const;
	void set_wear(const Clump &clump, const FieldLevel &level) const;
	int steps_for(const FieldLevel &level, const Clump &clump, const std::vector<godot::Vector3> &eyes) const;
	/// Calls act(server, level, clump) for all, those that are prepared included.
	template <class Act> void for_each(Act &&act) const;
};

} // namespace undergrowth
