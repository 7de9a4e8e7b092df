#include "field/motion/wind_in_field.hpp"

#include "base/convert.hpp"

#include <cmath>

using namespace godot;

namespace undergrowth {

// Position and axes of a field's ground in the world, seen from above.
static AirAxes horizontal_axes(const Transform3D &axes) {
	const auto flat = [](const Vector3 &v) { return glm::dvec2(double(v.x), double(v.z)); };
	return { flat(axes.origin), flat(axes.basis.get_column(0)), flat(axes.basis.get_column(2)) };
}

FieldWind field_wind(const Ref<PlantWind> &wind, const Transform3D &axes, double offset, int steps) {
	FieldWind blowing;
	if (wind.is_null()) {
		blowing.wind.strength = 0.0f;
		return blowing;
	}
	blowing = wind->travelling_before(steps);
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

} // namespace undergrowth
