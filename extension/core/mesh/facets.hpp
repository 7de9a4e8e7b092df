#pragma once

#include "mesh/form_plan.hpp"

namespace undergrowth {

/// Returns how far the drawn edges of blades are from their true ones (m): of the worst row of the worst kind, its
/// mean. It is visible as straight edges and corners. Kinds with little area do not count.
float facets_of(const PlantForm &form, const FormPlan &plan);

} // namespace undergrowth
