#include "form/plant_part.hpp"

#include "base/convert.hpp"
#include "base/follow_changes.hpp"
#include "base/shortest_decimal.hpp"
#include "conventions.hpp"
#include "form/set_by_names.hpp"
#include "species/script_call.hpp"

#include <godot_cpp/core/class_db.hpp>

#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr int WIDTH_SAMPLES = 33;
static constexpr Range LENGTH_RANGE = { 1e-4, 100.0 };

static Array arguments(double offset) {
	Array values;
	values.push_back(offset);
	return values;
}

static Array arguments(double offset, double across) {
	Array values = arguments(offset);
	values.push_back(across);
	return values;
}

double written_angle(float radians) {
	return shortest_decimal(float(radians * (180.0 / PI))) * (PI / 180.0);
}

void PlantPart::change_number(float &slot, const char *property, double value, const Range &range) {
	if (accept_value(this, property, value, range) && float(value) != slot) {
		slot = float(value);
		emit_changed();
	}
}

void PlantPart::change_angle(float &slot, const char *property, double radians, const Range &degrees) {
	if (accept_angle(this, property, radians, degrees) && float(radians) != slot) {
		slot = float(radians);
		emit_changed();
	}
}

void PlantPart::change_count(int &slot, const char *property, int value, const Range &range) {
	if (accept_value(this, property, value, range) && value != slot) {
		slot = value;
		emit_changed();
	}
}

String PlantPart::read(Part &into) {
	into = part;
	String problem = call_widths(into);
	if (problem.is_empty()) {
		problem = call_colors(into);
	}
	if (problem.is_empty()) {
		problem = String::utf8(find_part_fault(into).c_str());
	}
	return problem.is_empty() ? problem : describe(this) + ": " + problem;
}

String PlantPart::call_widths(Part &into) {
	const bool from_script = GDVIRTUAL_IS_OVERRIDDEN(_calculate_width);
	if (!from_script && (width_curve.is_null() || width_curve->get_point_count() == 0)) {
		return String();
	}
	String problem;
	for (int i = 0; i < WIDTH_SAMPLES && problem.is_empty(); i++) {
		const double offset = double(i) / (WIDTH_SAMPLES - 1);
		const double width = from_script
				? double(call_script_override(this, "_calculate_width", arguments(offset), Variant::FLOAT, problem))
				: double(width_curve->sample_baked(float(offset)));
		into.widths.samples.push_back(float(width));
	}
	return problem;
}

String PlantPart::call_colors(Part &into) {
	const bool from_script = GDVIRTUAL_IS_OVERRIDDEN(_calculate_color);
	if (!from_script && gradient.is_null()) {
		return String();
	}
	String problem;
	for (int i = 0; i < PartColors::ROWS; i++) {
		const double offset = double(i) / (PartColors::ROWS - 1);
		for (int k = 0; k < PartColors::COLUMNS && problem.is_empty(); k++) {
			const double across = double(k) / (PartColors::COLUMNS - 1);
			const Color color = from_script ? Color(call_script_override(this, "_calculate_color",
													  arguments(offset, across), Variant::COLOR, problem))
											: gradient->sample(float(offset));
			into.colors.samples.push_back(to_glm(color));
		}
	}
	return problem;
}

void PlantPart::set_all(const Dictionary &values) {
	set_by_names(this, values);
}

void PlantPart::follow(Resource *before, Resource *now) {
	const Callable changed(this, "_on_function_changed");
	unfollow_changes(before, changed);
	follow_changes(now, changed);
	emit_changed();
}

void PlantPart::on_function_changed() {
	emit_changed();
}

void PlantPart::set_length(const Vector2 &metres) {
	Vector2 range = metres.y == 0.0f ? Vector2(metres.x, metres.x) : metres;
	if (accept_span(this, "length", get_length(), range, LENGTH_RANGE) &&
			(range.x != part.length_min || range.y != part.length_max)) {
		part.length_min = range.x;
		part.length_max = range.y;
		emit_changed();
	}
}

Vector2 PlantPart::get_length() const {
	return Vector2(part.length_min, part.length_max);
}

void PlantPart::set_width_curve(const Ref<Curve> &curve) {
	if (curve != width_curve) {
		const Ref<Curve> before = width_curve;
		width_curve = curve;
		follow(before.ptr(), width_curve.ptr());
	}
}

Ref<Curve> PlantPart::get_width_curve() const {
	return width_curve;
}

void PlantPart::set_base_color(const Color &color) {
	if (to_glm(color) != part.colors.base) {
		part.colors.base = to_glm(color);
		emit_changed();
	}
}

Color PlantPart::get_base_color() const {
	return to_godot(part.colors.base);
}

void PlantPart::set_tip_color(const Color &color) {
	if (to_glm(color) != part.colors.tip) {
		part.colors.tip = to_glm(color);
		emit_changed();
	}
}

Color PlantPart::get_tip_color() const {
	return to_godot(part.colors.tip);
}

void PlantPart::set_gradient(const Ref<Gradient> &colors) {
	if (colors != gradient) {
		const Ref<Gradient> before = gradient;
		gradient = colors;
		follow(before.ptr(), gradient.ptr());
	}
}

Ref<Gradient> PlantPart::get_gradient() const {
	return gradient;
}

void PlantPart::set_translucency(double share) {
	change_number(part.translucency, "translucency", share, { 0.0, 1.0 });
}

double PlantPart::get_translucency() const {
	return shortest_decimal(part.translucency);
}

void PlantPart::set_venation(Venation kind) {
	if (kind < VENATION_AUTOMATIC || kind > VENATION_RADIAL) {
		report_error(
				this, "venation " + String::num_int64(kind) + " does not exist. Use one of the VENATION_ constants.");
	} else if (kind != get_venation()) {
		part.venation = undergrowth::Venation(kind);
		emit_changed();
	}
}

void PlantPart::set_frequency(double hertz) {
	change_number(part.frequency, "frequency", hertz, { 0.0, 100.0 });
}

double PlantPart::get_frequency() const {
	return shortest_decimal(part.frequency);
}

void PlantPart::set_damping_ratio(double ratio) {
	change_number(part.damping_ratio, "damping_ratio", ratio, { 0.0, 100.0 });
}

double PlantPart::get_damping_ratio() const {
	return shortest_decimal(part.damping_ratio);
}

void PlantPart::_bind_methods() {
	GDVIRTUAL_BIND(_calculate_width, "offset");
	GDVIRTUAL_BIND(_calculate_color, "offset", "across");
	ClassDB::bind_method(D_METHOD("_on_function_changed"), &PlantPart::on_function_changed);
	ClassDB::bind_method(D_METHOD("set_length", "metres"), &PlantPart::set_length);
	ClassDB::bind_method(D_METHOD("get_length"), &PlantPart::get_length);
	ClassDB::bind_method(D_METHOD("set_width_curve", "curve"), &PlantPart::set_width_curve);
	ClassDB::bind_method(D_METHOD("get_width_curve"), &PlantPart::get_width_curve);
	ClassDB::bind_method(D_METHOD("set_base_color", "color"), &PlantPart::set_base_color);
	ClassDB::bind_method(D_METHOD("get_base_color"), &PlantPart::get_base_color);
	ClassDB::bind_method(D_METHOD("set_tip_color", "color"), &PlantPart::set_tip_color);
	ClassDB::bind_method(D_METHOD("get_tip_color"), &PlantPart::get_tip_color);
	ClassDB::bind_method(D_METHOD("set_gradient", "gradient"), &PlantPart::set_gradient);
	ClassDB::bind_method(D_METHOD("get_gradient"), &PlantPart::get_gradient);
	ClassDB::bind_method(D_METHOD("set_translucency", "share"), &PlantPart::set_translucency);
	ClassDB::bind_method(D_METHOD("get_translucency"), &PlantPart::get_translucency);
	ClassDB::bind_method(D_METHOD("set_venation", "kind"), &PlantPart::set_venation);
	ClassDB::bind_method(D_METHOD("get_venation"), &PlantPart::get_venation);
	ClassDB::bind_method(D_METHOD("set_frequency", "hertz"), &PlantPart::set_frequency);
	ClassDB::bind_method(D_METHOD("get_frequency"), &PlantPart::get_frequency);
	ClassDB::bind_method(D_METHOD("set_damping_ratio", "ratio"), &PlantPart::set_damping_ratio);
	ClassDB::bind_method(D_METHOD("get_damping_ratio"), &PlantPart::get_damping_ratio);

	ADD_GROUP("Size", "");
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR2, "length", PROPERTY_HINT_RANGE, "0.001,2,0.0001,or_greater,suffix:m"),
			"set_length", "get_length");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "width_curve", PROPERTY_HINT_RESOURCE_TYPE, "Curve"), "set_width_curve",
			"get_width_curve");
	ADD_GROUP("Look", "");
	ADD_PROPERTY(PropertyInfo(Variant::COLOR, "base_color"), "set_base_color", "get_base_color");
	ADD_PROPERTY(PropertyInfo(Variant::COLOR, "tip_color"), "set_tip_color", "get_tip_color");
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "gradient", PROPERTY_HINT_RESOURCE_TYPE, "Gradient"), "set_gradient",
			"get_gradient");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "translucency", PROPERTY_HINT_RANGE, "0,1,0.01"), "set_translucency",
			"get_translucency");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "venation", PROPERTY_HINT_ENUM,
						 "Automatic,None,Parallel,Pinnate,Palmate,Radial"),
			"set_venation", "get_venation");
	ADD_GROUP("Motion", "");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "frequency", PROPERTY_HINT_RANGE, "0,10,0.01,or_greater,suffix:Hz"),
			"set_frequency", "get_frequency");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "damping_ratio", PROPERTY_HINT_RANGE, "0,2,0.001,or_greater"),
			"set_damping_ratio", "get_damping_ratio");

	BIND_ENUM_CONSTANT(VENATION_AUTOMATIC);
	BIND_ENUM_CONSTANT(VENATION_NONE);
	BIND_ENUM_CONSTANT(VENATION_PARALLEL);
	BIND_ENUM_CONSTANT(VENATION_PINNATE);
	BIND_ENUM_CONSTANT(VENATION_PALMATE);
	BIND_ENUM_CONSTANT(VENATION_RADIAL);
}

} // namespace undergrowth
