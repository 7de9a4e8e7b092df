#pragma once

#include "stand/density_brush.hpp"

#include <godot_cpp/classes/image.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/rect2.hpp>

namespace undergrowth {

/// What is painted into PlantField3Ds: for each species, by its name, how much of it grows where and how high. Places
/// are in the field's own axes. Each change emits `area_changed` with the rectangle (x, z) around it, then `changed`.
class PlantMap : public godot::Resource {
	GDCLASS(PlantMap, godot::Resource)

	DensityMap map;
	godot::PackedByteArray unread; ///< Bytes that are no map: they stay as they are.
	godot::String fault; ///< Why.
	bool has_told = false; ///< That nothing can be painted on it.
	godot::PackedStringArray told_layers; ///< That nobody reads.

	void changed_in(const CellRange &cells);
	/// False, told once, where the map could not be read.
	bool may_change();
	/// False, with an error that names `method`, where that is no brush.
	bool read_brush(
			const char *method, const godot::Vector3 &center, double radius, double falloff, DensityBrush &into);
	/// The layer of a species, made where there is none; -1, with an error, where it cannot be.
	int need_layer(const char *method, const godot::String &species);
	bool read_rect(const char *method, const godot::Rect2 &rect, CellRange &into) const;
	/// False, with an error, where nothing can be painted in it.
	bool read_polygon(const char *method, const godot::PackedVector3Array &points, Polygon &into);
	void stroke(const char *method, const DensityBrush &brush, const godot::String &species,
			const DensityStroke &stroke, double strength);

protected:
	static void _bind_methods();
	void _validate_property(godot::PropertyInfo &property) const;

public:
	/// What fields grow by. They share it, and may keep it.
	const DensityMap &density() const { return map; }
	/// Why it cannot be used; empty where it can.
	const godot::String &problem() const { return fault; }

	/// A name that none of the fields reads that grow by this map: told once, in a game. In the editor species may come
	/// after what is painted of them.
	void tell_if_unread(const godot::String &species);

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
	void fill_polygon(const godot::PackedVector3Array &points, const godot::String &species, double density);
	void fill_polygon_plants(const godot::PackedVector3Array &points, const godot::String &species, double density);
	double get_plant_density(const godot::Vector3 &point, const godot::String &species) const;
	double get_density(const godot::Vector3 &point, const godot::String &species) const;
	double get_height_factor(const godot::Vector3 &point, const godot::String &species) const;
	void set_from_image(const godot::Ref<godot::Image> &image, const godot::Rect2 &rect, const godot::String &species,
			int channel, double white);
	godot::Ref<godot::Image> to_image(const godot::Rect2 &rect, const godot::String &species, double white) const;
	godot::Rect2 get_painted_rect() const;
	godot::PackedStringArray get_painted_species() const;
	void remove_species(const godot::String &species);
	void clear();
	/// A copy that shares what neither of the two changes.
	godot::Ref<PlantMap> snapshot() const;
	void restore(const godot::Ref<PlantMap> &from, const godot::Rect2 &rect);

	void set_cell_size(double metres);
	double get_cell_size() const { return double(map.cell_size()); }
	void set_data(const godot::PackedByteArray &bytes);
	godot::PackedByteArray get_data() const;
};

} // namespace undergrowth
