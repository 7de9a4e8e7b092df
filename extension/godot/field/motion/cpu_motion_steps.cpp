// Steps of CpuMotion: wind, cameras, and uploads to the graphics card.

#include "field/motion/cpu_motion.hpp"

#include "base/convert.hpp"
#include "base/stopwatch.hpp"
#include "nodes/plant_wind_source_3d.hpp"

#include <godot_cpp/classes/os.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr int FRAMES_BETWEEN_FAR_UPDATES = 15;
static constexpr int MAX_FAR_MULTIPLE = 32;
static constexpr double NEAR = 10.0; // m: distance within which a stem's second mode is visible.
static constexpr double NEVER_FAR = 0.5; // Fraction of far_distance within which plants are stepped in full.
// Ratio of distances between rings; each ring is stepped half as often as the one before.
static constexpr double FARTHER = 1.4142135623730951;

static int worker_count(const MotionOptions &options) {
	static const int processors = OS::get_singleton()->get_processor_count();
	return options.max_threads > 0 ? options.max_threads : processors;
}

bool CpuMotion::needs_cameras() const {
	return frames_since_far % FRAMES_BETWEEN_FAR_UPDATES == 0;
}

// Pages farther than far_distance are stepped every second step, pages FARTHER times as far every fourth, and so on.
// All far rings cost about the same, because their areas grow at the same rate.
//
// The distance is that of a page's middle, but at most that of its nearest point plus half of far_distance. So all
// plants around a camera are stepped in full, also seen from above. Pushing bodies count as cameras. Near a camera or a
// body, stems with two modes step both. If far_distance is 0, cameras have no effect.
void CpuMotion::update_far(const Frame &frame, const MotionOptions &options) {
	const bool is_due = needs_cameras();
	frames_since_far++;
	if (!is_due) {
		return;
	}
	if (frame.wind.is_valid() && !frame.cameras.empty()) {
		Ref<PlantWind>(frame.wind)->set_pivot(frame.cameras.front());
	}
	const Transform3D to_field = frame.axes.affine_inverse();
	std::vector<glm::vec3> cameras;
	for (const Vector3 &camera : frame.cameras) {
		cameras.push_back(to_glm(to_field.xform(camera)));
	}
	const bool applies = options.far_distance > 0.0 && !cameras.empty();
	cameras.insert(cameras.end(), pushed_at.begin(), pushed_at.end());
	const auto metres = [&](const glm::vec3 &way) { return double(frame.axes.basis.xform(to_godot(way)).length()); };
	for (int page = 0; page < simulation->page_count(); page++) {
		const MotionPage &plants = simulation->page(page);
		double away = applies ? 1e30 : 0.0;
		bool is_near = false;
		for (const glm::vec3 &camera : cameras) {
			const double nearest = metres(camera - glm::clamp(camera, plants.low(), plants.high()));
			const double middle = metres(camera - 0.5f * (plants.low() + plants.high()));
			away = std::min(away, std::min(middle, nearest + NEVER_FAR * options.far_distance));
			is_near = is_near || nearest < NEAR;
		}
		simulation->set_page_near(page, applies && is_near);
		int multiple = 1;
		for (double limit = options.far_distance; multiple < MAX_FAR_MULTIPLE && applies && away > limit;
				limit *= FARTHER) {
			multiple *= 2;
		}
		simulation->set_page_multiple(page, multiple);
	}
}

void CpuMotion::start_step(const MotionOptions &options, bool with_contact) {
	is_transferred = false;
	TipContact *contact = with_contact && simulation->settings().prototypes == 0 ? &touching : nullptr;
	time_after_step = simulation->time(1);
	steps.start(*simulation, *textures, contact, worker_count(options));
	swings.step(clock.step());
}

// Sets the bodies at `ago` seconds before this frame.
void CpuMotion::push(double ago) {
	const std::vector<MovingBody> &pushing = bodies.gather(ago);
	simulation->set_bodies(pushing.data(), int(pushing.size()));
	pushed_at.clear();
	for (const MovingBody &body : pushing) {
		pushed_at.push_back(body.from);
	}
}

// Sets the air sources, and the field's own motion through the air, `ago` seconds before this frame.
void CpuMotion::stir(const Frame &frame, const MotionOptions &options, double ago) {
	PlantWindSource3D::gather_in(frame.world, frame.axes, ago, stirring);
	simulation->set_air_sources(stirring);
	AirDrift own = drift.step(ago);
	own.share = float(options.apparent_wind);
	simulation->set_drift(own);
}

void CpuMotion::find_events(double margin) {
	const auto is_among_plants = [&](const MovingBody &body) {
		for (int page = 0; page < simulation->page_count(); page++) {
			if (touches_plants(simulation->page(page), body, float(margin))) {
				return true;
			}
		}
		return false;
	};
	const std::vector<GroupBodies::Event> found = bodies.find_events(is_among_plants);
	events.insert(events.end(), found.begin(), found.end());
}

// The last step of a frame runs beside it and is shown in the next frame. If frames are longer than a step, the earlier
// steps finish at once.
double CpuMotion::advance(const Frame &frame, const MotionOptions &options) {
	drift.watch(frame.axes, frame.delta);
	const int step_count = clock.advance(frame.delta);
	shown_alpha = clock.alpha();
	if (step_count == 0) {
		return 0.0;
	}
	wind_clock.follow(frame.wind, step_count, clock.step(), simulation->time());
	simulation->set_wind(field_wind(frame.wind, frame.axes, wind_clock.ahead()));
	update_far(frame, options);
	const Stopwatch watch;
	double stepping_usec = 0.0;
	for (int i = 0; i < step_count; i++) {
		wait();
		stepping_usec += i > 0 ? steps.inline_usec() : 0.0;
		if (i > 0 && watch.usec() > 1e6 * FixedStep::MAX_STEPPING_TIME) {
			break; // Drops the remaining steps, so that a slow frame does not slow down the next one.
		}
		const double ago = clock.step() * (double(shown_alpha) + step_count - 1 - i);
		stir(frame, options, ago);
		push(ago);
		if (i == 0) {
			find_events(options.touch_margin);
		}
		start_step(options, touches);
	}
	return stepping_usec;
}

void CpuMotion::preview(const Frame &frame, const MotionOptions &options) {
	wait();
	const int step_count = clock.advance(frame.delta);
	shown_alpha = clock.alpha();
	if (step_count > 0) {
		const double now = frame.wind.is_valid() ? frame.wind->get_time() : 0.0;
		const double ahead = now - step_count * clock.step() - simulation->time();
		simulation->set_wind(field_wind(frame.wind, frame.axes, ahead));
		simulation->set_bodies(nullptr, 0);
		PlantWindSource3D::gather_in(frame.world, frame.axes, 0.0, stirring);
		simulation->set_air_sources(stirring);
		simulation->set_drift({});
	}
	for (int i = 0; i < step_count; i++) {
		start_step(options, false);
	}
	wait();
}

double CpuMotion::motion_time() const {
	if (!simulation) {
		return 0.0;
	}
	return (steps.is_running() ? time_after_step : simulation->time()) + wind_clock.ahead();
}

bool CpuMotion::upload() {
	wait();
	const std::vector<int> &changed = simulation->changed_pages();
	dirty_pages.insert(dirty_pages.end(), changed.begin(), changed.end());
	simulation->forget_changed_pages();
	std::sort(dirty_pages.begin(), dirty_pages.end());
	dirty_pages.erase(std::unique(dirty_pages.begin(), dirty_pages.end()), dirty_pages.end());
	for (const int page : dirty_pages) {
		textures->give_seconds(*simulation, page);
		textures->write_page(*simulation, page);
	}
	dirty_pages.clear();
	const bool are_new = textures->make_textures();
	textures->upload(*simulation, shown_alpha);
	leans.follow(*simulation);
	const bool are_first = textures->has_heights() && !showed_heights;
	showed_heights = textures->has_heights();
	return are_new || are_first;
}

Vector4 CpuMotion::history_of(int species) const {
	const Prototypes *models = simulation->prototypes(species);
	if (!models) {
		return Vector4(-1.0f, 0.0f, 0.0f, -1.0f);
	}
	const int second = models->modes() == 2 ? textures->history_layer(species, 1) : -1;
	return Vector4(
			float(textures->history_layer(species, 0)), float(models->newest_slot()), shown_alpha, float(second));
}

// Converts a plane of delays in the field's axes to metres of the world, for the shader.
static Vector4 world_delay(const DelayPlane &plane, const Transform3D &axes) {
	const Vector3 per_metre = axes.basis.inverse().transposed().xform(Vector3(plane.x, 0.0f, plane.z));
	return Vector4(per_metre.x, per_metre.y, per_metre.z, plane.base - per_metre.dot(axes.origin));
}

FieldMotion::Delays CpuMotion::follower_delays(const Transform3D &axes) const {
	const FollowDelays &delays = simulation->follow_delays();
	return { world_delay(delays.after(), axes), world_delay(delays.before(), axes), delays.share(shown_alpha) };
}

StemMotion CpuMotion::blocking_read_drawn_stem(const PlantRef &ref) const {
	StemMotion stem = simulation->shown_stem(rows_of(ref.chunk).page, row_of(ref), shown_alpha);
	stem.clock = swing_clock();
	return stem;
}

} // namespace undergrowth
