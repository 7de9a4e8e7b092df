#include "placement/habitats.hpp"

#include "base/portable_math.hpp"
#include "base/random.hpp"
#include "placement/plant_removal.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace undergrowth {

namespace {

/// Gives habitats their own random numbers.
constexpr uint64_t HABITAT_SEED = 0xBB67AE8584CAA73Bu;
const glm::vec3 UP = { 0.0f, 1.0f, 0.0f };

float slope_of(const glm::vec3 &normal) {
	const double x = normal.x;
	const double z = normal.z;
	return static_cast<float>(portable_atan2(std::sqrt(x * x + z * z), static_cast<double>(normal.y)));
}

AreaBox box_around(const FieldPlants &plants) {
	const auto [low_x, high_x] = std::minmax_element(plants.x.begin(), plants.x.end());
	const auto [low_z, high_z] = std::minmax_element(plants.z.begin(), plants.z.end());
	return { { *low_x, *low_z }, { *high_x, *high_z } };
}

/// The habitats, with the lines near some plants only.
class NearHabitats {
public:
	NearHabitats(const Habitats &of, const HabitatSurvey *of_ground, const FieldPlants &plants) :
			habitats(of), survey(of_ground), lines(of.of_species.size()) {
		const AreaBox box = box_around(plants);
		for (std::size_t i = 0; i < lines.size(); i++) {
			const Habitat *habitat = of.of_species[i].get();
			if (habitat != nullptr && habitat->uses(HabitatFactor::distance) && i < of.lines.size() && of.lines[i]) {
				lines[i] = of.lines[i]->near(box, habitat->curve(HabitatFactor::distance).high);
			}
		}
	}

	double suitability(std::size_t species, const glm::vec2 &root, float height, const glm::vec3 &normal) const {
		const Habitat &habitat = *habitats.of_species[species];
		HabitatPlace place;
		place[HabitatFactor::height] = height;
		if (habitat.uses(HabitatFactor::slope)) {
			place[HabitatFactor::slope] = slope_of(normal);
		}
		if (habitat.uses(HabitatFactor::texture)) {
			place[HabitatFactor::texture] = habitat.texture.at(root);
		}
		if (habitat.uses(HabitatFactor::distance)) {
			const float reach = habitat.curve(HabitatFactor::distance).high;
			place[HabitatFactor::distance] = lines[species].distance_to(root, reach);
		}
		place[HabitatFactor::moisture] = survey != nullptr ? survey->moisture.at(root) : 1.0f;
		place[HabitatFactor::light] = survey != nullptr ? survey->light.at(root) : 1.0f;
		const bool has_value = survey != nullptr && species < survey->values.size();
		place[HabitatFactor::value] =
				has_value ? survey->values[species].at(root, habitat.curve(HabitatFactor::value)) : 1.0f;
		return habitat.suitability(place);
	}

private:
	const Habitats &habitats;
	const HabitatSurvey *survey; ///< May be null.
	std::vector<HabitatLines> lines; ///< By species.
};

} // namespace

bool Habitats::are_any() const {
	return std::any_of(of_species.begin(), of_species.end(), [](const auto &one) { return one != nullptr; });
}

bool Habitats::use(HabitatFactor factor) const {
	return std::any_of(of_species.begin(), of_species.end(),
			[factor](const auto &one) { return one != nullptr && one->uses(factor); });
}

void thin_by_habitats(const Habitats &habitats, const HabitatSurvey *survey, FieldPlants &plants,
		std::vector<float> &heights, std::vector<glm::vec3> &normals) {
	if (plants.size() == 0 || !habitats.are_any()) {
		return;
	}
	const NearHabitats near(habitats, survey, plants);
	const bool has_ground = heights.size() == plants.x.size();
	const bool has_normals = normals.size() == plants.x.size();
	std::vector<int> removed;
	for (std::size_t i = 0; i < plants.x.size(); i++) {
		const std::size_t species = plants.species[i];
		const bool has_height = !has_ground || std::isfinite(heights[i]);
		if (species >= habitats.of_species.size() || !habitats.of_species[species] || !has_height) {
			continue;
		}
		const double suitability = near.suitability(
				species, { plants.x[i], plants.z[i] }, has_ground ? heights[i] : 0.0f, has_normals ? normals[i] : UP);
		const uint64_t bits = bits_of_place(habitats.seed ^ HABITAT_SEED, plants.x[i], plants.z[i]);
		if (!(static_cast<double>(bits >> 32) * (1.0 / 4294967296.0) < suitability)) {
			removed.push_back(static_cast<int>(i));
		}
	}
	remove_plants(removed, plants, heights, normals);
}

} // namespace undergrowth
