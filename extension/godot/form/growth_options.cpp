#include "form/growth_options.hpp"

#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/variant.hpp>
#include <godot_cpp/variant/vector2.hpp>

using namespace godot;

namespace undergrowth {

static bool is_number(const Variant &value) {
	return value.get_type() == Variant::FLOAT || value.get_type() == Variant::INT;
}

static bool read_span(const Variant &value, Span &into) {
	if (is_number(value)) {
		into.first = into.last = float(double(value));
		return true;
	}
	const Vector2 both = value.get_type() == Variant::VECTOR2 ? Vector2(value) : Vector2();
	into = { both.x, both.y };
	return value.get_type() == Variant::VECTOR2;
}

static float *number_of(Arrangement &of, const String &name) {
	const struct {
		const char *name;
		float *slot;
	} numbers[] = { { "from", &of.from }, { "to", &of.to }, { "turn", &of.turn }, { "phase", &of.phase },
		{ "radius", &of.radius }, { "dome", &of.dome }, { "swept", &of.swept }, { "deviation", &of.deviation } };
	for (const auto &number : numbers) {
		if (name == number.name) {
			return number.slot;
		}
	}
	return nullptr;
}

static Span *span_of(Arrangement &of, const String &name) {
	return name == "angle" ? &of.angle : name == "scale" ? &of.scale : name == "tilt" ? &of.tilt : nullptr;
}

static String read_option(const String &name, const Variant &value, Arrangement &into) {
	float *number = number_of(into, name);
	Span *span = span_of(into, name);
	bool fits = is_number(value);
	if (number && fits) {
		*number = float(double(value));
	} else if (span) {
		fits = read_span(value, *span);
	} else if (name == "per_node" && value.get_type() == Variant::INT) {
		into.per_node = int(int64_t(value));
	} else if ((name == "level_tops" || name == "flat") && value.get_type() == Variant::BOOL) {
		(name == "flat" ? into.flat : into.level_tops) = bool(value);
		fits = true;
	} else if (!number) {
		return "`_grow` passed the option '" + name +
				"', which is unknown or of another type. Use from, to, turn, phase, per_node, angle, scale, radius, "
				"dome, level_tops, flat, tilt, swept and deviation.";
	}
	return fits ? String() : "`_grow` passed no number for '" + name + "'. Pass a number, or a Vector2 for a range.";
}

String read_options(const Dictionary &options, Arrangement &into) {
	const Array names = options.keys();
	String problem;
	for (int64_t i = 0; i < names.size() && problem.is_empty(); i++) {
		problem = read_option(names[i], options[names[i]], into);
	}
	return problem;
}

} // namespace undergrowth
