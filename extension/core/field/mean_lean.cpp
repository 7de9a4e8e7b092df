#include "field/mean_lean.hpp"

#include "field/field_simulation.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

float lean_of(const FieldSimulation &simulation, int page, int index) {
	const MotionPage &plants = simulation.page(page);
	const float length = plants.length(index);
	const glm::vec3 calm = plants.root(index) + length * simulation.rest(page, index);
	const glm::vec3 away = simulation.shown_point(page, index, 1.0f, 1.0f) - calm;
	return length > 0.0f ? std::sqrt(away.x * away.x + away.z * away.z) / length : 0.0f;
}

} // namespace

void MeanLean::follow(const FieldSimulation &simulation) {
	const double now = simulation.time();
	if (now == last_time || simulation.page_count() == 0) {
		return;
	}
	last_time = now;
	species.resize(static_cast<std::size_t>(simulation.species_count()));
	const int samples = std::clamp(simulation.row_count() / PLANTS_PER_SAMPLE, MIN_SAMPLES, MAX_SAMPLES);
	for (int i = 0; i < samples; i++) {
		page = (page + 1) % static_cast<std::size_t>(simulation.page_count());
		turn = turn * 1664525u + 1013904223u;
		const MotionPage &plants = simulation.page(static_cast<int>(page));
		const int index = plants.size() > 0 ? static_cast<int>((turn >> 8) % static_cast<unsigned>(plants.size())) : -1;
		if (index >= 0 && !plants.is_gone(index)) {
			Species &own = species[static_cast<std::size_t>(plants.species())];
			own.sum += static_cast<double>(lean_of(simulation, static_cast<int>(page), index));
			own.count++;
		}
	}
	for (Species &own : species) {
		if (own.count == 0) {
			continue;
		}
		own.calls++;
		const double weight = std::max(1.0 - std::exp(-(now - own.measured_at) / MEMORY), 1.0 / own.calls);
		own.mean += std::min(weight, 1.0) * (own.sum / own.count - own.mean);
		own.measured_at = now;
		own.sum = 0.0;
		own.count = 0;
	}
}

float MeanLean::of(int index) const {
	const auto known = static_cast<std::size_t>(index);
	return known < species.size() ? static_cast<float>(species[known].mean) : 0.0f;
}

} // namespace undergrowth
