#include "model/model_bones.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace undergrowth {

namespace {

constexpr int BANDS = 4; // Of shared bones along the height.
constexpr int SECTORS = 7;
constexpr size_t MAX = FormBones::MAX_BONES - FormBones::FIRST;

PartBone bone_of(const ModelPart &part, float height) {
	PartBone bone;
	bone.origin = bone.pivot = part.pivot;
	bone.stem_offset = part.stem_offset_of(part.swings ? part.tip : part.pivot, height);
	bone.weight = 1.0f;
	bone.swing = part.swing;
	return bone;
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

FormBones make_model_bones(
		const std::vector<ModelPart> &parts, const ModelIslands &islands, float height, std::vector<int> &swingers) {
	std::vector<bool> is_swinger(parts.size(), false);
	for (const ModelPart &part : parts) {
		if (part.swinger >= 0) {
			is_swinger[static_cast<size_t>(part.swinger)] = true;
		}
	}
	const bool are_shared = static_cast<size_t>(std::count(is_swinger.begin(), is_swinger.end(), true)) > MAX;
	std::vector<PartBone> bones;
	std::vector<float> sizes;
	std::map<std::pair<int, int>, int> known;
	swingers.assign(parts.size(), -1);
	for (size_t i = 0; i < parts.size(); i++) {
		if (parts[i].swinger < 0) {
			continue;
		}
		const std::pair<int, int> own(parts[i].swinger, -1);
		const std::pair<int, int> place = are_shared ? place_of(parts[i], height) : own;
		if (bones.size() == MAX && known.count(place) == 0) {
			continue;
		}
		const auto [entry, is_new] = known.emplace(place, static_cast<int>(bones.size()));
		swingers[i] = entry->second;
		if (is_new) {
			bones.push_back(bone_of(parts[i], height));
			sizes.push_back(islands.islands[i].area);
		} else if (are_shared && islands.islands[i].area > sizes[static_cast<size_t>(entry->second)]) {
			bones[static_cast<size_t>(entry->second)] = bone_of(parts[i], height); // That of the largest part.
			sizes[static_cast<size_t>(entry->second)] = islands.islands[i].area;
		}
	}
	std::vector<std::string> names;
	int leaves = 0, heads = 0;
	for (const PartBone &bone : bones) {
		const bool is_head = bone.swing.is_head();
		names.push_back((is_head ? "head_" : "leaf_") + std::to_string(is_head ? ++heads : ++leaves));
	}
	return FormBones(std::move(bones), std::move(names));
}

} // namespace undergrowth
