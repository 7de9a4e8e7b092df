#include "mesh/form_bones.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace undergrowth {

namespace {

constexpr int SECTORS = 8;
constexpr float MORE_THAN_OWN = 0.05f; // Fraction of the stem's bend.
constexpr float LYING = 0.1f; // Bend: a part with less room than this cannot move as far as the parts beside it.
constexpr float EXACT = 65536.0f; // Sums of multiples of 1 / EXACT are exact.

float exact(float weight) {
	return std::floor(weight * EXACT + 0.5f) / EXACT;
}

int sector_of(const glm::vec2 &side) {
	const double turn = portable_atan2(side.y, side.x) / (2.0 * PI);
	return (static_cast<int>(std::floor(turn * SECTORS + 0.5)) + SECTORS) % SECTORS;
}

float size_of(const PlacedPart &part) {
	return part.length * part.width;
}

} // namespace

FormBones::FormBones(const PlantForm &form, const std::vector<PartAttachment> &attachments) :
		first_of(form.placed.size(), -1) {
	std::vector<int> heads, blades, lying, leaves;
	for (size_t i = 0; i < attachments.size(); i++) {
		const PartAttachment &attachment = attachments[i];
		if (attachment.swinger == static_cast<int>(i)) {
			std::vector<int> &ground = attachment.swing.room < LYING ? lying : blades;
			(attachment.swing.is_head() ? heads : attachment.is_root ? ground : leaves).push_back(static_cast<int>(i));
		}
	}
	add_heads(form, attachments, heads);
	if (blades.size() + lying.size() > MAX_TUFT_BONES) {
		add_tuft("tuft_", form, attachments, blades);
		add_tuft("lying_", form, attachments, lying);
	} else {
		leaves.insert(leaves.end(), blades.begin(), blades.end());
		leaves.insert(leaves.end(), lying.begin(), lying.end());
	}
	add_leaves(form, attachments, std::move(leaves));
	add_inner(form, attachments);
}

FormBones::FormBones(std::vector<PartBone> &&bones, std::vector<std::string> &&names) :
		all(std::move(bones)), all_names(std::move(names)), first_of(all.size()) {
	std::iota(first_of.begin(), first_of.end(), 0);
}

void FormBones::add_heads(
		const PlantForm &form, const std::vector<PartAttachment> &attachments, const std::vector<int> &heads) {
	for (const int head : heads) {
		if (all.size() < MAX_BONES - FIRST) {
			first_of[static_cast<size_t>(head)] = static_cast<int>(all.size());
			const std::string number = heads.size() == 1 ? "" : "_" + std::to_string(all.size() + 1);
			add("head" + number, form, form.placed[static_cast<size_t>(head)], attachments[static_cast<size_t>(head)],
					1.0f);
		}
	}
}

void FormBones::add_leaves(
		const PlantForm &form, const std::vector<PartAttachment> &attachments, std::vector<int> leaves) {
	std::stable_sort(leaves.begin(), leaves.end(), [&form](int a, int b) {
		return size_of(form.placed[static_cast<size_t>(a)]) > size_of(form.placed[static_cast<size_t>(b)]);
	});
	int number = 0;
	for (const int leaf : leaves) {
		const PlacedPart &part = form.placed[static_cast<size_t>(leaf)];
		first_of[static_cast<size_t>(leaf)] =
				add_pair("leaf_" + std::to_string(++number), form, part, attachments[static_cast<size_t>(leaf)]);
	}
}

void FormBones::add_inner(const PlantForm &form, const std::vector<PartAttachment> &attachments) {
	std::vector<int> all_inner;
	for (size_t i = 0; i < attachments.size(); i++) {
		const PartAttachment &attachment = attachments[i];
		const bool is_first = attachment.inner_count == 1 && attachment.inner[0].swings;
		if (is_first && first_of[static_cast<size_t>(attachment.swinger)] >= 0) {
			all_inner.push_back(static_cast<int>(i));
		}
	}
	const auto is_before = [&form](int a, int b) {
		const PlacedPart &one = form.placed[static_cast<size_t>(a)];
		const PlacedPart &other = form.placed[static_cast<size_t>(b)];
		const auto is_blade = [&form](const PlacedPart &part) {
			return form.parts[static_cast<size_t>(part.kind)].kind != PartKind::axis;
		};
		return is_blade(one) != is_blade(other) ? is_blade(other) : size_of(one) > size_of(other);
	};
	std::stable_sort(all_inner.begin(), all_inner.end(), is_before);
	all_inner.resize(std::min(all_inner.size(), static_cast<size_t>(MAX_INNER_BONES)));
	int number = 0;
	for (const int part : all_inner) {
		const PartAttachment &attachment = attachments[static_cast<size_t>(part)];
		const InnerSwing &inner = attachment.inner[0];
		first_of[static_cast<size_t>(part)] = static_cast<int>(all.size());
		PartBone bone;
		bone.origin = bone.pivot = inner.pivot;
		bone.stem_offset = attachment.stem_offset;
		bone.weight = 1.0f;
		bone.swing = inner.swing;
		bone.carried_by = bone_at(first_of[static_cast<size_t>(attachment.swinger)], attachment.weight);
		bone.carrier = { attachment.pivot, attachment.weight, attachment.swing };
		all.push_back(bone);
		all_names.push_back("twig_" + std::to_string(++number));
	}
}

/// The parts in one sector share the bones of the largest part.
void FormBones::add_tuft(const std::string &name, const PlantForm &form, const std::vector<PartAttachment> &attachments,
		const std::vector<int> &blades) {
	std::array<int, SECTORS> largest;
	largest.fill(-1);
	for (const int blade : blades) {
		int &found = largest[static_cast<size_t>(sector_of(attachments[static_cast<size_t>(blade)].swing.side))];
		const PlacedPart &part = form.placed[static_cast<size_t>(blade)];
		if (found < 0 || size_of(part) > size_of(form.placed[static_cast<size_t>(found)])) {
			found = blade;
		}
	}
	std::array<int, SECTORS> bones;
	for (size_t i = 0; i < SECTORS; i++) {
		const size_t of = static_cast<size_t>(std::max(largest[i], 0));
		bones[i] = largest[i] < 0 ? -1 : add_pair(name + std::to_string(i + 1), form, form.placed[of], attachments[of]);
	}
	for (const int blade : blades) {
		first_of[static_cast<size_t>(blade)] =
				bones[static_cast<size_t>(sector_of(attachments[static_cast<size_t>(blade)].swing.side))];
	}
}

int FormBones::add_pair(
		const std::string &name, const PlantForm &form, const PlacedPart &part, const PartAttachment &attachment) {
	const bool is_long = part.length > LONG && all.size() + 2 <= MAX_BONES - FIRST;
	if (all.size() >= MAX_BONES - FIRST) {
		return -1;
	}
	const int first = static_cast<int>(all.size());
	add(name, form, part, attachment, is_long ? 0.5f : 1.0f);
	if (is_long) {
		add(name + "_outer", form, part, attachment, 1.0f);
		all.back().origin = form.point_of(part, 0.5f);
		all.back().outer_of = first;
	}
	return first;
}

void FormBones::add(const std::string &name, const PlantForm &form, const PlacedPart &part,
		const PartAttachment &attachment, float weight) {
	PartBone bone;
	bone.origin = bone.pivot = attachment.pivot;
	bone.stem_offset = attachment.is_root ? stem_offset_of(form, form.point_of(part, weight)) : attachment.stem_offset;
	bone.weight = weight;
	bone.swing = attachment.swing;
	all.push_back(bone);
	all_names.push_back(name);
}

std::vector<PartBone> FormBones::stretched(float factor) const {
	std::vector<PartBone> bones = all;
	for (PartBone &bone : bones) {
		bone.origin.y *= factor;
		bone.pivot.y *= factor;
		bone.carrier.pivot.y *= factor;
	}
	return bones;
}

bool FormBones::has_outer(int bone) const {
	const size_t next = static_cast<size_t>(bone) + 1;
	return next < all.size() && all[next].outer_of == bone;
}

// A twig shares a vertex between its own bone and one of its branch, which have the stem's bend of the vertex.
void FormBones::bind(
		const PartAttachment &attachment, float stem_offset, float offset, int32_t *bones, float *weights) const {
	const InnerSwing &inner = attachment.inner[0];
	const int twig =
			attachment.inner_count == 0 || first_of.empty() ? -1 : first_of[static_cast<size_t>(inner.swinger)];
	if (twig < 0) {
		bind(attachment.swinger, stem_offset, attachment.weight_at(offset), bones, weights);
		return;
	}
	const int branch = bone_at(first_of[static_cast<size_t>(attachment.swinger)], attachment.weight);
	const float of_branch = attachment.weight / all[static_cast<size_t>(branch)].weight;
	weights[2] = exact(inner.weight_at(offset));
	weights[3] = exact((1.0f - weights[2]) * std::min(of_branch, 1.0f));
	const float room = 1.0f - weights[2] - weights[3];
	weights[1] = exact(room * stem_offset);
	weights[0] = room - weights[1];
	bones[0] = ROOT;
	bones[1] = TIP;
	bones[2] = FIRST + twig;
	bones[3] = FIRST + branch;
}

// The tip bone adds the stem's bend that part bones do not, so that a plant without swing bends as without bones.
void FormBones::bind(int swinger, float stem_offset, float weight, int32_t *bones, float *weights) const {
	const int first = swinger < 0 || first_of.empty() ? -1 : first_of[static_cast<size_t>(swinger)];
	std::fill(bones, bones + 4, ROOT);
	std::fill(weights, weights + 4, 0.0f);
	bones[1] = TIP;
	if (first < 0) {
		weights[0] = 1.0f - stem_offset;
		weights[1] = stem_offset;
		return;
	}
	const bool is_pair = has_outer(first);
	const float outer = is_pair ? std::max(2.0f * weight - 1.0f, 0.0f) : 0.0f;
	const float inner = is_pair ? std::min(2.0f * weight, 2.0f - 2.0f * weight) : weight;
	const float of_inner = all[static_cast<size_t>(first)].stem_offset;
	const float of_outer = all[static_cast<size_t>(first + (is_pair ? 1 : 0))].stem_offset;
	// A low vertex uses bones of higher parts only as far as the stem moves it.
	const float max = (stem_offset + MORE_THAN_OWN) / std::max(inner * of_inner + outer * of_outer, MORE_THAN_OWN);
	weights[2] = exact(inner * std::min(max, 1.0f));
	weights[3] = std::min(exact(outer * std::min(max, 1.0f)), 1.0f - weights[2]);
	const float room = 1.0f - weights[2] - weights[3];
	const float taken = weights[2] * of_inner + weights[3] * of_outer;
	weights[1] = std::clamp(exact(stem_offset - taken), 0.0f, room);
	weights[0] = room - weights[1];
	bones[2] = FIRST + first;
	bones[3] = is_pair ? FIRST + first + 1 : ROOT;
}

} // namespace undergrowth
