#pragma once

#include "stem/stem_beam.hpp"

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>

namespace undergrowth {

/// What a species says about its stem beyond how it swings: of what it is made, what it carries, and how its bend is
/// shown. What is not said is as the plant is drawn. Emits `changed` for each real change.
class PlantStem : public godot::Resource {
	GDCLASS(PlantStem, godot::Resource)

	int joints = 4;
	int modes = 1;
	double youngs_modulus = 0.0; // Pa.
	double density = 800.0; // kg/m³.
	double diameter = 0.0; // m.
	double taper = -1.0;
	double head_mass = -1.0; // kg.
	double head_drag_area = -1.0; // m².
	double leaf_mass = -1.0; // kg.
	double leaf_drag_area = -1.0; // m².
	godot::PackedFloat32Array wind_weights;

	/// 0 says nothing; everything else lies between `least` and `most`.
	void set_unless_none(double &slot, const char *property, double value, double least, double most);
	void set_number(double &slot, const char *property, double value, double least, double most);

protected:
	static void _bind_methods();

public:
	/// What is said here, over what `beam` says already.
	void tell(StemBeam &beam) const;
	/// Whether stems swing as fast as their stiffness says and not as declared.
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
