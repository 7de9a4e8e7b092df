// The part of PlantField3D that moves: steps beside the main thread, bodies, wind and what the shaders need to know.

#include "field/plant_field_3d.hpp"

#include "convert.hpp"
#include "field/field_shapes.hpp"
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
	if (step_count == 0) {
		return 0.0;
	}
	update_wind(step_count);
	gather_bodies();
	update_far();
	TipContact *contact = options.contact && options.prototypes == 0 ? &touching : nullptr;
	double stepping_usec = 0.0;
	for (int i = 0; i < step_count; i++) {
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

void PlantField3D::gather_bodies() {
	if (bodies_group.is_empty() && watched.empty()) {
		simulation->set_bodies(nullptr, 0);
		return;
	}
	std::vector<FieldBody> pushing;
	std::vector<WatchedBody> present;
	const TypedArray<Node> nodes = bodies_group.is_empty()
			? TypedArray<Node>()
			: TypedArray<Node>(get_tree()->get_nodes_in_group(bodies_group));
	const Transform3D to_field = axes().affine_inverse();
	for (int64_t i = 0; i < nodes.size(); i++) {
		const Node3D *node = Object::cast_to<Node3D>(nodes[i]);
		if (!node) {
			continue;
		}
		const size_t first = pushing.size();
		add_shapes(node, to_field, pushing);
		if (pushing.size() == first) {
			continue;
		}
		WatchedBody body;
		body.id = node->get_instance_id();
		body.at = to_glm(to_field.xform(node->get_global_position()));
		const auto before = std::find_if(
				watched.begin(), watched.end(), [&](const WatchedBody &other) { return other.id == body.id; });
		if (before != watched.end()) {
			const double delta = std::max(get_process_delta_time(), 1e-4);
			for (size_t k = first; k < pushing.size(); k++) {
				pushing[k].velocity = (body.at - before->at) / float(delta);
			}
			body.is_inside = before->is_inside;
		}
		const bool was_inside = body.is_inside;
		body.is_inside = false;
		for (size_t k = first; k < pushing.size() && !body.is_inside; k++) {
			const float margin = pushing[k].radius + float(options.touch_margin);
			body.is_inside = simulation->is_point_in_plants(pushing[k].from, margin) ||
					simulation->is_point_in_plants(pushing[k].to, margin);
		}
		present.push_back(body);
		if (body.is_inside != was_inside) {
			call_deferred("emit_signal", body.is_inside ? "body_entered_plants" : "body_exited_plants", node);
		}
	}
	for (const WatchedBody &body : watched) {
		Object *gone = body.is_inside ? ObjectDB::get_instance(body.id) : nullptr;
		const auto is_same = [&](const WatchedBody &other) { return other.id == body.id; };
		if (gone && std::none_of(present.begin(), present.end(), is_same)) {
			call_deferred("emit_signal", "body_exited_plants", gone); // It left the group, or the tree.
		}
	}
	watched = std::move(present);
	simulation->set_bodies(pushing.data(), int(pushing.size()));
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
			const MotionPage &plants = simulation->page(page);
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

// A plane of delays in the field's axes as the shader takes it, by metre of the world.
static Vector4 world_delay(const DelayPlane &plane, const Transform3D &axes) {
	const Vector3 per_metre = axes.basis.inverse().transposed().xform(Vector3(plane.x, 0.0f, plane.z));
	return Vector4(per_metre.x, per_metre.y, per_metre.z, plane.base - per_metre.dot(axes.origin));
}

void PlantField3D::send_uniforms() {
	if (options.prototypes == 0 || simulation->settings().prototypes == 0) {
		return;
	}
	const FollowDelays &delays = simulation->follow_delays();
	const Vector4 delay = world_delay(delays.after(), axes());
	const Vector4 delay_before = world_delay(delays.before(), axes());
	const float share = delays.share(shown_alpha);
	for (int i = 0; i < simulation->species_count(); i++) {
		const Vector3 history(
				float(bends->history_layer(i)), float(simulation->prototypes(i)->newest_slot()), shown_alpha);
		for (const Ref<ShaderMaterial> &material : style.looks[size_t(i)].materials) {
			material->set_shader_parameter("undergrowth_history", history);
			material->set_shader_parameter("undergrowth_delay", delay);
			material->set_shader_parameter("undergrowth_delay_before", delay_before);
			material->set_shader_parameter("undergrowth_delay_share", share);
		}
	}
}

} // namespace undergrowth
