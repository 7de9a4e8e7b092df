#pragma once

#include "field/field_changes.hpp"
#include "field/field_motion.hpp"
#include "field/field_skeletons.hpp"

#include <godot_cpp/variant/typed_array.hpp>

#include <functional>
#include <vector>

namespace undergrowth {

/// Which plants near those who look are shown as nodes with skeletons, and in which pose. Main thread.
class SkeletonView {
public:
	/// What the choice is made of.
	struct Scene {
		godot::Node3D *field;
		const PlantStore &store;
		const FieldStyle &style;
		FieldMotion &motion;
		const FieldChanges &changes; ///< Who is mown has none.
		godot::Transform3D axes; ///< From the field's to the world's.
		FieldWear wear; ///< Of the first level.
	};
	/// Tells of a skeleton that comes (true) or goes.
	using Tell = std::function<void(godot::Skeleton3D *, bool)>;

	explicit SkeletonView(Tell &&teller) : tell(std::move(teller)) {}

	/// Removes what a copy of a field, or one whose library was reloaded, finds among its children.
	void remove_strays(godot::Node3D *field) const { nodes.remove_strays(field); }
	/// Once a frame, between two steps: now and then shows the plants nearest to `eyes` (world axes) within `distance`
	/// (m), `most` of them. Tells whether the textures changed.
	bool choose(const Scene &scene, const std::vector<godot::Vector3> &eyes, double distance, int most);
	/// The next frame chooses.
	void choose_soon() { frames_since_choice = 0; }
	/// After plants went: their skeletons go, too.
	void release_gone(const PlantStore &store);
	/// Those of these plants, which are drawn again.
	void release_those(FieldMotion &motion, const std::vector<PlantPlace> &ascending);
	/// Those of all plants of these blocks, which go.
	void release_in(const std::vector<int> &blocks);
	/// All of them; their plants are drawn again.
	void release_all(FieldMotion &motion);
	/// Frees those that nobody uses.
	void clear() { nodes.clear(); }
	/// Turns all bones as the field bends its plants in this frame.
	void pose(const PlantStore &store, const FieldMotion &motion) const;
	void dress(const FieldWear &wear) const;
	/// Stems of a species bend otherwise. Those that are to have other bones go, and come again.
	void follow_stems(const PlantStore &store, const FieldStyle &style, FieldMotion &motion);

	int count() const { return int(shown.size()); }
	godot::TypedArray<godot::Skeleton3D> skeletons() const;
	/// Null where the plant has none.
	godot::Skeleton3D *find(const PlantPlace &place) const;
	/// The block is -1 where it shows none now.
	PlantPlace find(const godot::Skeleton3D *skeleton) const;

private:
	struct Shown {
		PlantPlace place;
		uint64_t skeleton = 0; ///< Instance id.
		std::shared_ptr<PartSkeleton> parts; ///< Null: it has root and tip alone.
	};

	Tell tell;
	FieldSkeletons nodes;
	std::vector<Shown> shown;
	int frames_since_choice = 0;

	std::vector<PlantPlace> find_nearest(
			const Scene &scene, const std::vector<godot::Vector3> &eyes, double distance, int most) const;
	bool release(FieldMotion *motion, const std::function<bool(const Shown &)> &goes);
	void show(const Scene &scene, const PlantPlace &place);
	const Shown *find_shown(const PlantPlace &place) const;
};

} // namespace undergrowth
