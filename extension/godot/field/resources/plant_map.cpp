// Changes of a PlantMap. plant_map_data.cpp has saving and images.

#include "field/resources/plant_map.hpp"

#include "base/bind_properties.hpp"
#include "base/messages.hpp"

#include <cmath>
#include <string>

using namespace godot;

namespace undergrowth {

static constexpr Range PLANTS_RANGE = { 0.0, DensityCell::MAX_PLANT_DENSITY };

static std::string text_of(const String &name) {
	return std::string(name.utf8().get_data());
}

static glm::vec2 place_of(const Vector3 &point) {
	return { point.x, point.z };
}

void PlantMap::changed_in(const CellRange &cells) {
	if (!cells.is_empty()) {
		const AreaBox box = map.box_of(cells);
		const Vector2 low(box.low.x, box.low.y);
		emit_signal("area_changed", Rect2(low, Vector2(box.high.x, box.high.y) - low));
		emit_changed();
	}
}

bool PlantMap::may_change() {
	if (!fault.is_empty() && !has_reported) {
		has_reported = true;
		report_error(this, "cannot be changed: " + fault + " Its contents stay unchanged.");
	}
	return fault.is_empty();
}

bool PlantMap::read_brush(
		const char *method, const Vector3 &center, double radius, double falloff, DensityBrush &into) {
	into = { place_of(center), float(radius), float(falloff) };
	if (!is_valid(into)) {
		report_error(this,
				String(method) +
						"() needs a centre within 100 km of the field's origin, a radius above 0 and up to 100 m, and "
						"a "
						"falloff from 0 to 1.");
		return false;
	}
	return may_change();
}

int PlantMap::need_layer(const char *method, const String &species) {
	const int layer = map.need_layer(text_of(species));
	if (layer < 0) {
		report_error(this,
				String(method) +
						"() needs the name of a species (PlantFieldSpecies.get_layer_name()) with up to 255 bytes; a "
						"map has up to 256 of them.");
	}
	return layer;
}

void PlantMap::stroke(const char *method, const DensityBrush &brush, const String &species, const DensityStroke &how,
		double strength) {
	DensityStroke does = how;
	does.strength = float(strength);
	if (!std::isfinite(does.value) || !(strength >= 0.0 && strength <= 1.0)) {
		report_error(this, String(method) + "() needs finite numbers, and a strength from 0 to 1.");
		return;
	}
	// Only strokes that add create a layer. All other strokes apply to every layer if `species` is empty.
	const bool makes =
			how.does != DensityStroke::Does::smooth && !(how.does == DensityStroke::Does::add && how.value < 0);
	warn_if_unread(species);
	const int first = makes ? need_layer(method, species) : species.is_empty() ? 0 : map.find_layer(text_of(species));
	const int last = !makes && species.is_empty() ? map.layer_count() - 1 : first;
	CellRange cells;
	for (int layer = first; layer >= 0 && layer <= last; layer++) {
		cells.take_in(undergrowth::paint(map, layer, brush, does));
	}
	changed_in(cells);
}

void PlantMap::paint(const Vector3 &center, double radius, const String &species, double amount, double falloff) {
	DensityBrush brush;
	if (read_brush("paint", center, radius, falloff, brush) && accept_value(this, "amount", amount, { 0.0, 1.0 })) {
		stroke("paint", brush, species, { DensityStroke::Does::add, float(amount), 1.0f }, 1.0);
	}
}

void PlantMap::erase(const Vector3 &center, double radius, const String &species, double amount, double falloff) {
	DensityBrush brush;
	if (read_brush("erase", center, radius, falloff, brush) && accept_value(this, "amount", amount, { 0.0, 1.0 })) {
		stroke("erase", brush, species, { DensityStroke::Does::add, -float(amount), 1.0f }, 1.0);
	}
}

void PlantMap::paint_towards(
		const Vector3 &center, double radius, const String &species, double density, double strength, double falloff) {
	DensityBrush brush;
	if (read_brush("paint_towards", center, radius, falloff, brush)) {
		stroke("paint_towards", brush, species, { DensityStroke::Does::approach, float(density), 1.0f }, strength);
	}
}

void PlantMap::paint_plants(
		const Vector3 &center, double radius, const String &species, double density, double strength, double falloff) {
	DensityBrush brush;
	if (read_brush("paint_plants", center, radius, falloff, brush) &&
			accept_value(this, "density", density, PLANTS_RANGE)) {
		const DensityStroke how = { DensityStroke::Does::approach_plants, float(density), 1.0f };
		stroke("paint_plants", brush, species, how, strength);
	}
}

void PlantMap::smooth(const Vector3 &center, double radius, const String &species, double strength, double falloff) {
	DensityBrush brush;
	if (read_brush("smooth", center, radius, falloff, brush)) {
		stroke("smooth", brush, species, { DensityStroke::Does::smooth, 0.0f, 1.0f }, strength);
	}
}

void PlantMap::paint_height(
		const Vector3 &center, double radius, const String &species, double height, double strength, double falloff) {
	DensityBrush brush;
	if (read_brush("paint_height", center, radius, falloff, brush)) {
		stroke("paint_height", brush, species, { DensityStroke::Does::set_height, float(height), 1.0f }, strength);
	}
}

bool PlantMap::read_polygon(const char *method, const PackedVector3Array &points, Polygon &into) {
	for (const Vector3 &point : points) {
		into.push_back(place_of(point));
	}
	const AreaFault area = find_area_fault(into);
	if (area != AreaFault::none) {
		report_error(this, String(method) + "(): " + undergrowth::describe(area));
		return false;
	}
	const AreaBox box = bounding_box(into);
	const Rect2 rect(box.low.x, box.low.y, box.high.x - box.low.x, box.high.y - box.low.y);
	CellRange cells;
	return read_rect(method, rect, cells) && may_change();
}

void PlantMap::fill_polygon(const PackedVector3Array &points, const String &species, double density) {
	Polygon polygon;
	if (!read_polygon("fill_polygon", points, polygon) || !accept_value(this, "density", density, { 0.0, 1.0 })) {
		return;
	}
	warn_if_unread(species);
	const int layer = need_layer("fill_polygon", species);
	if (layer >= 0) {
		changed_in(undergrowth::fill_polygon(map, layer, polygon, float(density)));
	}
}

void PlantMap::fill_polygon_plants(const PackedVector3Array &points, const String &species, double density) {
	Polygon polygon;
	if (!read_polygon("fill_polygon_plants", points, polygon) ||
			!accept_value(this, "density", density, PLANTS_RANGE)) {
		return;
	}
	warn_if_unread(species);
	const int layer = need_layer("fill_polygon_plants", species);
	if (layer >= 0) {
		changed_in(undergrowth::fill_polygon_plants(map, layer, polygon, float(density)));
	}
}

double PlantMap::get_plant_density(const Vector3 &point, const String &species) const {
	const int layer = map.find_layer(text_of(species));
	return layer < 0 || !point.is_finite() ? 0.0 : double(map.cell_at(layer, place_of(point)).plant_density());
}

double PlantMap::get_density(const Vector3 &point, const String &species) const {
	const int layer = map.find_layer(text_of(species));
	return layer < 0 || !point.is_finite() ? 0.0 : double(map.cell_at(layer, place_of(point)).share());
}

double PlantMap::get_height_factor(const Vector3 &point, const String &species) const {
	const int layer = map.find_layer(text_of(species));
	return layer < 0 || !point.is_finite() ? 1.0 : double(map.cell_at(layer, place_of(point)).height_factor());
}

PackedStringArray PlantMap::get_painted_species() const {
	PackedStringArray names;
	for (int layer = 0; layer < map.layer_count(); layer++) {
		if (!map.blocks(layer).empty()) {
			names.push_back(String::utf8(map.layer_name(layer).c_str()));
		}
	}
	return names;
}

void PlantMap::remove_species(const String &species) {
	const int layer = map.find_layer(text_of(species));
	if (layer >= 0 && may_change()) {
		const CellRange cells = map.painted();
		map.remove_layer(layer);
		changed_in(cells);
	}
}

void PlantMap::clear() {
	const CellRange cells = map.painted();
	map.clear();
	unread.clear();
	fault = String();
	has_reported = false;
	changed_in(cells);
}

void PlantMap::set_cell_size(double metres) {
	static constexpr Range CELL_RANGE = { DensityMap::MIN_CELL, DensityMap::MAX_CELL };
	if (!accept_value(this, "cell_size", metres, CELL_RANGE) || float(metres) == map.cell_size()) {
		return;
	}
	if (map.block_count() > 0 || !fault.is_empty()) {
		report_error(this, "cannot change its cell_size, because it is painted. Use a new map.");
		return;
	}
	map = DensityMap(float(metres));
	emit_changed();
}

void PlantMap::_validate_property(PropertyInfo &property) const {
	if (property.name == StringName("data")) {
		property.usage = PROPERTY_USAGE_STORAGE;
	} else if (property.name == StringName("cell_size")) {
		// `data` contains it. The inspector shows it while it can be changed.
		property.usage = map.block_count() > 0 ? PROPERTY_USAGE_NONE : PROPERTY_USAGE_DEFAULT;
	}
}

void PlantMap::_bind_methods() {
#define BIND_BRUSH(m_name, ...) ClassDB::bind_method(D_METHOD(#m_name, "center", "radius", "species", __VA_ARGS__)
	BIND_BRUSH(paint, "amount", "falloff"), &PlantMap::paint, DEFVAL(1.0), DEFVAL(0.5));
	BIND_BRUSH(erase, "amount", "falloff"), &PlantMap::erase, DEFVAL(String()), DEFVAL(1.0), DEFVAL(0.5));
	BIND_BRUSH(paint_towards, "density", "strength", "falloff"), &PlantMap::paint_towards, DEFVAL(1.0), DEFVAL(0.5));
	BIND_BRUSH(paint_plants, "density", "strength", "falloff"), &PlantMap::paint_plants, DEFVAL(1.0), DEFVAL(0.5));
	BIND_BRUSH(smooth, "strength", "falloff"), &PlantMap::smooth, DEFVAL(String()), DEFVAL(1.0), DEFVAL(0.5));
	BIND_BRUSH(paint_height, "height", "strength", "falloff"), &PlantMap::paint_height, DEFVAL(1.0), DEFVAL(0.5));
#undef BIND_BRUSH
	ClassDB::bind_method(
			D_METHOD("fill_polygon", "points", "species", "density"), &PlantMap::fill_polygon, DEFVAL(1.0));
	ClassDB::bind_method(
			D_METHOD("fill_polygon_plants", "points", "species", "density"), &PlantMap::fill_polygon_plants);
	BIND(get_density, "point", "species");
	BIND(get_plant_density, "point", "species");
	BIND(get_height_factor, "point", "species");
	ClassDB::bind_method(D_METHOD("set_from_image", "image", "rect", "species", "channel", "white"),
			&PlantMap::set_from_image, DEFVAL(0), DEFVAL(0.0));
	ClassDB::bind_method(D_METHOD("to_image", "rect", "species", "white"), &PlantMap::to_image, DEFVAL(0.0));
	BIND(get_painted_rect);
	BIND(get_painted_species);
	BIND(remove_species, "species");
	BIND(clear);
	BIND(snapshot);
	BIND(restore, "from", "rect");
	PROPERTY(FLOAT, cell_size, SLIDER("0.25,2,0.05,suffix:m"));
	PROPERTY(PACKED_BYTE_ARRAY, data);
	ADD_SIGNAL(MethodInfo("area_changed", PropertyInfo(Variant::RECT2, "rect")));
}

} // namespace undergrowth
