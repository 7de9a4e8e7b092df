#pragma once

#include "mesh/form_bones.hpp"
#include "motion/part_bend.hpp"
#include "motion/stem_state.hpp"
#include "sampled_plant.hpp"
#include "stem/stem_bones.hpp"

#include <godot_cpp/classes/skeleton3d.hpp>
#include <godot_cpp/classes/skin.hpp>
#include <godot_cpp/variant/quaternion.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <memory>
#include <vector>

namespace undergrowth {

/// The bones of one plant beside root and tip, those of its stem's joints and of its parts, and how they stand now.
class PartSkeleton {
public:
	/// Of a plant as it was sampled for a skeleton; null where it has no such bones.
	static std::unique_ptr<PartSkeleton> of(const SampledPlant &sampled);
	/// What each bone of a plant, root and tip included, does in calm air to what is bound to it.
	static std::vector<godot::Transform3D> at_rest(const SampledPlant &sampled);

	/// Gives a skeleton root and tip and, where there are `parts`, their bones; those that it has already stay.
	static void set_up(godot::Skeleton3D *skeleton, const PartSkeleton *parts);
	/// What binds a mesh to them.
	static godot::Ref<godot::Skin> skin_of(const PartSkeleton *parts);
	/// How many bones a skeleton has.
	static int count(const PartSkeleton *parts);

	/// What the stem does, in the plant's own axes.
	StemMotion stem;
	/// Whether everything stands still at this bend, so that it needs no further pose while the stem does not move.
	bool is_calm() const;
	/// Whether the stem has joints: then the tip is posed here, too.
	bool has_joints() const { return joints > 0; }
	int joint_count() const { return joints; }
	/// As PlantView::arm().
	glm::vec3 arm(const glm::vec3 &direction, float share) const;
	/// Other constants for as many joints.
	void set_stem(const std::shared_ptr<const StemConstants> &stem_constants) { constants = stem_constants; }

	/// What of a stem that points and moves so is its second mode, as MotionPage::second_bend(); all in the plant's
	/// axes.
	glm::vec3 second_bend(const TipState &tip, const StemSecond &second) const;

	/// Tells the node.
	void pose(godot::Skeleton3D *skeleton);
	/// Tells the renderer alone; `drawn` is what it has of the skeleton.
	void pose(const godot::RID &drawn);

private:
	int joints = 0;
	std::shared_ptr<const StemConstants> constants; ///< Of a stem with joints.
	float height = 1.0f; ///< m.
	std::vector<PartBone> bones;
	std::vector<godot::String> names; ///< Of all bones.
	std::vector<int> parents; ///< Of all bones, -1 of the root.
	std::vector<godot::Vector3> origins; ///< m: where all bones are at rest, in the plant's axes.
	std::vector<godot::Transform3D> posed; ///< Of all bones, in the plant's axes.
	StemLink links[MOST_STEM_JOINTS]; ///< Of the stem as it is bent now, in the axes of its rest.
	glm::vec3 end; ///< Where the last one ends, in lengths of the stem.
	godot::Quaternion turns[MOST_STEM_JOINTS + 1]; ///< Of the links and the tip, in the plant's axes.
	godot::Ref<godot::Skin> skin;

	void add_bone(const godot::String &name, int parent, const godot::Vector3 &origin);
	void add_stem();
	int part_index(size_t part) const { return FormBones::FIRST + joints + int(part); }
	int carrier_of(const PartBone &bone) const;
	void update_stem(const StandingStem &standing);
	void place_stem();
	/// `needs_places`: `posed` of the stem's joints is asked for.
	void update(bool needs_places);
};

} // namespace undergrowth
