#include "field/resources/plant_field_level.hpp"

#include "base/auto_name.hpp"
#include "base/bind_properties.hpp"
#include "base/messages.hpp"
#include "base/new_object.hpp"
#include "base/renamed_properties.hpp"
#include "plant/base_shape.hpp"

using namespace godot;

namespace undergrowth {

Ref<PlantFieldLevel> PlantFieldLevel::of(int segments, double end, double density) {
	Ref<PlantFieldLevel> made = new_counted<PlantFieldLevel>();
	made->set_segments(segments);
	made->set_end(end);
	made->set_density(density);
	return made;
}

void PlantFieldLevel::level_changed() {
	const String way = end > 0.0 ? " to " + String::num(end) + " m" : String();
	update_auto_name(this, auto_name, String::num_int64(segments) + (segments == 1 ? " segment" : " segments") + way);
	emit_changed();
}

void PlantFieldLevel::set_segments(int count) {
	if (accept_value(this, "segments", count, { MIN_LOD, MAX_LOD }) && count != segments) {
		segments = count;
		level_changed();
	}
}

void PlantFieldLevel::set_end(double metres) {
	if (accept_value(this, "end", metres, { 0.0, 1e6 }) && metres != end) {
		end = metres;
		level_changed();
	}
}

void PlantFieldLevel::set_density(double value) {
	if (accept_value(this, "density", value, { 0.0, 1.0 }) && value != density) {
		density = value;
		level_changed();
	}
}

void PlantFieldLevel::_validate_property(PropertyInfo &property) const {
	hide_auto_name(this, auto_name, property);
}

bool PlantFieldLevel::_set(const StringName &name, const Variant &value) {
	return set_renamed_property(this, name, value, { { "share", "density" } });
}

void PlantFieldLevel::_bind_methods() {
	ClassDB::bind_static_method("PlantFieldLevel", D_METHOD("of", "segments", "end", "density"), &PlantFieldLevel::of,
			DEFVAL(0.0), DEFVAL(1.0));
	PROPERTY(INT, segments, SLIDER("1,64,1"));
	PROPERTY(FLOAT, end, SLIDER("0,200,0.1,or_greater,suffix:m"));
	PROPERTY(FLOAT, density, SLIDER("0,1,0.01"));
}

} // namespace undergrowth
