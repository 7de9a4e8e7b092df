// What Plant3D does for the editor only: it moves under a wind that is tried out, and keeps what is drawn around it
// true.

#include "plant_3d.hpp"

#include "convert.hpp"

#include <godot_cpp/classes/engine.hpp>

#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr double MOST_FRAME = 3600.0; // s.

// Called for every plant of a scene and every frame. What cannot move stays still without a word: its configuration
// warning tells why.
void Plant3D::preview(double delta, const Ref<PlantWind> &blowing) {
	const bool is_frame = std::isfinite(delta) && delta >= 0.0 && delta <= MOST_FRAME;
	if (!is_frame || place.group || function.is_null() || !get_mesh().is_valid()) {
		return;
	}
	PlantGroup *group = prepare_own_group();
	double time = blowing.is_valid() ? blowing->get_time() - delta : 0.0;
	for (int steps = own_clock->advance(delta); steps > 0; steps--) {
		time += own_clock->step();
		const Vector3 force = blowing.is_valid() ? blowing->sample(time) : Vector3();
		group->batch.step(to_glm(frame.xform_inv(force)));
	}
	glm::vec3 direction;
	group->batch.interpolate(own_clock->alpha(), &direction);
	pose(direction);
}

void Plant3D::on_wind_changed() {
	if (Engine::get_singleton()->is_editor_hint()) {
		update_configuration_warnings();
		update_gizmos(); // They show the wind's direction.
	}
}

} // namespace undergrowth
