// What CpuMotion is asked of single plants and of all, and what is done to them.

#include "field/cpu_motion.hpp"

using namespace godot;

namespace undergrowth {

void CpuMotion::set_update_interval(int step_count) {
	if (simulation) {
		wait();
		simulation->set_update_interval(step_count);
	}
}

void CpuMotion::fit_contact(bool on) {
	touches = on;
	if (on && simulation) {
		wait();
		touching.fit(*simulation);
	}
}

void CpuMotion::settle() {
	wait();
	is_handed = false;
	simulation->settle();
	write_all();
}

MotionState CpuMotion::read_state_now(const PlantPlace &place) {
	wait();
	const int page = rows_of(place.block).page;
	return { simulation->state(page, row_of(place)), simulation->second(page, row_of(place)) };
}

glm::vec3 CpuMotion::read_tip_now(const PlantPlace &place) {
	wait();
	const PageRows &own = rows_of(place.block);
	const MotionPage &page = simulation->page(own.page);
	return page.swings() ? page.tip(row_of(place)) : simulation->shown_point(own.page, row_of(place), 1.0f, 1.0f);
}

void CpuMotion::write_state(const PlantPlace &place, const MotionState &state) {
	wait();
	is_handed = false;
	simulation->set_state(rows_of(place.block).page, row_of(place), state.tip, state.second);
}

void CpuMotion::apply_impulse(const PlantPlace &place, const glm::vec3 &impulse) {
	wait();
	is_handed = false;
	simulation->apply_impulse(rows_of(place.block).page, row_of(place), impulse);
}

bool CpuMotion::is_point_in_plants_now(const glm::vec3 &point, float margin) {
	wait();
	return simulation && simulation->is_point_in_plants(point, margin);
}

void CpuMotion::set_height(const PlantPlace &place, float share, const MotionPlant &plant) {
	heights.push_back({ place, share, plant });
}

void CpuMotion::set_hidden(const PlantPlace &place, bool hidden) {
	const int page = rows_of(place.block).page;
	if (hidden) {
		textures->hide(page, row_of(place));
	} else {
		textures->show(page, row_of(place));
		stale_pages.push_back(page);
	}
}

} // namespace undergrowth
