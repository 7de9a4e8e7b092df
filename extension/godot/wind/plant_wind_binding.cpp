// PlantWind: bindings.

#include "base/renamed_properties.hpp"
#include "wind/plant_wind.hpp"

#include <godot_cpp/core/class_db.hpp>

#include <algorithm>
#include <iterator>

using namespace godot;

namespace undergrowth {

void PlantWind::_validate_property(PropertyInfo &property) const {
	static const char *const air_only[] = { "speed", "turbulence", "gustiness", "roughness", "canopy_height",
		"canopy_wave_amount", "scene_wind" };
	static const char *const newtons_only[] = { "strength", "frequency", "travel_speed" };
	const String name = property.name;
	const auto is_in = [&](const auto &names) {
		return std::any_of(std::begin(names), std::end(names), [&](const char *one) { return name == one; });
	};
	const bool is_periodic = blowing.wind.kind == WindKind::bursts || blowing.wind.kind == WindKind::waves;
	const bool is_air = blowing.wind.kind == WindKind::air;
	if (is_air ? is_in(newtons_only) : is_in(air_only) || (name == String("frequency") && !is_periodic)) {
		property.usage = PROPERTY_USAGE_NO_EDITOR;
	}
}

void PlantWind::bind_precipitation() {
	ClassDB::bind_method(D_METHOD("set_wetness", "share"), &PlantWind::set_wetness);
	ClassDB::bind_method(D_METHOD("get_wetness"), &PlantWind::get_wetness);
	ClassDB::bind_method(D_METHOD("set_snow", "share"), &PlantWind::set_snow);
	ClassDB::bind_method(D_METHOD("get_snow"), &PlantWind::get_snow);
	ClassDB::bind_method(D_METHOD("set_rain", "millimetres_per_hour"), &PlantWind::set_rain);
	ClassDB::bind_method(D_METHOD("get_rain"), &PlantWind::get_rain);
	ADD_GROUP("Rain and Snow", "");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "rain", PROPERTY_HINT_RANGE, "0,100,0.1,or_greater,suffix:mm/h"),
			"set_rain", "get_rain");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "wetness", PROPERTY_HINT_RANGE, "0,1,0.01"), "set_wetness", "get_wetness");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "snow", PROPERTY_HINT_RANGE, "0,1,0.01"), "set_snow", "get_snow");
}

void PlantWind::bind_air() {
	ClassDB::bind_method(D_METHOD("set_speed", "metres_per_second"), &PlantWind::set_speed);
	ClassDB::bind_method(D_METHOD("get_speed"), &PlantWind::get_speed);
	ClassDB::bind_method(D_METHOD("set_turbulence", "share"), &PlantWind::set_turbulence);
	ClassDB::bind_method(D_METHOD("get_turbulence"), &PlantWind::get_turbulence);
	ClassDB::bind_method(D_METHOD("set_gustiness", "gustiness"), &PlantWind::set_gustiness);
	ClassDB::bind_method(D_METHOD("get_gustiness"), &PlantWind::get_gustiness);
	ClassDB::bind_method(D_METHOD("set_roughness", "metres"), &PlantWind::set_roughness);
	ClassDB::bind_method(D_METHOD("get_roughness"), &PlantWind::get_roughness);
	ClassDB::bind_method(D_METHOD("set_canopy_height", "metres"), &PlantWind::set_canopy_height);
	ClassDB::bind_method(D_METHOD("get_canopy_height"), &PlantWind::get_canopy_height);
	ClassDB::bind_method(D_METHOD("set_canopy_wave_amount", "share"), &PlantWind::set_canopy_wave_amount);
	ClassDB::bind_method(D_METHOD("get_canopy_wave_amount"), &PlantWind::get_canopy_wave_amount);
	ClassDB::bind_method(D_METHOD("get_beaufort"), &PlantWind::get_beaufort);
	ClassDB::bind_method(D_METHOD("sample_velocity", "time", "place"), &PlantWind::sample_velocity);
	ClassDB::bind_method(D_METHOD("sample_over_canopy", "time", "places"), &PlantWind::sample_over_canopy);
	ClassDB::bind_method(D_METHOD("apply_to_material", "material"), &PlantWind::apply_to_material);
	ClassDB::bind_method(D_METHOD("blend_to", "wind", "seconds"), &PlantWind::blend_to);

	const auto add = [](const char *name, const char *range) {
		ClassDB::add_property("PlantWind", PropertyInfo(Variant::FLOAT, name, PROPERTY_HINT_RANGE, range),
				StringName(String("set_") + name), StringName(String("get_") + name));
	};
	add("speed", "0,40,0.1,or_greater,suffix:m/s");
	add("turbulence", "-1,1,0.01,or_greater");
	add("gustiness", "0,0.15,0.01,or_greater");
	add("roughness", "0.001,0.5,0.001,exp,or_less,suffix:m");
	add("canopy_height", "0,3,0.01,or_greater,suffix:m");
	add("canopy_wave_amount", "0,1,0.01");
}

bool PlantWind::_set(const StringName &name, const Variant &value) {
	return set_renamed_property(
			this, name, value, { { "stand_height", "canopy_height" }, { "wave_share", "canopy_wave_amount" } });
}

void PlantWind::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_kind", "kind"), &PlantWind::set_kind);
	ClassDB::bind_method(D_METHOD("get_kind"), &PlantWind::get_kind);
	ClassDB::bind_method(D_METHOD("set_strength", "newtons"), &PlantWind::set_strength);
	ClassDB::bind_method(D_METHOD("get_strength"), &PlantWind::get_strength);
	ClassDB::bind_method(D_METHOD("set_direction", "radians"), &PlantWind::set_direction);
	ClassDB::bind_method(D_METHOD("get_direction"), &PlantWind::get_direction);
	ClassDB::bind_method(D_METHOD("set_frequency", "hertz"), &PlantWind::set_frequency);
	ClassDB::bind_method(D_METHOD("get_frequency"), &PlantWind::get_frequency);
	ClassDB::bind_method(D_METHOD("set_gust_duration", "seconds"), &PlantWind::set_gust_duration);
	ClassDB::bind_method(D_METHOD("get_gust_duration"), &PlantWind::get_gust_duration);
	ClassDB::bind_method(D_METHOD("sample", "time"), &PlantWind::sample);
	ClassDB::bind_method(D_METHOD("set_travel_speed", "metres_per_second"), &PlantWind::set_travel_speed);
	ClassDB::bind_method(D_METHOD("get_travel_speed"), &PlantWind::get_travel_speed);
	ClassDB::bind_method(
			D_METHOD("trigger_gust", "strength", "duration"), &PlantWind::trigger_gust, DEFVAL(-1.0), DEFVAL(-1.0));
	ClassDB::bind_method(D_METHOD("get_time"), &PlantWind::get_time);
	ClassDB::bind_method(D_METHOD("advance", "seconds"), &PlantWind::advance);

	ADD_PROPERTY(PropertyInfo(Variant::INT, "kind", PROPERTY_HINT_ENUM, "Gust,Constant,Bursts,Waves,Air"), "set_kind",
			"get_kind");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "strength", PROPERTY_HINT_RANGE, "0,50,0.1,or_greater,suffix:N"),
			"set_strength", "get_strength");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "direction", PROPERTY_HINT_RANGE,
						 "0,360,0.1,or_less,or_greater,radians_as_degrees"),
			"set_direction", "get_direction");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "frequency", PROPERTY_HINT_RANGE, "0,5,0.01,or_greater,suffix:Hz"),
			"set_frequency", "get_frequency");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "gust_duration", PROPERTY_HINT_RANGE, "0,10,0.01,or_greater,suffix:s"),
			"set_gust_duration", "get_gust_duration");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "travel_speed", PROPERTY_HINT_RANGE, "0,50,0.1,or_greater,suffix:m/s"),
			"set_travel_speed", "get_travel_speed");
	bind_air();
	ClassDB::bind_method(D_METHOD("set_scene_wind", "on"), &PlantWind::set_scene_wind);
	ClassDB::bind_method(D_METHOD("get_scene_wind"), &PlantWind::get_scene_wind);
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "scene_wind"), "set_scene_wind", "get_scene_wind");
	bind_precipitation();

	BIND_ENUM_CONSTANT(KIND_GUST);
	BIND_ENUM_CONSTANT(KIND_CONSTANT);
	BIND_ENUM_CONSTANT(KIND_BURSTS);
	BIND_ENUM_CONSTANT(KIND_WAVES);
	BIND_ENUM_CONSTANT(KIND_AIR);
}

} // namespace undergrowth
