#include "mesh/facets.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace undergrowth {

namespace {

constexpr float MIN_AREA = 0.1f; // Of the plant.
constexpr int SAMPLES = 32;
constexpr float MEAN_SHARE = 0.6f; // About the mean distance along a row, as a share of the largest one.

/// Returns the largest difference of the drawn width, as a fraction of the part's width.
float width_error(const Part &part, const PartDetail &detail) {
	const std::vector<float> offsets = row_offsets(part, detail);
	float error = 0.0f;
	for (size_t row = 0; row + 1 < offsets.size(); row++) {
		const float from = offsets[row];
		const float to = offsets[row + 1];
		const bool is_point = row + 2 == offsets.size() && ends_in_point(part);
		const float start = part.width_at(from);
		const float end = is_point ? 0.0f : part.width_at(to);
		for (int i = 1; i < SAMPLES; i++) {
			const float share = static_cast<float>(i) / static_cast<float>(SAMPLES);
			const float width = part.width_at(from + (to - from) * share);
			error = std::max(error, std::abs(width - (start + (end - start) * share)));
		}
	}
	return error;
}

bool is_drawn(const FormPlan &plan, const PartGroup &group) {
	const auto begin = plan.fates.begin() + group.first;
	return std::find(begin, begin + group.count, FormPlan::drawn) != begin + group.count;
}

} // namespace

float facets_of(const PlantForm &form, const FormPlan &plan) {
	const float area = std::accumulate(plan.shown.begin(), plan.shown.end(), 0.0f);
	std::vector<float> areas(form.parts.size(), 0.0f);
	for (size_t g = 0; g < form.groups.size(); g++) {
		areas[static_cast<size_t>(form.groups[g].kind)] += plan.shown[g];
	}
	float error = 0.0f;
	for (size_t g = 0; g < form.groups.size(); g++) {
		const PartGroup &group = form.groups[g];
		const Part &part = form.parts[static_cast<size_t>(group.kind)];
		const PartDetail &detail = plan.groups[g].detail;
		const bool counts = part.kind == PartKind::blade && areas[static_cast<size_t>(group.kind)] >= MIN_AREA * area;
		if (counts && is_drawn(plan, group) && !is_spike(part, detail)) {
			error = std::max(error, MEAN_SHARE * 0.5f * part.width * width_error(part, detail));
		}
	}
	return error;
}

} // namespace undergrowth
