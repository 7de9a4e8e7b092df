#pragma once

#include "motion/lasting_bends.hpp"
#include "placement/edit_log_bytes.hpp"

#include <map>
#include <vector>

namespace undergrowth {

/// Lasting bends of plants that do not exist now, because their tile is not loaded or because they are not built yet.
/// They recover meanwhile. One thread.
class TroddenPlants {
public:
	/// Lets all plants recover for `seconds` of simulated time.
	void advance(double seconds) { now += seconds; }
	/// Adds a plant with its present bend and the recovery time (s) of its species.
	void put(PlantId id, const glm::vec2 &bend, float recovery);
	/// Removes a plant. Returns its present bend; 0 for unknown plants.
	glm::vec2 take(PlantId id);
	bool is_empty() const { return plants.empty(); }
	int count() const { return static_cast<int>(plants.size()); }
	/// Present bends with ascending ids, without plants that have recovered.
	std::vector<TroddenPlant> all() const;

private:
	struct Trodden {
		glm::vec2 bend;
		float recovery; ///< s.
		double since; ///< s.
	};

	static constexpr std::size_t MIN_CHECK = 1024; ///< Plants.

	std::map<PlantId, Trodden> plants;
	double now = 0.0; ///< s.
	std::size_t next_check = MIN_CHECK; ///< Number of plants at which recovered ones are removed.

	glm::vec2 present(const Trodden &plant) const;
	void remove_recovered();
};

} // namespace undergrowth
