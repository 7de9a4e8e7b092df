#pragma once

#include "form/plant_form.hpp"
#include "mesh/form_bones.hpp"
#include "mesh/form_measure.hpp"
#include "mesh/part_attachment.hpp"

#include <functional>
#include <map>
#include <mutex>
#include <utility>

namespace undergrowth {

/// A generated plant of parts. All levels of detail share it.
class GrownPlant {
public:
	const PlantForm form;
	const FormBones bones;

	explicit GrownPlant(PlantForm &&grown) : form(std::move(grown)), bones(form, attach_parts(form)) {}

	/// Measured by the first build of a mesh, on any thread.
	const FormMeasure &measure() const {
		std::call_once(is_measured, [this] { measured = measure_form(form); });
		return measured;
	}

	/// Returns the error of the outline at a level with `segments` (m). `measure` runs once for each number of
	/// segments. Any thread.
	float level_error(int segments, const std::function<float()> &measure) const {
		const std::lock_guard<std::mutex> lock(measuring);
		const auto known = level_errors.find(segments);
		return known != level_errors.end() ? known->second : level_errors.emplace(segments, measure()).first->second;
	}

private:
	mutable std::mutex measuring;
	mutable std::map<int, float> level_errors; ///< m, by segments.
	mutable std::once_flag is_measured;
	mutable FormMeasure measured;
};

} // namespace undergrowth
