#pragma once

#include "field/field_edits.hpp"
#include "field/motion/field_motion.hpp"
#include "field/view/field_skeletons.hpp"

#include <godot_cpp/variant/typed_array.hpp>

#include <functional>
#include <vector>

namespace undergrowth {

/// Selects plants near the cameras that are shown as nodes with skeletons, and poses those. Main thread.
class SkeletonView {
public:
	/// Input of a selection.
	struct Scene {
		godot::Node3D *field;
		const PlantStore &store;
		const FieldRenderSetup &setup;
		FieldMotion &motion;
		const FieldEdits &edits; ///< Mown plants get no skeletons.
		godot::Transform3D axes; ///< From the field's axes to the world's.
		InstanceRenderFlags flags; ///< Properties of the first level's instances.
	};
	/// Called when a skeleton appears (true) or disappears (false).
	using Callback = std::function<void(godot::Skeleton3D *, bool)>;

	explicit SkeletonView(Callback &&on_change) : callback(std::move(on_change)) {}

	/// Removes skeletons that a duplicated field, or one of a reloaded library, has among its children.
	void remove_strays(godot::Node3D *field) const { nodes.remove_strays(field); }
	/// Call once per frame, between two steps. Every few frames it shows the plants nearest to `cameras` (world axes)
	/// within `distance` (m), up to `max`. Returns true if the textures changed.
	bool choose(const Scene &scene, const std::vector<godot::Vector3> &cameras, double distance, int max);
	/// Makes the next frame select again.
	void choose_soon() { frames_since_choice = 0; }
	/// Call when plants were removed, before their places are used again. Their skeletons are not posed any more;
	/// release_left() releases them.
	void follow(const ChangeSet &changes);
	/// Releases the skeletons of removed plants.
	void release_left();
	/// Releases the skeletons of these plants, which are drawn in multimeshes again.
	void release_those(FieldMotion &motion, const std::vector<PlantRef> &ascending);
	/// Releases all skeletons; their plants are drawn in multimeshes again.
	void release_all(FieldMotion &motion);
	/// Frees all unused skeletons.
	void clear() { nodes.clear(); }
	/// Turns all bones to the plants' bends in this frame.
	void pose(const PlantStore &store, const FieldMotion &motion) const;
	void apply_flags(const InstanceRenderFlags &flags) const;
	/// Copies the stems of species after a change. Skeletons that need another number of bones are released and
	/// selected again.
	void follow_stems(const PlantStore &store, const FieldRenderSetup &setup, FieldMotion &motion);

	int count() const { return int(shown.size()); }
	godot::TypedArray<godot::Skeleton3D> skeletons() const;
	/// Null if the plant has no skeleton.
	godot::Skeleton3D *find(const PlantRef &ref) const;
	/// The chunk is -1 if the skeleton shows no plant.
	PlantRef find(const godot::Skeleton3D *skeleton) const;

private:
	struct Shown {
		PlantRef ref;
		uint64_t skeleton = 0; ///< Instance id.
		std::shared_ptr<PartSkeleton> parts; ///< Null: only bones of root and tip.
	};

	Callback callback;
	FieldSkeletons nodes;
	std::vector<Shown> shown;
	std::vector<Shown> left; ///< Of removed plants, until release_left().
	int frames_since_choice = 0;

	std::vector<PlantRef> find_nearest(
			const Scene &scene, const std::vector<godot::Vector3> &cameras, double distance, int max) const;
	bool release(FieldMotion *motion, const std::function<bool(const Shown &)> &goes);
	void give_back(const std::vector<Shown> &gone);
	godot::Skeleton3D *show(const Scene &scene, const PlantRef &ref);
	const Shown *find_shown(const PlantRef &ref) const;
};

} // namespace undergrowth
