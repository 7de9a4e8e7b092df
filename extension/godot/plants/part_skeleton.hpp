#pragma once

#include "mesh/form_bones.hpp"
#include "motion/part_bend.hpp"
#include "motion/stem_state.hpp"
#include "species/sampled_plant.hpp"
#include "stem/stem_bones.hpp"

#include <godot_cpp/classes/skeleton3d.hpp>
#include <godot_cpp/classes/skin.hpp>
#include <godot_cpp/variant/quaternion.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <memory>
#include <vector>

namespace undergrowth {

/// The bones of one plant after root and tip: those of its stem's joints and of its parts, with their present pose.
class PartSkeleton {
public:
	/// Creates the bones of a plant that was sampled for a skeleton. Returns null if it has no such bones.
	static std::unique_ptr<PartSkeleton> of(const SampledPlant &sampled);
	/// Returns the pose of each bone in calm air, root and tip included, relative to the bind pose.
	static std::vector<godot::Transform3D> at_rest(const SampledPlant &sampled);

	/// Adds root and tip and, if `parts` is not null, its bones to a skeleton. Existing bones remain.
	static void set_up(godot::Skeleton3D *skeleton, const PartSkeleton *parts);
	/// Returns the skin that binds a mesh to the bones.
	static godot::Ref<godot::Skin> skin_of(const PartSkeleton *parts);
	/// Returns the number of bones of a skeleton.
	static int count(const PartSkeleton *parts);

	/// Motion of the stem, in the plant's own axes.
	StemMotion stem;
	/// True if all parts are at rest at this bend. No further pose is necessary until the stem moves.
	bool is_calm() const;
	/// True if the stem has joints. If so, this class also poses the tip.
	bool has_joints() const { return joints > 0; }
	int joint_count() const { return joints; }
	/// See PlantView::arm().
	glm::vec3 arm(const glm::vec3 &direction, float share) const;
	/// Replaces the constants, for the same number of joints.
	void set_stem(const std::shared_ptr<const StemConstants> &stem_constants) { constants = stem_constants; }

	/// Returns the second mode's part of the bend of a stem in this state, as MotionPage::second_bend(). All vectors
	/// are in the plant's axes.
	glm::vec3 second_bend(const TipState &tip, const StemSecond &second) const;

	/// Sets the pose of the node.
	void pose(godot::Skeleton3D *skeleton);
	/// Sets the pose in the renderer only. `drawn` is the renderer's skeleton.
	void pose(const godot::RID &drawn);

private:
	int joints = 0;
	std::shared_ptr<const StemConstants> constants; ///< Null if the stem has no joints.
	float height = 1.0f; ///< m.
	std::vector<PartBone> bones;
	std::vector<godot::String> names; ///< Of all bones.
	std::vector<int> parents; ///< Of all bones; -1 for the root.
	std::vector<godot::Vector3> origins; ///< Rest positions of all bones (m), in the plant's axes.
	std::vector<godot::Transform3D> posed; ///< Of all bones, in the plant's axes.
	StemLink links[MAX_STEM_JOINTS]; ///< Of the bent stem, in the axes of its rest.
	glm::vec3 end; ///< End of the last link, in lengths of the stem.
	godot::Quaternion turns[MAX_STEM_JOINTS + 1]; ///< Of the links and the tip, in the plant's axes.
	godot::Ref<godot::Skin> skin;

	void add_bone(const godot::String &name, int parent, const godot::Vector3 &origin);
	void add_stem();
	int part_index(size_t part) const { return FormBones::FIRST + joints + int(part); }
	int carrier_of(const PartBone &bone) const;
	void update_stem(const PosedStem &posed_stem);
	void place_stem();
	/// `needs_places`: also updates the positions of the stem's joints in `posed`.
	void update(bool needs_places);
};

} // namespace undergrowth
