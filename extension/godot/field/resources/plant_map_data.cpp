// Saving of a PlantMap, and conversion to and from images.

#include "field/resources/plant_map.hpp"

#include "base/messages.hpp"
#include "base/new_object.hpp"
#include "nodes/plant_field_3d.hpp"
#include "placement/density_bytes.hpp"

#include <godot_cpp/classes/engine.hpp>

#include <algorithm>
#include <string>
#include <utility>

using namespace godot;

namespace undergrowth {

static constexpr double MAX_CELLS = 16.0e6; // Per call.
static constexpr int CHANNELS = 4;
static constexpr Range WHITE_RANGE = { 0.0, DensityCell::MAX_PLANT_DENSITY };

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
		DensityCell cell = { from[int64_t(i) * CHANNELS], map.cell(layer, column, row).height, 0 };
		if (white > 0.0) {
			cell.plants = plants_code(float(white) * cell.share());
			cell.density = 0;
		}
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
