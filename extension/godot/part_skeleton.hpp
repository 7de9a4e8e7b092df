#pragma once

#include "motion/part_bend.hpp"
#include "sampled_plant.hpp"

#include <godot_cpp/classes/skeleton3d.hpp>
#include <godot_cpp/classes/skin.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <memory>
#include <vector>

namespace undergrowth {

/// The bones of one plant of parts beside root and tip, and how they stand now.
class PartSkeleton {
public:
	/// Of a plant as it was sampled for a skeleton; null where it has no such bones.
	static std::unique_ptr<PartSkeleton> of(const SampledPlant &sampled);

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

	/// Tells the node.
	void pose(godot::Skeleton3D *skeleton) const;
	/// Tells the renderer alone; `drawn` is what it has of the skeleton.
	void pose(const godot::RID &drawn) const;

private:
	std::vector<PartBone> bones;
	std::vector<godot::String> names;
	godot::Ref<godot::Skin> skin;

	godot::Transform3D rest(size_t bone) const;
};

} // namespace undergrowth
