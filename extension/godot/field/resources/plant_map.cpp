#include "field/resources/plant_map.hpp"

#include "base/bind_properties.hpp"
#include "base/messages.hpp"
#include "base/new_object.hpp"
#include "nodes/plant_field_3d.hpp"
#include "placement/density_bytes.hpp"

#include <godot_cpp/classes/engine.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr Range PLANTS_RANGE = { 0.0, DensityCell::MAX_PLANT_DENSITY };
static constexpr double MAX_CELLS = 16.0e6; // Per call.
static constexpr int CHANNELS = 4;
static constexpr Range WHITE_RANGE = { 0.0, DensityCell::MAX_PLANT_DENSITY };

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

void PlantMap::paint_scale_jitter(
		const Vector3 &center, double radius, const String &species, double jitter, double strength, double falloff) {
	static constexpr Range JITTER_RANGE = { 0.0, 0.9 };
	DensityBrush brush;
	if (read_brush("paint_scale_jitter", center, radius, falloff, brush) &&
			accept_value(this, "jitter", jitter, JITTER_RANGE)) {
		const DensityStroke how = { DensityStroke::Does::set_scale_jitter, float(jitter), 1.0f };
		stroke("paint_scale_jitter", brush, species, how, strength);
	}
}

void PlantMap::paint_color_jitter(
		const Vector3 &center, double radius, const String &species, double jitter, double strength, double falloff) {
	DensityBrush brush;
	if (read_brush("paint_color_jitter", center, radius, falloff, brush) &&
			accept_value(this, "jitter", jitter, { 0.0, 1.0 })) {
		const DensityStroke how = { DensityStroke::Does::set_color_jitter, float(jitter), 1.0f };
		stroke("paint_color_jitter", brush, species, how, strength);
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

// Returns an unpainted cell for an unknown species and for a position that is not finite.
DensityCell PlantMap::cell_at(const Vector3 &point, const String &species) const {
	const int layer = map.find_layer(text_of(species));
	return layer < 0 || !point.is_finite() ? DensityCell() : map.cell_at(layer, place_of(point));
}

double PlantMap::get_plant_density(const Vector3 &point, const String &species) const {
	return double(cell_at(point, species).plant_density());
}

double PlantMap::get_density(const Vector3 &point, const String &species) const {
	return double(cell_at(point, species).share());
}

double PlantMap::get_height_factor(const Vector3 &point, const String &species) const {
	return double(cell_at(point, species).height_factor());
}

double PlantMap::get_scale_jitter(const Vector3 &point, const String &species) const {
	return double(cell_at(point, species).scale_range());
}

double PlantMap::get_color_jitter(const Vector3 &point, const String &species) const {
	return double(cell_at(point, species).color_range());
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
	BIND_BRUSH(paint_scale_jitter, "jitter", "strength", "falloff"), &PlantMap::paint_scale_jitter, DEFVAL(1.0),
			DEFVAL(0.5));
	BIND_BRUSH(paint_color_jitter, "jitter", "strength", "falloff"), &PlantMap::paint_color_jitter, DEFVAL(1.0),
			DEFVAL(0.5));
#undef BIND_BRUSH
	ClassDB::bind_method(
			D_METHOD("fill_polygon", "points", "species", "density"), &PlantMap::fill_polygon, DEFVAL(1.0));
	ClassDB::bind_method(
			D_METHOD("fill_polygon_plants", "points", "species", "density"), &PlantMap::fill_polygon_plants);
	BIND(get_density, "point", "species");
	BIND(get_plant_density, "point", "species");
	BIND(get_height_factor, "point", "species");
	BIND(get_scale_jitter, "point", "species");
	BIND(get_color_jitter, "point", "species");
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

static PackedByteArray packed(const std::vector<uint8_t> &bytes) {
	PackedByteArray made;
	made.resize(int64_t(bytes.size()));
	std::copy(bytes.begin(), bytes.end(), made.ptrw());
	return made;
}

bool PlantMap::read_rect(const char *method, const Rect2 &rect, CellRange &into) const {
	const Vector2 end = rect.get_end();
	into = rect.is_finite() ? map.cells_around({ { rect.position.x, rect.position.y }, { end.x, end.y } })
							: CellRange();
	if (into.is_empty() || into.count() > MAX_CELLS) {
		report_error(this,
				String(method) +
						"() needs a rectangle within 100 km of the field's origin, of up to 16 million cells.");
		return false;
	}
	return true;
}

// Returns the cells with middles in a rectangle.
static CellRange middles_in(const DensityMap &map, const Rect2 &rect) {
	const float half = 0.5f * map.cell_size();
	const Vector2 end = rect.get_end();
	CellRange cells =
			map.cells_around({ { rect.position.x + half, rect.position.y + half }, { end.x + half, end.y + half } });
	cells.last_column = std::max(cells.last_column - 1, cells.first_column);
	cells.last_row = std::max(cells.last_row - 1, cells.first_row);
	return cells;
}

void PlantMap::set_from_image(
		const Ref<Image> &image, const Rect2 &rect, const String &species, int channel, double white) {
	CellRange cells;
	if (image.is_null() || image->is_empty() || channel < 0 || channel >= CHANNELS) {
		report_error(this, "set_from_image() needs an image with pixels, and a channel from 0 (red) to 3 (alpha).");
		return;
	}
	if (!read_rect("set_from_image", rect, cells) || !accept_value(this, "white", white, WHITE_RANGE) ||
			!may_change()) {
		return;
	}
	warn_if_unread(species);
	const int layer = need_layer("set_from_image", species);
	if (layer < 0) {
		return;
	}
	cells = middles_in(map, rect);
	const int columns = cells.last_column - cells.first_column + 1;
	const int rows = cells.last_row - cells.first_row + 1;
	Ref<Image> fitted = image->duplicate();
	if (fitted->is_compressed()) {
		fitted->decompress();
	}
	fitted->convert(Image::FORMAT_RGBA8);
	fitted->resize(columns, rows, Image::INTERPOLATE_BILINEAR);
	const PackedByteArray pixels = fitted->get_data();
	const uint8_t *from = pixels.ptr() + channel;
	for (int i = 0; i < columns * rows; i++) {
		const int column = cells.first_column + i % columns;
		const int row = cells.first_row + i / columns;
		DensityCell cell = map.cell(layer, column, row);
		cell.density = from[int64_t(i) * CHANNELS];
		cell.plants = white > 0.0 ? plants_code(float(white) * cell.share()) : uint16_t(0);
		cell.density = white > 0.0 ? uint8_t(0) : cell.density;
		map.set_cell(layer, column, row, cell);
	}
	map.tidy(layer, cells);
	changed_in(cells);
}

void PlantMap::warn_if_unread(const String &species) {
	if (species.is_empty() || reported_layers.has(species) || Engine::get_singleton()->is_editor_hint()) {
		return;
	}
	PackedStringArray read;
	const TypedArray<Dictionary> listeners = get_signal_connection_list("area_changed");
	for (int64_t i = 0; i < listeners.size(); i++) {
		const Callable listener = Dictionary(listeners[i])["callable"];
		const PlantField3D *field = Object::cast_to<PlantField3D>(listener.get_object());
		const PackedStringArray own = field ? field->read_layers() : PackedStringArray();
		if (field && own.is_empty()) {
			return; // The field reports it after its build.
		}
		read.append_array(own);
	}
	if (!read.is_empty() && !read.has(species)) {
		reported_layers.push_back(species);
		report_warning(this,
				"'" + species +
						"' is no species of the fields with this map, so its paint has no effect. Use one of '" +
						String("', '").join(read) + "', or set the Layer of an entry of a field's species.");
	}
}

Ref<Image> PlantMap::to_image(const Rect2 &rect, const String &species, double white) const {
	CellRange cells;
	if (!read_rect("to_image", rect, cells) || !accept_value(this, "white", white, WHITE_RANGE)) {
		return Ref<Image>();
	}
	cells = middles_in(map, rect);
	const int columns = cells.last_column - cells.first_column + 1;
	const int rows = cells.last_row - cells.first_row + 1;
	const int layer = map.find_layer(std::string(species.utf8().get_data()));
	PackedByteArray pixels;
	pixels.resize(int64_t(columns) * rows);
	uint8_t *to = pixels.ptrw();
	for (int i = 0; i < columns * rows; i++) {
		const DensityCell cell = layer < 0
				? DensityCell()
				: map.cell(layer, cells.first_column + i % columns, cells.first_row + i / columns);
		to[i] = white > 0.0 ? density_code(cell.plant_density() / float(white)) : cell.density;
	}
	return Image::create_from_data(columns, rows, false, Image::FORMAT_L8, pixels);
}

Rect2 PlantMap::get_painted_rect() const {
	const AreaBox box = map.box_of(map.painted());
	return Rect2(box.low.x, box.low.y, box.high.x - box.low.x, box.high.y - box.low.y);
}

Ref<PlantMap> PlantMap::snapshot() const {
	Ref<PlantMap> copy;
	copy.instantiate();
	copy->map = map.share();
	copy->unread = unread;
	copy->fault = fault;
	return copy;
}

void PlantMap::restore(const Ref<PlantMap> &from, const Rect2 &rect) {
	CellRange cells;
	if (from.is_null() || from->get_cell_size() != get_cell_size()) {
		report_error(this, "restore() needs a map of cells of the same size.");
	} else if (read_rect("restore", rect, cells) && may_change()) {
		changed_in(map.take(from->map, cells));
	}
}

void PlantMap::set_data(const PackedByteArray &bytes) {
	const CellRange before = map.painted();
	const DensityFault found = read_density(bytes.ptr(), size_t(bytes.size()), map);
	unread = found == DensityFault::none ? PackedByteArray() : bytes;
	fault = found == DensityFault::none ? String() : String(undergrowth::describe(found));
	has_reported = false;
	if (found != DensityFault::none) {
		map.clear();
		report_error(this, fault);
	}
	CellRange cells = map.painted();
	cells.take_in(before);
	changed_in(cells);
}

PackedByteArray PlantMap::get_data() const {
	return fault.is_empty() ? packed(write_density(map)) : unread;
}

} // namespace undergrowth
