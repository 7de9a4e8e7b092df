#include "field/motion/field_wind_clock.hpp"

#include "base/convert.hpp"

#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr double LARGEST_DRIFT = 2.5; // Difference of two clocks that counts as equal, in steps.

// Position and axes of a field's ground in the world, seen from above.
static AirAxes horizontal_axes(const Transform3D &axes) {
	const auto flat = [](const Vector3 &v) { return glm::dvec2(double(v.x), double(v.z)); };
	return { flat(axes.origin), flat(axes.basis.get_column(0)), flat(axes.basis.get_column(2)) };
}

FieldWind field_wind(const Ref<PlantWind> &wind, const Transform3D &axes, double offset) {
	FieldWind blowing;
	if (wind.is_null()) {
		blowing.wind.strength = 0.0f;
		return blowing;
	}
	blowing = wind->travelling();
	const glm::vec3 origin = to_glm(axes.origin);
	const double late = double(wind_delay(blowing, origin.x, origin.z));
	const double ahead = offset - late;
	blowing.min_delay = float(-late);
	blowing.wind.gust_start -= ahead;
	blowing.air.since -= offset;
	blowing.axes = horizontal_axes(axes);
	blowing.wind.phase += double(blowing.wind.frequency) * ahead;
	const Vector3 direction = axes.basis.inverse().xform(to_godot(wind_direction(blowing.wind)));
	blowing.wind.direction = std::atan2(direction.x, direction.z);
	blowing.speed *= std::sqrt(direction.x * direction.x + direction.z * direction.z); // In metres of the field's axes.
	return blowing;
}

void FieldWindClock::follow(const Ref<PlantWind> &wind, int steps, double step, double motion_time) {
	const uint64_t id = wind.is_valid() ? uint64_t(wind->get_instance_id()) : 0;
	if (id != seen) {
		seen = id;
		seen_time = -1.0;
	}
	if (wind.is_null()) {
		return;
	}
	const double advance = steps * step;
	const bool is_first = seen_time < 0.0;
	if (is_first ? !wind->has_advanced_in_frame() : wind->get_time() == seen_time) {
		wind->advance(advance);
	}
	seen_time = wind->get_time();
	const double ahead_now = seen_time - advance - motion_time;
	if (is_first || std::fabs(ahead_now - offset) > LARGEST_DRIFT * step) {
		offset = ahead_now;
	}
}

} // namespace undergrowth
