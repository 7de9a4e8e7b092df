#include "drawn_form.hpp"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>

using namespace undergrowth;

namespace {

constexpr float UNWRITTEN = std::numeric_limits<float>::quiet_NaN();
constexpr float UNIT = 1e-4f;

template <class V> bool is_unit(const V &v) {
	return std::abs(glm::length(glm::vec3(v)) - 1.0f) < UNIT;
}

// Kinds of venation, which CUSTOM0.z contains beside the rank (mesh/vertex_format.hpp).
constexpr float VENATIONS = 5.0f;

bool is_share(float value) {
	return value >= 0.0f && value <= 1.0f;
}

template <class V> bool is_finite(const V &v) {
	for (int i = 0; i < V::length(); i++) {
		if (!std::isfinite(v[i])) {
			return false;
		}
	}
	return true;
}

bool is_code(float value) {
	return value >= -2048.0f && value <= 2047.0f && value == std::floor(value);
}

} // namespace

DrawnForm::DrawnForm(const PlantForm &form, const FormMeasure &measure, const FormPlan &plan, const FormBones &bones,
		const MeshOptions &options, float height) :
		bone_count(FormBones::FIRST + static_cast<int>(bones.bones().size())) {
	const size_t n = static_cast<size_t>(plan.counts.vertices);
	positions.resize(n, glm::vec3(UNWRITTEN));
	normals.resize(n, glm::vec3(UNWRITTEN));
	for (std::vector<glm::vec4> *own : { &tangents, &colors, &custom0, &custom1, &custom2 }) {
		own->resize(n, glm::vec4(UNWRITTEN));
	}
	uvs.resize(n, glm::vec2(UNWRITTEN));
	bone_indices.resize(4 * n, -1);
	weights.resize(4 * n, UNWRITTEN);
	stem_places.resize(n);
	indices.resize(static_cast<size_t>(plan.counts.indices), -1);
	build_form_mesh(form, measure, plan, bones, options, height,
			{ positions.data(), normals.data(), tangents.data(), colors.data(), uvs.data(), custom0.data(),
					custom1.data(), custom2.data(), bone_indices.data(), weights.data(), indices.data(),
					stem_places.data() });
}

std::string DrawnForm::problem() const {
	if (positions.empty() || indices.empty()) {
		return "nothing is drawn";
	}
	for (const int32_t index : indices) {
		if (index < 0 || index >= static_cast<int32_t>(positions.size())) {
			return "index " + std::to_string(index) + " of " + std::to_string(positions.size()) + " vertices";
		}
	}
	for (size_t i = 0; i < positions.size(); i++) {
		const std::string wrong = problem_of(i);
		if (!wrong.empty()) {
			return "vertex " + std::to_string(i) + ": " + wrong;
		}
	}
	return {};
}

std::string DrawnForm::problem_of(size_t i) const {
	if (!is_finite(positions[i])) {
		return "its position is not finite";
	}
	if (!is_unit(normals[i]) || !is_unit(tangents[i]) || tangents[i].w != 1.0f) {
		return "its normal or tangent is not of length 1";
	}
	if (!is_finite(colors[i]) || !is_share(colors[i].w) || !is_finite(uvs[i])) {
		return "its colour or UV is not finite";
	}
	const glm::vec4 &attachment = custom0[i];
	if (!is_share(attachment.x) || !is_share(attachment.y) || !is_share(attachment.w)) {
		return "CUSTOM0 holds no shares";
	}
	if (!(attachment.z >= 0.0f && attachment.z < VENATIONS)) {
		return "its rank and venation are no code";
	}
	if (!is_finite(glm::vec3(custom1[i])) || !is_code(custom1[i].w)) {
		return "its pivot or pace is not finite";
	}
	if (!is_finite(glm::vec3(custom2[i])) || !is_code(custom2[i].w)) {
		return "its way from the midrib or its phase is not finite";
	}
	return problem_of_weights(i);
}

std::string DrawnForm::problem_of_weights(size_t i) const {
	const float *own = weights.data() + 4 * i;
	if (!(own[0] + own[1] + own[2] + own[3] == 1.0f)) {
		return "its weights do not sum to 1";
	}
	for (size_t k = 0; k < 4; k++) {
		const int32_t bone = bone_indices[4 * i + k];
		if (!is_share(own[k]) || bone < 0 || bone >= bone_count) {
			return "it is bound to a bone that is not there";
		}
	}
	return {};
}
