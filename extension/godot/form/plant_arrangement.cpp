#include "form/plant_arrangement.hpp"

#include "base/follow_changes.hpp"
#include "base/new_object.hpp"
#include "form/set_by_names.hpp"

#include <algorithm>

using namespace godot;

namespace undergrowth {

static constexpr int CURVE_SAMPLES = 17;
static constexpr Range TILT_DEGREES = { -720.0, 720.0 };

static std::vector<float> samples_of(const Ref<Curve> &curve) {
	std::vector<float> samples;
	for (int i = 0; curve.is_valid() && curve->get_point_count() > 0 && i < CURVE_SAMPLES; i++) {
		samples.push_back(float(curve->sample_baked(float(i) / (CURVE_SAMPLES - 1))));
	}
	return samples;
}

Ref<PlantArrangement> PlantArrangement::of(const Dictionary &values) {
	Ref<PlantArrangement> made = new_counted<PlantArrangement>();
	set_by_names(made.ptr(), values);
	return made;
}

String PlantArrangement::own_problem(const String &what) const {
	return describe(this) + ": " + what;
}

Arrangement PlantArrangement::described() const {
	Arrangement described = arrangement;
	described.angles = samples_of(angle_curve);
	described.scales = samples_of(scale_curve);
	return described;
}

// The index of this line must exist before the lines of the arrangements that it carries.
String PlantArrangement::read(Recipe &recipe, int on, int depth, std::vector<uint64_t> &known) {
	if (!visible) {
		return String();
	}
	if (depth > MAX_DEPTH) {
		return own_problem("it is carried in more than " + String::num_int64(MAX_DEPTH) +
				" levels, perhaps by itself. Remove it from an inner `carries`.");
	}
	if (part.is_null()) {
		return own_problem("it has no part. Set a PlantAxis, PlantBlade or PlantBead.");
	}
	const auto found = std::find(known.begin(), known.end(), uint64_t(part->get_instance_id()));
	const int kind = int(found - known.begin());
	if (found == known.end()) {
		known.push_back(uint64_t(part->get_instance_id()));
		recipe.kinds.emplace_back();
		const String problem = part->read(recipe.kinds.back());
		if (!problem.is_empty()) {
			return problem;
		}
	}
	const int line = int(recipe.lines.size());
	recipe.lines.push_back({ kind, described(), on });
	const std::string fault = find_arrangement_fault(recipe.lines.back().arrangement);
	if (!fault.empty()) {
		return own_problem(String::utf8(fault.c_str()));
	}
	for (int64_t i = 0; i < carries.size(); i++) {
		const Ref<PlantArrangement> other = carries[i];
		const String problem = other.is_valid() ? other->read(recipe, line, depth + 1, known) : String();
		if (!problem.is_empty()) {
			return problem;
		}
	}
	return String();
}

void PlantArrangement::report_change() {
	if (!is_reporting) {
		is_reporting = true;
		emit_changed();
		is_reporting = false;
	}
}

void PlantArrangement::on_changed() {
	report_change();
}

void PlantArrangement::follow(Resource *before, Resource *now) {
	const Callable changed(this, "_on_changed");
	unfollow_changes(before, changed);
	follow_changes(now, changed);
}

void PlantArrangement::change_number(float &slot, const char *property, double value, const Range &range) {
	if (accept_value(this, property, value, range) && float(value) != slot) {
		slot = float(value);
		report_change();
	}
}

void PlantArrangement::change_angle(float &slot, const char *property, double radians, const Range &degrees) {
	if (accept_angle(this, property, radians, degrees) && float(radians) != slot) {
		slot = float(radians);
		report_change();
	}
}

void PlantArrangement::set_span(Span &slot, const char *property, const Vector2 &value, const Range &range) {
	if (accept_value(this, property, value.x, range) && accept_value(this, property, value.y, range) &&
			value != Vector2(slot.first, slot.last)) {
		slot = { value.x, value.y };
		report_change();
	}
}

void PlantArrangement::set_angles(Span &slot, const char *property, const Vector2 &radians) {
	if (accept_angle(this, property, radians.x, TILT_DEGREES) &&
			accept_angle(this, property, radians.y, TILT_DEGREES) && radians != Vector2(slot.first, slot.last)) {
		slot = { radians.x, radians.y };
		report_change();
	}
}

void PlantArrangement::set_layout(ArrangementLayout layout) {
	if (layout < LAYOUT_ALONG || layout > LAYOUT_GROUND) {
		report_error(
				this, "layout " + String::num_int64(layout) + " does not exist. Use one of the LAYOUT_ constants.");
	} else if (Layout(layout) != arrangement.layout) {
		arrangement.layout = Layout(layout);
		notify_property_list_changed();
		report_change();
	}
}

void PlantArrangement::set_visible(bool shown) {
	if (shown != visible) {
		visible = shown;
		report_change();
	}
}

void PlantArrangement::set_part(const Ref<PlantPart> &kind) {
	if (kind != part) {
		follow(part.ptr(), kind.ptr());
		part = kind;
		report_change();
	}
}

void PlantArrangement::set_count(const Vector2i &range) {
	if (range.x < 0 || range.x > MAX_PARTS || range.y < 1 || range.y > MAX_PARTS) {
		report_error(this,
				"count cannot be " + String::num_int64(range.x) + " to " + String::num_int64(range.y) +
						"; the old value stays. Set 0 to " + String::num_int64(MAX_PARTS) +
						", the smaller number first, the larger 1 or more.");
		return;
	}
	Vector2 ordered(float(range.x), float(range.y));
	if (!accept_span(this, "count", get_count(), ordered, { 0.0, double(MAX_PARTS) })) {
		return;
	}
	const Vector2i count(int(ordered.x), int(ordered.y));
	if (count != get_count()) {
		arrangement.count_min = count.x;
		arrangement.count_max = count.y;
		report_change();
	}
}

void PlantArrangement::set_per_node(int count) {
	if (accept_value(this, "per_node", count, { 1.0, 64.0 }) && count != arrangement.per_node) {
		arrangement.per_node = count;
		report_change();
	}
}

void PlantArrangement::set_level_tops(bool level) {
	if (level != arrangement.level_tops) {
		arrangement.level_tops = level;
		report_change();
	}
}

void PlantArrangement::set_flat(bool flat) {
	if (flat != arrangement.flat) {
		arrangement.flat = flat;
		report_change();
	}
}

void PlantArrangement::set_angle_curve(const Ref<Curve> &curve) {
	if (curve != angle_curve) {
		follow(angle_curve.ptr(), curve.ptr());
		angle_curve = curve;
		report_change();
	}
}

void PlantArrangement::set_scale_curve(const Ref<Curve> &curve) {
	if (curve != scale_curve) {
		follow(scale_curve.ptr(), curve.ptr());
		scale_curve = curve;
		report_change();
	}
}

void PlantArrangement::set_carries(const TypedArray<PlantArrangement> &others) {
	for (int64_t i = 0; i < carries.size(); i++) {
		follow(Ref<PlantArrangement>(carries[i]).ptr(), nullptr);
	}
	carries = others.duplicate();
	for (int64_t i = 0; i < carries.size(); i++) {
		follow(nullptr, Ref<PlantArrangement>(carries[i]).ptr());
	}
	report_change();
}

Vector2 PlantArrangement::get_angle() const {
	return Vector2(arrangement.angle.first, arrangement.angle.last);
}

Vector2 PlantArrangement::get_tilt() const {
	return Vector2(arrangement.tilt.first, arrangement.tilt.last);
}

} // namespace undergrowth
