#include "model/model_bones.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace undergrowth {

namespace {

constexpr int BANDS = 4; // Of shared bones along the height.
constexpr int SECTORS = 7;
constexpr float FAR = 2.0f; // Per length: parts this far from the pivot of their bone swing by half.
constexpr float BASE = 0.06f; // Offset on the stem below which vertices are held.
constexpr size_t MAX = FormBones::MAX_BONES - FormBones::FIRST;

/// Parts with one swing on a skeleton.
struct Group {
	const ModelPart *part; // The largest one.
	float area; // m², of that part.
};

PartBone bone_of(const ModelPart &part, float height) {
	PartBone bone;
	bone.origin = bone.pivot = part.pivot;
	bone.stem_offset = part.stem_offset_of(part.swings ? part.tip : part.pivot, height);
	bone.weight = 1.0f;
	bone.swing = part.swing;
	return bone;
}

FormBones bones_of(const std::vector<Group> &groups, float height) {
	std::vector<PartBone> bones;
	std::vector<std::string> names;
	int leaves = 0, heads = 0;
	for (const Group &group : groups) {
		bones.push_back(bone_of(*group.part, height));
		const bool is_head = group.part->swing.is_head();
		names.push_back(is_head ? "head_" + std::to_string(++heads) : "leaf_" + std::to_string(++leaves));
	}
	return FormBones(std::move(bones), std::move(names));
}

// Parts of a head have one place, so that they share a bone.
std::pair<int, int> place_of(const ModelPart &part, float height) {
	if (part.swing.is_head()) {
		return { BANDS, part.swinger };
	}
	const double turn = portable_atan2(part.swing.side.y, part.swing.side.x) / (2.0 * PI);
	const int sector = (static_cast<int>(std::floor(turn * SECTORS + 0.5)) + SECTORS) % SECTORS;
	const int band = std::clamp(static_cast<int>(part.pivot.y / height * BANDS), 0, BANDS - 1);
	return { band, sector };
}

} // namespace

FormBones make_model_bones(const std::vector<ModelPart> &parts, const ModelIslands &islands, float height,
		std::vector<ModelSwinger> &swingers) {
	std::set<int> different;
	for (const ModelPart &part : parts) {
		different.insert(part.swinger);
	}
	different.erase(-1);
	const bool are_shared = different.size() > MAX;
	std::vector<Group> groups;
	std::map<std::pair<int, int>, int> known;
	swingers.assign(parts.size(), ModelSwinger());
	for (size_t i = 0; i < parts.size(); i++) {
		const std::pair<int, int> own(parts[i].swinger, -1);
		const std::pair<int, int> place = are_shared ? place_of(parts[i], height) : own;
		if (parts[i].swinger < 0 || (groups.size() == MAX && known.count(place) == 0)) {
			continue;
		}
		const auto [entry, is_new] = known.emplace(place, static_cast<int>(groups.size()));
		const float area = islands.islands[i].area;
		swingers[i].number = entry->second;
		if (is_new) {
			groups.push_back({ &parts[i], area });
		} else if (area > groups[static_cast<size_t>(entry->second)].area) {
			groups[static_cast<size_t>(entry->second)] = { &parts[i], area };
		}
	}
	for (size_t i = 0; i < parts.size(); i++) {
		if (swingers[i].number >= 0) {
			const float away =
					glm::distance(parts[i].pivot, groups[static_cast<size_t>(swingers[i].number)].part->pivot);
			const float arm = FAR * away / std::max(parts[i].length(), 1e-6f);
			swingers[i].share = 1.0f / (1.0f + arm * arm);
		}
	}
	return bones_of(groups, height);
}

void hold_base(int vertices, const float *places, int32_t *bones, float *weights) {
	for (int i = 0; i < vertices; i++) {
		if (places[i] >= BASE) {
			continue;
		}
		int32_t *const own = bones + 4 * i;
		float *const shares = weights + 4 * i;
		int slot = static_cast<int>(std::find(own, own + 4, static_cast<int32_t>(FormBones::ROOT)) - own);
		slot = slot < 4 ? slot : static_cast<int>(std::min_element(shares, shares + 4) - shares);
		float moved = 0.0f;
		for (int k = 0; k < 4; k++) {
			if (k != slot) {
				shares[k] *= std::max(places[i], 0.0f) / BASE;
				moved += shares[k];
			}
		}
		own[slot] = FormBones::ROOT;
		shares[slot] = 1.0f - moved;
	}
}

} // namespace undergrowth
