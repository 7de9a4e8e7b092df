#pragma once

#include "mesh/part_hang.hpp"

#include <array>
#include <string>
#include <vector>

namespace undergrowth {

/// The bones of a plant of parts beside root and tip, and what is bound to them. A part that swings has one, of which
/// its vertices take the share of their own weight; the rest goes to root and tip. A part longer than LONG has two:
/// up to its middle vertices go over to the first, from there on to the second. A head has one. Where more than
/// MOST_OF_TUFT parts swing on the ground, those of an eighth of the circle share theirs, the ones that lie
/// on the ground among themselves.
///
/// The same for all levels of detail of a form. Where bones run out, the smallest parts have none.
class FormBones {
public:
	static constexpr int ROOT = 0;
	static constexpr int TIP = 1;
	static constexpr int FIRST = 2; ///< Index in the skeleton of the first of bones().
	static constexpr int MOST = 32; ///< Root and tip included, joints of a stem not.
	static constexpr float LONG = 0.25f; ///< m.
	static constexpr int MOST_OF_TUFT = 8;

	/// None: everything is bound to root and tip.
	FormBones() = default;
	/// Of all parts of a form.
	FormBones(const PlantForm &form, const std::vector<PartHang> &hangs);

	const std::vector<PartBone> &bones() const { return all; }
	/// "leaf_1", "leaf_1_outer", "head", "tuft_1", "lying_1" …, as many.
	const std::vector<std::string> &names() const { return all_names; }
	/// As they are for a plant that is stretched along y by `factor`.
	std::vector<PartBone> stretched(float factor) const;

	/// Four bones and weights of a vertex; weights sum to 1 exactly. `stem_offset` and `weight` are its own. Swinger:
	/// PartHang::swinger, -1 for none.
	void bind(int swinger, float stem_offset, float weight, int32_t *bones, float *weights) const;

private:
	std::vector<PartBone> all;
	std::vector<std::string> all_names;
	std::vector<int> first_of; ///< By placed part: the index of its first bone, or -1.

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
