#pragma once

#include "mesh/part_attachment.hpp"

#include <array>
#include <string>
#include <vector>

namespace undergrowth {

/// The bones of a plant of parts besides root and tip, and the binding of vertices. The same for all levels of detail
/// of a form.
///
/// A swinging part has one bone. It gets the fraction of a vertex that is the vertex's own weight; root and tip get the
/// rest. A part longer than LONG has two bones: weights grow towards the first up to its middle and shift to the second
/// from there. A head has one bone. A twig or leaf on a part with a bone may have one, too, up to MAX_INNER_BONES in
/// all: the axes first, the largest first. If more than MAX_TUFT_BONES parts swing on the ground, the parts in each
/// eighth of the circle share bones. Parts that lie on the ground share their own. If there are too many bones, the
/// smallest parts have none.
class FormBones {
public:
	static constexpr int ROOT = 0;
	static constexpr int TIP = 1;
	static constexpr int FIRST = 2; ///< Skeleton index of bones()[0].
	static constexpr int MAX_BONES = 32; ///< Includes root and tip, excludes joints of a stem.
	static constexpr int MAX_INNER_BONES = 32; ///< More, of parts on swinging parts.
	static constexpr float LONG = 0.25f; ///< m.
	static constexpr int MAX_TUFT_BONES = 8;

	/// No bones: all vertices are bound to root and tip.
	FormBones() = default;
	/// Bones for all parts of a form.
	FormBones(const PlantForm &form, const std::vector<PartAttachment> &attachments);
	/// Bones of a plant without a form: bone i is that of swinger i.
	FormBones(std::vector<PartBone> &&bones, std::vector<std::string> &&names);

	const std::vector<PartBone> &bones() const { return all; }
	/// "leaf_1", "leaf_1_outer", "head", "tuft_1", "lying_1" …, as many as bones().
	const std::vector<std::string> &names() const { return all_names; }
	/// Returns the bones of a plant that is stretched along y by `factor`.
	std::vector<PartBone> stretched(float factor) const;

	/// Writes four bones and weights of a vertex; the weights sum to 1 exactly. `stem_offset` and `weight` are the
	/// vertex's own. `swinger`: PartAttachment::swinger, -1 for none.
	void bind(int swinger, float stem_offset, float weight, int32_t *bones, float *weights) const;
	/// The same for a vertex of a part at `offset` of it. Vertices of inner swings use the bones of the outermost one
	/// that has some.
	void bind(const PartAttachment &attachment, float stem_offset, float offset, int32_t *bones, float *weights) const;

private:
	std::vector<PartBone> all;
	std::vector<std::string> all_names;
	std::vector<int> first_of; ///< By placed part: index of its first bone, or -1.

	void add(const std::string &name, const PlantForm &form, const PlacedPart &part, const PartAttachment &attachment,
			float weight);
	int add_pair(
			const std::string &name, const PlantForm &form, const PlacedPart &part, const PartAttachment &attachment);
	void add_heads(
			const PlantForm &form, const std::vector<PartAttachment> &attachments, const std::vector<int> &heads);
	void add_tuft(const std::string &name, const PlantForm &form, const std::vector<PartAttachment> &attachments,
			const std::vector<int> &blades);
	void add_leaves(const PlantForm &form, const std::vector<PartAttachment> &attachments, std::vector<int> leaves);
	void add_inner(const PlantForm &form, const std::vector<PartAttachment> &attachments);
	bool has_outer(int bone) const;
	/// The bone for a place with this weight on the part whose first bone is `first`.
	int bone_at(int first, float weight) const { return has_outer(first) && weight > 0.5f ? first + 1 : first; }
};

} // namespace undergrowth
