// What PlantField3D does for tools: it moves under a wind that is tried out where it does not move by itself.

#include "field/plant_field_3d.hpp"

#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr double MOST_FRAME = 3600.0; // s.

bool PlantField3D::may_preview() const {
	return simulation && simulation->plant_count() > 0 && !may_simulate();
}

// Called in every frame, as Plant3D::preview(): what cannot move stays still without a word.
void PlantField3D::preview(double delta, const Ref<PlantWind> &blowing) {
	if (!std::isfinite(delta) || delta < 0.0 || delta > MOST_FRAME || !may_preview()) {
		return;
	}
	finish_step();
	const int step_count = clock.advance(delta);
	shown_alpha = clock.alpha();
	if (step_count > 0) {
		const double now = blowing.is_valid() ? blowing->get_time() : 0.0;
		simulation->set_wind(wind_here(blowing, now - step_count * clock.step() - simulation->time()));
		simulation->set_bodies(nullptr, 0);
	}
	for (int i = 0; i < step_count; i++) {
		steps.start(*simulation, *bends, nullptr, worker_count());
	}
	finish_step();
	upload();
	pose_skeletons();
}

void PlantField3D::reset() {
	if (!simulation || !bends) {
		return;
	}
	finish_step();
	simulation->settle();
	if (options.prototypes > 0) {
		fill(); // What they did before is in their history, and followers show it.
		return;
	}
	for (int page = 0; page < simulation->page_count(); page++) {
		bends->write_page(*simulation, page);
	}
	upload();
	pose_skeletons();
}

} // namespace undergrowth
