#pragma once

#include "field/resources/plant_habitat.hpp"
#include "species/plant_function.hpp"

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/vector2.hpp>

namespace undergrowth {

/// One species of a PlantField3D: its weight among all species, its habitat and the variation of its plants. Emits
/// `changed` for each real change of a number, of the species, and of the species' own properties.
class PlantFieldSpecies : public godot::Resource {
	GDCLASS(PlantFieldSpecies, godot::Resource)

public:
	/// Kind of a change, by what a field has to do.
	enum ChangeKind : int64_t {
		CHANGE_NONE, ///< `changed` is not emitted now.
		CHANGE_PLACEMENT, ///< Plants are placed again.
		CHANGE_APPEARANCE, ///< Meshes or materials change. All plants stay.
		CHANGE_MOTION, ///< Constants of the motion change. Meshes stay.
	};

private:
	godot::Ref<PlantFunction> species;
	double weight = 1.0;
	double density_factor = 1.0;
	godot::Vector2 scale_range = { 0.8f, 1.2f };
	double height_deviation = 0.1;
	double lean_deviation = 0.0; // rad.
	int variants = 4;
	double lod_bias = 1.0;
	godot::String layer;
	godot::Ref<PlantHabitat> habitat;
	double vigor = 1.0;
	double shade_radius = 0.2; // m.
	double shade_tolerance = 0.2;
	godot::String auto_name;
	ChangeKind change_kind = CHANGE_NONE; // While `changed` is emitted.
	bool forwards = false; // True while `changed` is emitted for the function inside.

	/// Emits `changed` for a property of this entry or, with `from_species`, for the function inside.
	void report_change(ChangeKind kind, bool from_species);
	template <class Value> void set(Value &slot, const Value &value, ChangeKind kind);
	template <class Value>
	void set_number(Value &slot, const char *name, Value value, const Range &range, ChangeKind kind = CHANGE_PLACEMENT);

protected:
	static void _bind_methods();
	bool _set(const godot::StringName &name, const godot::Variant &value);
	void _validate_property(godot::PropertyInfo &property) const;

public:
	/// Returns an entry with `function`, `weight`, and defaults.
	static godot::Ref<PlantFieldSpecies> of(const godot::Ref<PlantFunction> &function, double weight = 1.0);

	/// The kind of the change for which `changed` is emitted now.
	ChangeKind get_change_kind() const { return change_kind; }
	/// True while `changed` is emitted for a property of the PlantFunction inside; false for properties of this entry.
	bool is_species_change() const { return forwards; }
	// Called by the engine.
	void on_species_changed();
	void on_habitat_changed();

	void set_species(const godot::Ref<PlantFunction> &function);
	godot::Ref<PlantFunction> get_species() const { return species; }
	void set_weight(double value);
	double get_weight() const { return weight; }
	void set_density_factor(double factor);
	double get_density_factor() const { return density_factor; }
	void set_scale_range(const godot::Vector2 &range);
	godot::Vector2 get_scale_range() const { return scale_range; }
	void set_height_deviation(double deviation);
	double get_height_deviation() const { return height_deviation; }
	void set_lean_deviation(double radians);
	double get_lean_deviation() const { return lean_deviation; }
	void set_layer(const godot::String &name);
	godot::String get_layer() const { return layer; }
	/// Returns its layer in a PlantMap: `layer`, or the name of its species if that is empty.
	godot::String get_layer_name() const;
	void set_habitat(const godot::Ref<PlantHabitat> &where);
	godot::Ref<PlantHabitat> get_habitat() const { return habitat; }
	void set_vigor(double factor);
	double get_vigor() const { return vigor; }
	void set_shade_radius(double metres);
	double get_shade_radius() const { return shade_radius; }
	void set_shade_tolerance(double chance);
	double get_shade_tolerance() const { return shade_tolerance; }
	void set_variants(int count);
	int get_variants() const { return variants; }
	void set_lod_bias(double factor);
	double get_lod_bias() const { return lod_bias; }
};

} // namespace undergrowth

VARIANT_ENUM_CAST(undergrowth::PlantFieldSpecies::ChangeKind);
