#pragma once

#include "placement/habitat.hpp"
#include "placement/habitat_lines.hpp"
#include "placement/habitat_survey.hpp"
#include "placement/plants.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace undergrowth {

/// The habitats of a field's species. Its parts do not change, so that copies share them.
struct Habitats {
	/// By species; null: everywhere.
	std::vector<std::shared_ptr<const Habitat>> of_species;
	std::vector<std::shared_ptr<const HabitatLines>> lines; ///< By species; null: none.
	uint64_t seed = 0;

	/// True if some species has a habitat.
	bool are_any() const;
	/// True if some habitat uses the factor.
	bool use(HabitatFactor factor) const;
};

/// Removes plants where their species' habitat is not suitable. Each position has one random number: a habitat that is
/// more suitable everywhere only adds plants. `heights` (m; NaN: no ground, the plant stays) and `normals` have one
/// entry per plant, or none for a field without ground, and lose those of removed plants, too. The result for a plant
/// does not depend on the other plants. `survey` may be null.
void thin_by_habitats(const Habitats &habitats, const HabitatSurvey *survey, FieldPlants &plants,
		std::vector<float> &heights, std::vector<glm::vec3> &normals);

} // namespace undergrowth
