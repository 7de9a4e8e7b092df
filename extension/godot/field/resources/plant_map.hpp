#pragma once

#include "placement/density_brush.hpp"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/rect2.hpp>

namespace undergrowth {

/// A painted map of PlantField3Ds: densities, heights and jitter of plants, in one layer per species. Positions are in
/// the field's own axes. Each change emits `area_changed` with the rectangle (x, z) around it, then `changed`.
class PlantMap : public godot::Resource {
	GDCLASS(PlantMap, godot::Resource)

	DensityMap map;
	godot::PackedByteArray unread; ///< Bytes that are not a valid map, saved unchanged.
	godot::String fault; ///< Reason of that; empty if the map is valid.
	bool has_reported = false; ///< True if the error of may_change() was reported.
	godot::PackedStringArray reported_layers; ///< Layers that no field reads and that were reported.

	void changed_in(const CellRange &cells);
	/// Returns false if the map is invalid; reports it once.
	bool may_change();
	/// Returns false, with an error that contains `method`, if the brush is invalid.
	bool read_brush(
			const char *method, const godot::Vector3 &center, double radius, double falloff, DensityBrush &into);
	/// Returns the layer of a species, created if missing. On failure: -1, with an error.
	int need_layer(const char *method, const godot::String &species);
	bool read_rect(const char *method, const godot::Rect2 &rect, CellRange &into) const;
	/// Returns false, with an error, if the polygon is invalid or the map cannot be changed.
	bool read_polygon(const char *method, const godot::PackedVector3Array &points, Polygon &into);
	DensityCell cell_at(const godot::Vector3 &point, const godot::String &species) const;
	void stroke(const char *method, const DensityBrush &brush, const godot::String &species,
			const DensityStroke &stroke, double strength);

protected:
	static void _bind_methods();
	void _validate_property(godot::PropertyInfo &property) const;

public:
	/// The map that fields are built from. Fields take copies that share its data (DensityMap::share()).
	const DensityMap &density() const { return map; }
	/// Why the map is invalid; empty if it is valid.
	const godot::String &problem() const { return fault; }

	/// Warns once, in a game, about a layer that none of the fields with this map reads. Not in the editor, where a
	/// species may be added after its layer is painted.
	void warn_if_unread(const godot::String &species);

	void paint(
			const godot::Vector3 &center, double radius, const godot::String &species, double amount, double falloff);
	void erase(
			const godot::Vector3 &center, double radius, const godot::String &species, double amount, double falloff);
	void paint_towards(const godot::Vector3 &center, double radius, const godot::String &species, double density,
			double strength, double falloff);
	void paint_plants(const godot::Vector3 &center, double radius, const godot::String &species, double density,
			double strength, double falloff);
	void smooth(
			const godot::Vector3 &center, double radius, const godot::String &species, double strength, double falloff);
	void paint_height(const godot::Vector3 &center, double radius, const godot::String &species, double height,
			double strength, double falloff);
	void paint_scale_jitter(const godot::Vector3 &center, double radius, const godot::String &species, double jitter,
			double strength, double falloff);
	void paint_color_jitter(const godot::Vector3 &center, double radius, const godot::String &species, double jitter,
			double strength, double falloff);
	void fill_polygon(const godot::PackedVector3Array &points, const godot::String &species, double density);
	void fill_polygon_plants(const godot::PackedVector3Array &points, const godot::String &species, double density);
	double get_plant_density(const godot::Vector3 &point, const godot::String &species) const;
	double get_density(const godot::Vector3 &point, const godot::String &species) const;
	double get_height_factor(const godot::Vector3 &point, const godot::String &species) const;
	double get_scale_jitter(const godot::Vector3 &point, const godot::String &species) const;
	double get_color_jitter(const godot::Vector3 &point, const godot::String &species) const;
	void set_from_image(const godot::Ref<godot::Image> &image, const godot::Rect2 &rect, const godot::String &species,
			int channel, double white);
	godot::Ref<godot::Image> to_image(const godot::Rect2 &rect, const godot::String &species, double white) const;
	godot::Rect2 get_painted_rect() const;
	godot::PackedStringArray get_painted_species() const;
	void remove_species(const godot::String &species);
	void clear();
	/// Returns a copy that shares all data until one of the two changes.
	godot::Ref<PlantMap> snapshot() const;
	void restore(const godot::Ref<PlantMap> &from, const godot::Rect2 &rect);

	void set_cell_size(double metres);
	double get_cell_size() const { return double(map.cell_size()); }
	void set_data(const godot::PackedByteArray &bytes);
	godot::PackedByteArray get_data() const;
};

} // namespace undergrowth
