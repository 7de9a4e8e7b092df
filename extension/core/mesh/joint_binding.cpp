#include "mesh/joint_binding.hpp"

#include "mesh/form_bones.hpp"
#include "stem/stem_bones.hpp"

#include <algorithm>
#include <array>

namespace undergrowth {

namespace {

struct Influence {
	int32_t bone = 0;
	float weight = 0.0f;
};

constexpr int STORED_INFLUENCES = 4;
constexpr int MAX_INFLUENCES = STORED_INFLUENCES + 2;

} // namespace

static void bind_vertex(int joints, const float *place, int32_t *bones, float *weights) {
	const float of_stem = weights[0] + weights[1];
	const float by_tip = of_stem > 0.0f ? weights[1] / of_stem : 0.0f;
	const float x = place != nullptr ? *place : by_tip;
	const StemBinding stem = bind_to_stem(joints, x);
	std::array<Influence, MAX_INFLUENCES> all;
	for (size_t i = 0; i < STORED_INFLUENCES; i++) {
		const int link = stem.bones[i];
		all[i] = { link == 0 ? FormBones::ROOT : FormBones::TIP + link, stem.weights[i] * of_stem };
	}
	for (size_t i = 0; i < 2; i++) { // Bones of parts; a bone without weight may be any.
		all[STORED_INFLUENCES + i] = { weights[2 + i] > 0.0f ? bones[2 + i] + joints : FormBones::ROOT,
			weights[2 + i] };
	}
	std::stable_sort(
			all.begin(), all.end(), [](const Influence &a, const Influence &b) { return a.weight > b.weight; });
	float sum = 0.0f;
	for (size_t i = 0; i < STORED_INFLUENCES; i++) {
		sum += all[i].weight;
	}
	for (size_t i = 0; i < STORED_INFLUENCES; i++) {
		bones[i] = all[i].bone;
		weights[i] = all[i].weight / sum;
	}
}

void bind_to_joints(int joints, int vertices, const float *places, int32_t *bones, float *weights) {
	for (int i = 0; i < vertices; i++) {
		bind_vertex(joints, places != nullptr ? places + i : nullptr, bones + 4 * i, weights + 4 * i);
	}
}

} // namespace undergrowth
