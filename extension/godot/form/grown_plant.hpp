#pragma once

#include "form/plant_form.hpp"
#include "mesh/form_bones.hpp"
#include "mesh/form_measure.hpp"

namespace undergrowth {

/// A plant of parts that has grown: the same at all levels of detail, and shared by them.
struct GrownPlant {
	PlantForm form;
	FormMeasure measure;
	FormBones bones;
};

} // namespace undergrowth
