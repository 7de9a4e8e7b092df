// PlantFunction: properties. plant_function_calls.cpp samples the functions.

#include "species/plant_function.hpp"

#include "base/convert.hpp"
#include "base/follow_changes.hpp"
#include "base/portable_math.hpp"
#include "base/shortest_decimal.hpp"
#include "conventions.hpp"

#include <godot_cpp/core/class_db.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace godot;

namespace undergrowth {

static constexpr Range ELASTICITY_RANGE = { -0.99, 1e4 };
static constexpr Range FRICTION_RANGE = { 0.0, 1e6 };
static constexpr Range FREQUENCY_RANGE = { 0.01, 1000.0 };
static constexpr Range FREQUENCY_HEIGHT_RANGE = { 0.0, 100.0 };
static constexpr Range FREQUENCY_DEVIATION_RANGE = { 0.0, 0.3 };
static constexpr Range DAMPING_RANGE = { 0.0, 100.0 };
static constexpr Range LEAN_DEGREES = { 0.0, 80.0 };
static constexpr Range MASS_RANGE = { 1e-6, 1e6 };
static constexpr Range WIND_WEIGHT_RANGE = { -1.0, 1e3 }; // Below 0: the default weight.
static constexpr Range DRAG_AREA_RANGE = { -1.0, 1e3 };
static constexpr Range COLLISION_RANGE = { 0.0, 1e3 };
static constexpr Range TRAMPLING_RANGE = { 0.0, 1.0 };
static constexpr Range RECOVERY_RANGE = { 0.1, 1e9 };
static constexpr Range LODGING_RANGE = { 0.0, 0.5 * PI };
static constexpr Range DEVIATION_RANGE = { 0.0, 1.0 };

void PlantFunction::shape_changed() {
	stems.clear();
	emit_changed();
}

Motion PlantFunction::new_motion() {
	Motion usual;
	usual.law = Law::stem;
	usual.wind_weight = -1.0f;
	return usual;
}

void PlantFunction::adopt_motion(const Motion &species_motion) {
	motion = species_motion;
	lean = shortest_decimal(float(motion.lean * (180.0 / PI))) * (PI / 180.0);
}

bool PlantFunction::is_motion_change() const {
	return changes_motion_only;
}

void PlantFunction::set_motion(float &slot, const char *property, double value, const Range &range) {
	if (accept_value(this, property, value, range) && float(value) != slot) {
		slot = float(value);
		motion_changed();
	}
}

void PlantFunction::motion_changed() {
	stems.forget_stems();
	changes_motion_only = true;
	emit_changed();
	changes_motion_only = false;
}

void PlantFunction::set_mesh_option(float &slot, const char *property, double value) {
	if (accept_value(this, property, value, DEVIATION_RANGE) && float(value) != slot) {
		slot = float(value);
		shape_changed();
	}
}

Joint PlantFunction::make_joint(const Basis &frame) const {
	Joint joint;
	joint.mass = motion.mass;
	joint.wind_weight = motion.wind_weight < 0.0f ? 1.0f : motion.wind_weight;
	joint.drag_area = motion.drag_area;
	joint.elasticity = motion.elasticity;
	joint.inner_friction = motion.inner_friction;
	joint.above_ground = stays_above_ground;
	joint.natural_frequency = motion.natural_frequency;
	joint.damping_ratio = motion.damping_ratio;
	joint.rest = to_glm(frame.xform(Vector3(0.0f, std::cos(motion.lean), std::sin(motion.lean))));
	return joint;
}

void PlantFunction::set_law(MotionLaw law) {
	if (law != LAW_ELASTICITY && law != LAW_SPRING && law != LAW_STEM) {
		report_error(
				this, "law " + String::num_int64(law) + " does not exist. Use LAW_ELASTICITY, LAW_SPRING or LAW_STEM.");
		return;
	}
	if (Law(law) != motion.law) {
		motion.law = Law(law);
		notify_property_list_changed();
		motion_changed();
	}
}

PlantFunction::MotionLaw PlantFunction::get_law() const {
	return MotionLaw(int(motion.law));
}

void PlantFunction::set_elasticity(double value) {
	set_motion(motion.elasticity, "elasticity", value, ELASTICITY_RANGE);
}

double PlantFunction::get_elasticity() const {
	return shortest_decimal(motion.elasticity);
}

void PlantFunction::set_inner_friction(double value) {
	set_motion(motion.inner_friction, "inner_friction", value, FRICTION_RANGE);
}

double PlantFunction::get_inner_friction() const {
	return shortest_decimal(motion.inner_friction);
}

void PlantFunction::set_stays_above_ground(bool value) {
	if (value != stays_above_ground) {
		stays_above_ground = value;
		motion_changed();
	}
}

bool PlantFunction::get_stays_above_ground() const {
	return stays_above_ground;
}

void PlantFunction::set_natural_frequency(double hertz) {
	set_motion(motion.natural_frequency, "natural_frequency", hertz, FREQUENCY_RANGE);
}

double PlantFunction::get_natural_frequency() const {
	return shortest_decimal(motion.natural_frequency);
}

void PlantFunction::set_frequency_height(double metres) {
	set_motion(motion.frequency_height, "frequency_height", metres, FREQUENCY_HEIGHT_RANGE);
}

double PlantFunction::get_frequency_height() const {
	return shortest_decimal(motion.frequency_height);
}

void PlantFunction::set_frequency_deviation(double deviation) {
	set_motion(motion.frequency_deviation, "frequency_deviation", deviation, FREQUENCY_DEVIATION_RANGE);
}

double PlantFunction::get_frequency_deviation() const {
	return shortest_decimal(motion.frequency_deviation);
}

void PlantFunction::set_damping_ratio(double ratio) {
	set_motion(motion.damping_ratio, "damping_ratio", ratio, DAMPING_RANGE);
}

double PlantFunction::get_damping_ratio() const {
	return shortest_decimal(motion.damping_ratio);
}

void PlantFunction::set_lean(double radians) {
	const double written = exact_angle(radians);
	if (accept_angle(this, "lean", radians, LEAN_DEGREES) && written != lean) {
		lean = written;
		motion.lean = float(written);
		motion_changed();
	}
}

double PlantFunction::get_lean() const {
	return lean;
}

void PlantFunction::set_mass(double kilograms) {
	set_motion(motion.mass, "mass", kilograms, MASS_RANGE);
}

double PlantFunction::get_mass() const {
	return shortest_decimal(motion.mass);
}

void PlantFunction::set_wind_weight(double weight) {
	set_motion(motion.wind_weight, "wind_weight", weight, WIND_WEIGHT_RANGE);
}

double PlantFunction::get_wind_weight() const {
	return shortest_decimal(motion.wind_weight);
}

void PlantFunction::set_drag_area(double square_metres) {
	set_motion(motion.drag_area, "drag_area", square_metres, DRAG_AREA_RANGE);
}

double PlantFunction::get_drag_area() const {
	return shortest_decimal(motion.drag_area);
}

void PlantFunction::set_collision_radius(double metres) {
	set_motion(motion.collision_radius, "collision_radius", metres, COLLISION_RANGE);
}

double PlantFunction::get_collision_radius() const {
	return shortest_decimal(motion.collision_radius);
}

void PlantFunction::set_trampling(double share) {
	set_motion(motion.trampling, "trampling", share, TRAMPLING_RANGE);
}

double PlantFunction::get_trampling() const {
	return shortest_decimal(motion.trampling);
}

void PlantFunction::set_recovery_time(double seconds) {
	set_motion(motion.recovery_time, "recovery_time", seconds, RECOVERY_RANGE);
}

double PlantFunction::get_recovery_time() const {
	return shortest_decimal(motion.recovery_time);
}

void PlantFunction::set_lodging_angle(double radians) {
	set_motion(motion.lodging_angle, "lodging_angle", exact_angle(radians), LODGING_RANGE);
}

double PlantFunction::get_lodging_angle() const {
	return shortest_decimal(motion.lodging_angle);
}

Trampling PlantFunction::make_trampling() const {
	const double yield = portable_tan(0.5 * double(motion.lodging_angle));
	return { motion.trampling, motion.recovery_time, float(yield) };
}

void PlantFunction::set_shading(ShadingMode shading) {
	if (shading != SHADING_SMOOTH && shading != SHADING_FLAT) {
		report_error(
				this, "shading " + String::num_int64(shading) + " does not exist. Use SHADING_SMOOTH or SHADING_FLAT.");
		return;
	}
	if (Shading(shading) != mesh_options.shading) {
		mesh_options.shading = Shading(shading);
		shape_changed();
	}
}

PlantFunction::ShadingMode PlantFunction::get_shading() const {
	return ShadingMode(int(mesh_options.shading));
}

void PlantFunction::set_shape_deviation(double deviation) {
	set_mesh_option(mesh_options.shape_deviation, "shape_deviation", deviation);
}

double PlantFunction::get_shape_deviation() const {
	return shortest_decimal(mesh_options.shape_deviation);
}

void PlantFunction::set_color_deviation(double deviation) {
	set_mesh_option(mesh_options.color_deviation, "color_deviation", deviation);
}

double PlantFunction::get_color_deviation() const {
	return shortest_decimal(mesh_options.color_deviation);
}

void PlantFunction::set_material(const Ref<Material> &new_material) {
	if (new_material != material) {
		material = new_material;
		changes_material_only = true;
		emit_changed();
		changes_material_only = false;
	}
}

Ref<Material> PlantFunction::get_material() const {
	return material;
}

// Grown plants do not depend on the motion or the material.
void PlantFunction::on_own_change() {
	if (!is_motion_change() && !is_material_change()) {
		on_grown_change();
	}
}

void PlantFunction::on_grown_change() {
	growth.forget();
	stems.clear();
}

void PlantFunction::on_arrangement_changed() {
	shape_changed();
}

void PlantFunction::set_has_stem(bool grows) {
	if (grows != has_stem) {
		has_stem = grows;
		shape_changed();
	}
}

void PlantFunction::set_arrangements(const TypedArray<PlantArrangement> &list) {
	const Callable changed(this, "_on_arrangement_changed");
	for (int64_t i = 0; i < arrangements.size(); i++) {
		unfollow_changes(Ref<PlantArrangement>(arrangements[i]).ptr(), changed);
	}
	const bool is_same = arrangements == list;
	arrangements = list.duplicate();
	for (int64_t i = 0; i < arrangements.size(); i++) {
		follow_changes(Ref<PlantArrangement>(arrangements[i]).ptr(), changed);
	}
	if (!is_same) {
		shape_changed();
	}
}

TypedArray<PlantArrangement> PlantFunction::get_arrangements() const {
	return TypedArray<PlantArrangement>(arrangements);
}

void PlantFunction::_validate_property(PropertyInfo &property) const {
	static const std::vector<std::pair<const char *, std::vector<Law>>> laws_of = {
		{ "elasticity", { Law::elasticity } },
		{ "inner_friction", { Law::elasticity } },
		{ "stays_above_ground", { Law::elasticity, Law::stem } },
		{ "natural_frequency", { Law::spring, Law::stem } },
		{ "frequency_height", { Law::stem } },
		{ "frequency_deviation", { Law::stem } },
		{ "damping_ratio", { Law::spring, Law::stem } },
		{ "lean", { Law::spring, Law::stem } },
		{ "mass", { Law::elasticity, Law::spring } },
		{ "stem", { Law::stem } },
		{ "trampling", { Law::stem } },
		{ "recovery_time", { Law::stem } },
		{ "lodging_angle", { Law::stem } },
	};
	const String name = property.name;
	for (const auto &[of_law, laws] : laws_of) {
		if (name == of_law && std::find(laws.begin(), laws.end(), motion.law) == laws.end()) {
			property.usage = PROPERTY_USAGE_NO_EDITOR;
		}
	}
}

} // namespace undergrowth
