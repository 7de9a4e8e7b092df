#pragma once

#include "stem/stem_beam.hpp"

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>

namespace undergrowth {

/// The stem of a species: its material, its load and the display of its bend. Properties without a value follow the
/// drawn shape. Emits `changed` once for each real change.
class PlantStem : public godot::Resource {
	GDCLASS(PlantStem, godot::Resource)

	int joints = 4;
	int modes = 1;
	double youngs_modulus = 0.0; // Pa.
	double density = 800.0; // kg/m³.
	double diameter = 0.0; // m.
	double taper = -1.0;
	bool nods = false;
	double head_mass = -1.0; // kg.
	double head_drag_area = -1.0; // m².
	double leaf_mass = -1.0; // kg.
	double leaf_drag_area = -1.0; // m².
	godot::PackedFloat32Array wind_weights;

	/// Sets a number from `min` to `max`, or 0 for none.
	void set_unless_none(double &slot, const char *property, double value, double min, double max);
	void set_number(double &slot, const char *property, double value, double min, double max);

protected:
	static void _bind_methods();

public:
	/// Overwrites `beam` with the values that are set.
	void write_to(StemBeam &beam) const;
	/// True if the stiffness determines the frequency of stems, not the declared frequency.
	bool is_physical() const { return youngs_modulus > 0.0; }

	void set_joints(int count);
	int get_joints() const { return joints; }
	void set_modes(int count);
	int get_modes() const { return modes; }
	void set_youngs_modulus(double pascal);
	double get_youngs_modulus() const { return youngs_modulus; }
	void set_density(double value);
	double get_density() const { return density; }
	void set_diameter(double metres);
	double get_diameter() const { return diameter; }
	void set_taper(double share);
	double get_taper() const { return taper; }
	void set_nods(bool on);
	bool get_nods() const { return nods; }
	void set_head_mass(double kilograms);
	double get_head_mass() const { return head_mass; }
	void set_head_drag_area(double square_metres);
	double get_head_drag_area() const { return head_drag_area; }
	void set_leaf_mass(double kilograms);
	double get_leaf_mass() const { return leaf_mass; }
	void set_leaf_drag_area(double square_metres);
	double get_leaf_drag_area() const { return leaf_drag_area; }
	void set_wind_weights(const godot::PackedFloat32Array &weights);
	godot::PackedFloat32Array get_wind_weights() const { return wind_weights; }
};

} // namespace undergrowth
