#pragma once

#include "field/field_changes.hpp"
#include "field/field_dress.hpp"
#include "field/field_motion.hpp"
#include "field/field_patches.hpp"
#include "field/field_recipe.hpp"
#include "field/field_renewal.hpp"
#include "field/field_tiles.hpp"
#include "field/ground_survey.hpp"
#include "field/listed_looks.hpp"
#include "field/look_asking.hpp"
#include "field/skeleton_view.hpp"
#include "frame_cost.hpp"
#include "stand/standing_area.hpp"
#include "worker_task.hpp"

#include <godot_cpp/classes/geometry_instance3d.hpp>

#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace undergrowth {

/// What a PlantField3D is made of, and the way of an edit through it: PlantStore knows what stands, FieldMotion how it
/// moves, FieldView and SkeletonView how it is seen; each owns its state, and a ChangeSet tells the others. Growing
/// goes on beside the game (FieldFill) and is taken over between two frames. Main thread.
class Meadow {
public:
	/// What the node hears of.
	struct Listener {
		std::function<void(const godot::String &)> fault; ///< Empty: there is none any more.
		std::function<void(const godot::String &)> failed; ///< A build ended without its plants, and why.
		std::function<void(const godot::String &)>
				no_ground; ///< What to check; empty: some was found, or none is asked.
		std::function<void(float)> progressed; ///< 0 to 1.
		std::function<void()> filled;
		SkeletonView::Tell skeleton;
	};

	Meadow(godot::GeometryInstance3D *node, const FieldProperties &set_by_users, Listener &&teller);
	~Meadow();

	/// Grows anew what stands (`places`), or only what it looks like and how finely it moves. Where species look as
	/// they do (not `looks`) that goes tile by tile.
	void fill(bool places, bool looks = true);
	/// Whether all of it is exchanged at once.
	bool is_at_work() const { return asking || job; }
	/// Whether it places plants, or joins tiles that were placed one by one.
	bool is_building() const { return is_placing() || tiles.is_building(); }
	/// Builds all that is missing before it returns. False where that is not possible.
	bool build_now();
	/// Whether tiles of another size are wanted than those that stand.
	bool needs_other_tiles() const { return streams() && float(properties.tile_size) != store.tile_size(); }
	/// Repeats an edit of the plants in a box (m, field axes) for plants that the first build adds later.
	void repeat_in_first_build(const AreaBox &box, std::function<void()> &&edit);
	void forget_repeated_edits() { repeated.clear(); }
	/// What is painted in a box (m, field axes) changed: those who come and go there do so beside the game, while all
	/// others stand untouched. Where nothing stands yet, or too much changed, the field is filled.
	void touch(const AreaBox &box);
	bool is_patching() const { return patches.is_at_work(); }
	/// Paths that give the field room, or keep places free, are others: grows anew what is between those that it stands
	/// by and these.
	void follow_area();
	/// Whether only tiles near somebody stand.
	bool streams() const { return properties.view_distance > 0.0; }
	/// Whether it is to be polled.
	bool wants_frames() const {
		return is_at_work() || is_building() || is_patching() || streams() || !retired.empty() ||
				!retired_materials.empty() || tells_of_patches;
	}
	/// Whether what is filled takes its motion over: nothing of it is to be waited for in this frame.
	bool is_handing_over() const { return job && job->is_handed_over; }
	/// Goes on with it; at any frame (of `delta` s), paused or not. `physics`: it is one of physics, in which rays may
	/// be cast.
	void poll(double delta, bool physics);

	/// Between two polls: so strokes are seen in the frame in which they are ready.
	void follow_strokes(FieldPatches::Moment moment, double delta);

	/// Once a frame (of `delta` s) that is not paused. Tells how many µs of this thread steps took.
	double advance(double delta, bool simulates);
	void preview(double delta, const godot::Ref<PlantWind> &blowing);
	/// Shows what changed since the last frame.
	void refresh();

	/// Before each frame is drawn, paused or not: leaves plants away that are too far from all who look.
	void thin();

	/// Look of a function whose plants code adds; -1, with a fault told, where it cannot be built.
	int species_for(const godot::Ref<PlantFunction> &function);
	/// With `ids` they come back by their names, which nobody has; ascending.
	std::vector<PlantId> add(std::vector<PlacedPlant> &&plants, std::vector<PlantId> &&ids = {});
	/// Tells how many stood there.
	int remove(std::vector<PlantPlace> &&places);
	/// Plants are so high, each as a share of its own height.
	void mow(std::vector<PlantPlace> &&places, const std::vector<float> &shares);
	/// The entry of the list that a function is of, or null.
	godot::Ref<PlantFieldSpecies> listed_entry(const godot::Ref<PlantFunction> &function) const {
		return undergrowth::listed_entry(properties, function);
	}
	/// The listed species that its map knows by this name, or null.
	godot::Ref<PlantFunction> listed_species(const godot::String &name) const {
		return undergrowth::listed_species(properties, name);
	}
	/// What changed of single plants is seen in the next frame, or at once where there is none.
	void show_soon();
	/// Whoever was gone in these boxes (m, field axes) may stand there again.
	void grow_again(const std::vector<AreaBox> &boxes);
	void settle();

	/// How a species moves is another: its plants stay, and so does their motion, where they move.
	void read_motion(const PlantFunction *function, bool is_still);
	/// Stems have their shapes by what blows now.
	void feel(const godot::Ref<PlantWind> &blowing);
	/// Distances of levels, or shadows. False where other meshes are needed for them.
	bool update_levels();
	void update_wear(const FieldWear &wear);
	/// A species wears another material.
	void change_materials();
	/// One species' materials follow what its user set, in turns.
	void follow_materials() { dress.follow(style); }
	void skeletons_changed();

	void enter_tree();
	void exit_tree();
	void moved();
	void set_visible(bool visible);

private:
	const std::unique_ptr<FieldMotion> own_motion;

public:
	PlantStore store;
	FieldMotion &motion;
	FieldStyle style;
	SkeletonView skeletons;
	FieldChanges own_changes; ///< By code.
	int64_t seed() const { return properties.seed; }
	FieldTiles tiles; ///< That stand, where it streams.
	FrameCost filling; ///< What filling took of this thread.
	double tiles_usec = 0.0; ///< What tiles took of this thread in the last frame.
	double upload_usec = 0.0; ///< What the last refresh() took of this thread.
	/// The box (field axes) that holds whatever is drawn, at most; of no volume where nothing is.
	godot::AABB box() const;
	std::vector<int> count_drawn(const godot::Vector3 &eye) const { return view.count_drawn(style, eye); }

private:
	godot::GeometryInstance3D *node;
	const FieldProperties &properties;
	Listener listener;
	FieldDress dress;
	std::vector<FieldStyle> retired; ///< What is drawn no more wears them, until all of it is freed.
	std::vector<std::vector<godot::Ref<godot::ShaderMaterial>>> retired_materials; ///< As `retired`.
	FieldView view;
	FieldWear wear;
	std::set<TileKey> unseen; ///< Tiles with plants that were added or dropped, and are not drawn so yet.
	bool is_unshown = false; ///< Plants went since the last refresh().
	std::unique_ptr<LookAsking> asking; ///< Then the job begins.
	std::unique_ptr<FieldFill> job;
	WorkerTask clearing; ///< Of what the last one leaves.
	GroundAsker asker;
	FieldPatches patches;
	FieldRenewal renewal;
	bool is_of_tiles = false; ///< It was filled so.
	/// An edit that the first build repeats.
	struct Repeated {
		AreaBox box; ///< m, field axes.
		std::function<void()> edit;
	};

	std::vector<Repeated> repeated; ///< Until the first build ends.
	std::vector<TileKey> arrived; ///< Tiles with new plants, for which edits are to be repeated.
	bool was_built = false; ///< A build has ended.
	bool has_failed = false; ///< The last one, since it began.
	float built_before = 0.0f; ///< progress() at which the tiles of the first build begin.
	godot::String tile_fault; ///< Why a tile or a patch cannot be built.
	bool is_polling = false;
	bool is_urgent = false; ///< build_now() is at work: no budgets.
	bool joins = false; ///< What was grown tile by tile is joined by the job that goes on.
	FieldGround ground; ///< As it was read when the field was filled.
	std::vector<PlantId> removed_meanwhile; ///< While the job goes on.
	StandingArea standing_area;
	bool tells_of_patches = false; ///< It is filled once they are done.
	bool is_due_again = false; ///< Its look changed while it was dressed anew.
	bool has_other_materials = false; ///< Users chose others than the job has made.
	float told_progress = -1.0f;
	godot::AABB seen_box; ///< All plants, in the field's axes, as they were some frames ago.
	unsigned frames_since_box = 0;

	SeenDistances seen_distances();

	/// What skeletons wear, which are drawn at the first level.
	FieldWear near_wear() const;
	void tell_of_stems();
	FieldMotion::Frame frame(double delta, const godot::Ref<PlantWind> &wind) const;
	FieldSettings settings() const;
	/// Without tiles of a first build that stream.
	bool is_placing() const {
		return renewal.is_at_work() || joins || (asking ? asking->places : job && job->places());
	}
	/// µs of this thread for building, a frame.
	double budget_usec() const;
	/// As GroundAsker::usual_usec().
	double ground_usec(double delta) const;
	/// Of the whole build.
	float progress() const;
	/// A build ended, without what it was for.
	void fail(const godot::String &fault);
	/// Whether a tile or a patch has failed since the last call. `builds`: that ends a build.
	bool report_tile_fault(bool builds);
	void finish_build();
	void split_first_build(FieldRecipe &recipe);
	void begin_rest(FieldFill &finished);
	void repeat_edits();
	void wait_for_jobs();
	bool can_query_ground_now() const;
	/// Once of each progress.
	void tell_of(float progress) {
		if (std::exchange(told_progress, progress) != progress) {
			listener.progressed(progress);
		}
	}
	bool renew();
	void poll_renewal(bool physics);
	void join_tiles();
	godot::String begin_asking(bool places);
	void go_on_asking();
	/// fill(), while those who went meanwhile are to be gone from it, too.
	void fill_again(bool places);
	void tell_what_stands(FieldRecipe &recipe) const;
	godot::String make_recipe(FieldRecipe &recipe);
	void poll_patches(FieldPatches::Moment moment, double delta);
	void drop_job();
	/// False: there is more to be made ready.
	bool make_ready();
	void poll_parts(double delta, bool physics);
	void serve_ground(double delta, bool physics);
	void poll_job(bool physics);
	/// False, with the fault told, where it cannot stand.
	bool adopt(FieldFill &finished);
	FieldTiles::Scene tile_scene();
	void poll_tiles(bool physics);
	void keep_standing_patches();
	ChangeSet apply(StandEdit &&edit, ArrivingBlocks *arriving = nullptr);
};

} // namespace undergrowth
