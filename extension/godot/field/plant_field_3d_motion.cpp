// The part of PlantField3D that moves: steps beside the main thread, bodies, wind and what the shaders need to know.

#include "field/plant_field_3d.hpp"

#include "convert.hpp"
#include "messages.hpp"
#include "plant_simulation.hpp"

#include <godot_cpp/classes/camera3d.hpp>
#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/os.hpp>
#include <godot_cpp/classes/scene_tree.hpp>
#include <godot_cpp/classes/viewport.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>

using namespace godot;

namespace undergrowth {

using Clock = std::chrono::steady_clock;

static constexpr int FRAMES_BETWEEN_FAR_UPDATES = 15;
static constexpr int MOST_FAR_MULTIPLE = 32;
static constexpr double FARTHER = 1.4142135623730951; // So much farther is stepped half as often again.
static constexpr double LARGEST_WIND_DRIFT = 2.5; // Steps that two clocks may differ by and still count as one.

static double microseconds_since(Clock::time_point start) {
	return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

bool PlantField3D::may_simulate() const {
	return options.simulating && simulation && simulation->plant_count() > 0 &&
			!Engine::get_singleton()->is_editor_hint();
}

void PlantField3D::update_processing() {
	set_process_internal(is_inside_tree() && (fill_job || !pending.empty() || may_simulate() || wants_skeletons()));
}

void PlantField3D::finish_step() {
	steps.wait();
}

void PlantField3D::process_frame() {
	const Clock::time_point start = Clock::now();
	if (fill_job) {
		poll_fill();
	}
	if (!simulation) {
		return;
	}
	const Clock::time_point before_waiting = Clock::now();
	finish_step();
	wait_usec = microseconds_since(before_waiting);
	flush_pending();
	double stepping_usec = 0.0;
	const bool has_chosen = choose_skeletons();
	if (may_simulate() || has_chosen) {
		upload();
	}
	pose_skeletons();
	if (may_simulate()) {
		stepping_usec = step(get_process_delta_time());
	}
	main_usec = microseconds_since(start) - wait_usec - stepping_usec;
}

void PlantField3D::upload() {
	if (!bends || !is_visible_in_tree()) {
		return; // What is fresh stays so until somebody looks.
	}
	const Clock::time_point start = Clock::now();
	bends->upload(*simulation, shown_alpha);
	send_uniforms();
	upload_usec = microseconds_since(start);
}

// The last step of a frame runs beside it and is shown in the next one. Where frames take longer than a step, those
// before it are done at once. Tells how much of this thread steps took, which small fields take here.
double PlantField3D::step(double delta) {
	if (PlantSimulation::get_singleton()->get_step_length() != clock.step() && !is_stale) {
		mark_stale(); // Constants hold for one step length.
	}
	const int step_count = clock.advance(delta);
	shown_alpha = clock.alpha();
	bodies.watch(get_tree(), bodies_group, axes(), delta);
	if (step_count == 0) {
		return 0.0;
	}
	update_wind(step_count);
	update_far();
	TipContact *contact = options.contact && options.prototypes == 0 ? &touching : nullptr;
	if (contact && contact->is_crowded() && !has_told_of_crowd) {
		has_told_of_crowd = true;
		report_warning(this,
				"too many tips are near each other for all of them to touch: some pairs are left out. Set a smaller "
				"collision_radius in its species, or a smaller density.");
	}
	double stepping_usec = 0.0;
	const Clock::time_point start = Clock::now();
	for (int i = 0; i < step_count; i++) {
		finish_step();
		if (i > 0 && microseconds_since(start) > 1e6 * FixedStep::MOST_STEPPING) {
			break; // The rest is dropped, so that a slow frame does not make the next one slower yet.
		}
		push_bodies((double(clock.alpha()) + step_count - 1 - i) * clock.step());
		if (i == 0) {
			tell_of_bodies();
		}
		steps.start(*simulation, *bends, contact, worker_count());
		stepping_usec += steps.inline_usec();
	}
	return stepping_usec;
}

int PlantField3D::worker_count() const {
	static const int processors = OS::get_singleton()->get_processor_count();
	return options.threads > 0 ? options.threads : processors;
}

// The wind in the field's axes, at the simulation's clock: the wind's own is `offset` seconds ahead of it.
FieldWind PlantField3D::wind_here(const Ref<PlantWind> &from, double offset) const {
	FieldWind blowing;
	blowing.speed = float(options.wind_speed);
	if (from.is_null()) {
		blowing.wind.strength = 0.0f;
		return blowing;
	}
	blowing.wind = from->description();
	blowing.wind.gust_start -= offset;
	blowing.wind.phase += double(blowing.wind.frequency) * offset;
	const Vector3 direction = axes().basis.inverse().xform(to_godot(wind_direction(blowing.wind)));
	blowing.wind.direction = std::atan2(direction.x, direction.z);
	return blowing;
}

// The wind's clock goes on with whoever simulates first in a frame: Plant3Ds, another field or this one.
void PlantField3D::update_wind(int step_count) {
	if (wind.is_valid()) {
		const double advance = step_count * clock.step();
		if (wind->get_time() == seen_wind_time) {
			wind->advance(advance);
		}
		seen_wind_time = wind->get_time();
		const double offset = seen_wind_time - advance - simulation->time();
		if (std::fabs(offset - wind_offset) > LARGEST_WIND_DRIFT * clock.step()) {
			wind_offset = offset;
		}
	}
	simulation->set_wind(wind_here(wind, wind_offset));
}

// The bodies as they were `ago` seconds before this frame.
void PlantField3D::push_bodies(double ago) {
	const std::vector<FieldBody> &pushing = bodies.gather(ago);
	simulation->set_bodies(pushing.data(), int(pushing.size()));
}

void PlantField3D::tell_of_bodies() {
	const auto touches = [this](const FieldBody &body) {
		for (int page = 0; page < simulation->page_count(); page++) {
			if (touches_plants(simulation->page(page), body, float(options.touch_margin))) {
				return true;
			}
		}
		return false;
	};
	for (const FieldBodies::Event &event : bodies.find_events(touches)) {
		if (Object *body = ObjectDB::get_instance(event.body)) {
			call_deferred("emit_signal", event.has_entered ? "body_entered_plants" : "body_exited_plants", body);
		}
	}
	for (const String &warning : bodies.take_warnings()) {
		report_warning(this, warning);
	}
}

// Pages farther than far_distance are stepped half as often, those FARTHER yet a quarter as often, and so on: as fast
// as the ground at a distance grows, so that all far rings cost about the same. A page's middle counts, but no plant of
// it is taken to be more than far_distance farther than it is: where the camera stands, all are stepped in full.
void PlantField3D::update_far() {
	if (frames_since_far++ % FRAMES_BETWEEN_FAR_UPDATES != 0) {
		return;
	}
	const Camera3D *camera = get_viewport()->get_camera_3d();
	const bool applies = camera && options.far_distance > 0.0;
	const glm::vec3 eye =
			applies ? to_glm(axes().affine_inverse().xform(camera->get_global_position())) : glm::vec3(0.0f);
	for (int page = 0; page < simulation->page_count(); page++) {
		int multiple = 1;
		if (applies) {
			const FieldPage &plants = simulation->page(page);
			const double nearest = glm::distance(eye, glm::clamp(eye, plants.low(), plants.high()));
			const double middle = glm::distance(eye, 0.5f * (plants.low() + plants.high()));
			const double away = std::min(middle, nearest + options.far_distance);
			for (double limit = options.far_distance; multiple < MOST_FAR_MULTIPLE && away > limit; limit *= FARTHER) {
				multiple *= 2;
			}
		}
		simulation->set_page_multiple(page, multiple);
	}
}

void PlantField3D::send_uniforms() {
	if (options.prototypes == 0 || simulation->settings().prototypes == 0) {
		return;
	}
	const float step_length = simulation->settings().step;
	const FieldWind &blowing = simulation->wind();
	const float per_x = wind_delay(blowing, 1.0f, 0.0f) / step_length;
	const float per_z = wind_delay(blowing, 0.0f, 1.0f) / step_length;
	const Transform3D placed = axes();
	const Vector3 per_metre = placed.basis.inverse().transposed().xform(Vector3(per_x, 0.0f, per_z));
	const float at_origin = simulation->prototype_lead() / step_length - per_metre.dot(placed.origin);
	const Vector4 delay(per_metre.x, per_metre.y, per_metre.z, at_origin);
	for (int i = 0; i < simulation->species_count(); i++) {
		const Vector3 history(
				float(bends->history_layer(i)), float(simulation->prototypes(i)->newest_slot()), shown_alpha);
		for (const Ref<ShaderMaterial> &material : style.looks[size_t(i)].materials) {
			material->set_shader_parameter("undergrowth_history", history);
			material->set_shader_parameter("undergrowth_delay", delay);
		}
	}
}

} // namespace undergrowth
