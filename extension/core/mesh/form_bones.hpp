#pragma once

#include "mesh/part_hang.hpp"

#include <array>
#include <string>
#include <vector>

namespace undergrowth {

/// The bones of a plant of parts besides root and tip, and the binding of vertices to them. A part that swings has one
/// bone. Its vertices are bound to it by their own weight and to root and tip by the rest. A part longer than LONG has
/// two bones: the weight moves to the first one up to the middle, and from there to the second. A head has one. If more
/// than MOST_OF_TUFT parts swing on the ground, the parts in each eighth of the circle share bones; parts that lie on
/// the ground share bones among themselves.
///
/// The bones are the same for all levels of detail of a form. If bones run out, the smallest parts have none.
class FormBones {
public:
	static constexpr int ROOT = 0;
	static constexpr int TIP = 1;
	static constexpr int FIRST = 2; ///< Index of the first of bones() in the skeleton.
	static constexpr int MOST = 32; ///< Max bones, root and tip included, joints of a stem excluded.
	static constexpr float LONG = 0.25f; ///< m.
	static constexpr int MOST_OF_TUFT = 8;

	/// Without bones of parts: everything is bound to root and tip.
	FormBones() = default;
	/// For all parts of a form.
	FormBones(const PlantForm &form, const std::vector<PartHang> &hangs);

	const std::vector<PartBone> &bones() const { return all; }
	/// "leaf_1", "leaf_1_outer", "head", "tuft_1", "lying_1" …, in the order of bones().
	const std::vector<std::string> &names() const { return all_names; }
	/// The bones of a plant that is stretched along y by `factor`.
	std::vector<PartBone> stretched(float factor) const;

	/// Writes four bones and weights of a vertex; the weights sum to 1 exactly. `stem_offset` and `weight` are the
	/// vertex's own. `swinger` is PartHang::swinger, or -1 for none.
	void bind(int swinger, float stem_offset, float weight, int32_t *bones, float *weights) const;

private:
	std::vector<PartBone> all;
	std::vector<std::string> all_names;
	std::vector<int> first_of; ///< By placed part: index of its first bone, or -1.

	void add(
			const std::string &name, const PlantForm &form, const PlacedPart &part, const PartHang &hang, float weight);
	int add_pair(const std::string &name, const PlantForm &form, const PlacedPart &part, const PartHang &hang);
	void add_heads(const PlantForm &form, const std::vector<PartHang> &hangs, const std::vector<int> &heads);
	void add_tuft(const std::string &name, const PlantForm &form, const std::vector<PartHang> &hangs,
			const std::vector<int> &blades);
	void add_leaves(const PlantForm &form, const std::vector<PartHang> &hangs, std::vector<int> leaves);
	bool has_outer(int bone) const;
};

} // namespace undergrowth
