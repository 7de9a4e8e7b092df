#pragma once

#include "form/plant_form.hpp"

#include <vector>

namespace undergrowth {

/// Returns for each kind of part the factor of its declared frequency in a plant whose branches carry branches, from
/// the modes of one branch of each group (find_branch_modes()): a branch is slower because its twigs swing, too. 1 for
/// kinds that are no branches. All parts count as equally dense, and blades as 0.25 mm thick.
std::vector<float> branch_frequency_factors(const PlantForm &form);

} // namespace undergrowth
