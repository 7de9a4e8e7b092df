#pragma once

#include "form/plant_form.hpp"
#include "mesh/form_bones.hpp"
#include "mesh/form_measure.hpp"
#include "mesh/part_attachment.hpp"

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

private:
	mutable std::once_flag is_measured;
	mutable FormMeasure measured;
};

} // namespace undergrowth
