#include "field/plant_field_level.hpp"

#include "given_name.hpp"
#include "messages.hpp"
#include "new_object.hpp"
#include "plant/base_shape.hpp"

#include <godot_cpp/core/class_db.hpp>

using namespace godot;

namespace undergrowth {

static constexpr Range SEGMENTS_RANGE = { MIN_LOD, MAX_LOD };
static constexpr Range END_RANGE = { 0.0, 1e6 };

Ref<PlantFieldLevel> PlantFieldLevel::of(int segments, double end) {
	Ref<PlantFieldLevel> made = new_counted<PlantFieldLevel>();
	made->set_segments(segments);
	made->set_end(end);
	return made;
}

void PlantFieldLevel::level_changed() {
	const String way = end > 0.0 ? " to " + String::num(end) + " m" : String();
	give_name(this, given_name, String::num_int64(segments) + (segments == 1 ? " segment" : " segments") + way);
	emit_changed();
}

void PlantFieldLevel::set_segments(int count) {
	if (accept_value(this, "segments", count, SEGMENTS_RANGE) && count != segments) {
		segments = count;
		level_changed();
	}
}

int PlantFieldLevel::get_segments() const {
	return segments;
}

void PlantFieldLevel::set_end(double metres) {
	if (accept_value(this, "end", metres, END_RANGE) && metres != end) {
		end = metres;
		level_changed();
	}
}

double PlantFieldLevel::get_end() const {
	return end;
}

void PlantFieldLevel::_validate_property(PropertyInfo &property) const {
	hide_given_name(this, given_name, property);
}

void PlantFieldLevel::_bind_methods() {
	ClassDB::bind_static_method(
			"PlantFieldLevel", D_METHOD("of", "segments", "end"), &PlantFieldLevel::of, DEFVAL(0.0));
	ClassDB::bind_method(D_METHOD("set_segments", "segments"), &PlantFieldLevel::set_segments);
	ClassDB::bind_method(D_METHOD("get_segments"), &PlantFieldLevel::get_segments);
	ClassDB::bind_method(D_METHOD("set_end", "metres"), &PlantFieldLevel::set_end);
	ClassDB::bind_method(D_METHOD("get_end"), &PlantFieldLevel::get_end);

	ADD_PROPERTY(PropertyInfo(Variant::INT, "segments", PROPERTY_HINT_RANGE, "1,64,1"), "set_segments", "get_segments");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "end", PROPERTY_HINT_RANGE, "0,200,0.1,or_greater,suffix:m"), "set_end",
			"get_end");
}

} // namespace undergrowth
