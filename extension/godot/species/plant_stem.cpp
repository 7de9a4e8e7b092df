#include "species/plant_stem.hpp"

#include "base/bind_properties.hpp"
#include "base/messages.hpp"

#include <cmath>

using namespace godot;

namespace undergrowth {

static constexpr double AS_DRAWN = -1.0;
static constexpr double MAX_WEIGHT = 1e3;

void PlantStem::write_to(StemBeam &beam) const {
	beam.joints = joints;
	beam.modes = modes;
	beam.density = float(density);
	beam.nods = nods;
	if (is_physical()) {
		beam.natural_frequency = 0.0f;
		beam.youngs_modulus = float(youngs_modulus);
	}
	const auto take = [](double value, float &into) { into = value >= 0.0 ? float(value) : into; };
	beam.diameter = diameter > 0.0 ? float(diameter) : beam.diameter;
	take(taper, beam.taper);
	take(head_mass, beam.head_mass);
	take(head_drag_area, beam.head_drag_area);
	for (StemBeam::Load &load : beam.loads) {
		load.mass = leaf_mass >= 0.0 ? 0.0f : load.mass;
		load.drag_area = leaf_drag_area >= 0.0 ? 0.0f : load.drag_area;
	}
	take(leaf_mass, beam.leaf_mass);
	take(leaf_drag_area, beam.leaf_drag_area);
	beam.wind_weights.assign(wind_weights.ptr(), wind_weights.ptr() + wind_weights.size());
}

void PlantStem::set_number(double &slot, const char *property, double value, double min, double max) {
	if (accept_value(this, property, value, { min, max }) && value != slot) {
		slot = value;
		emit_changed();
	}
}

void PlantStem::set_unless_none(double &slot, const char *property, double value, double min, double max) {
	if (value > 0.0 && value < min) {
		report_error(this,
				String(property) + " cannot be " + String::num(value) + "; the old value stays. Set a number from " +
						String::num(min) + " to " + String::num(max) + ", or 0 for none.");
		return;
	}
	set_number(slot, property, value, 0.0, max);
}

void PlantStem::set_joints(int count) {
	if (accept_value(this, "joints", count, { 1, MAX_STEM_JOINTS }) && count != joints) {
		joints = count;
		emit_changed();
	}
}

void PlantStem::set_modes(int count) {
	if (accept_value(this, "modes", count, { 1, MAX_STEM_MODES }) && count != modes) {
		modes = count;
		emit_changed();
	}
}

void PlantStem::set_youngs_modulus(double pascal) {
	set_unless_none(youngs_modulus, "youngs_modulus", pascal, 1e4, 1e12);
}

void PlantStem::set_density(double value) {
	set_number(density, "density", value, 1.0, 2e4);
}

void PlantStem::set_diameter(double metres) {
	set_unless_none(diameter, "diameter", metres, 2e-5, 1.0);
}

void PlantStem::set_taper(double share) {
	set_number(taper, "taper", share, AS_DRAWN, 0.9);
}

void PlantStem::set_nods(bool on) {
	if (on != nods) {
		nods = on;
		emit_changed();
	}
}

void PlantStem::set_head_mass(double kilograms) {
	set_number(head_mass, "head_mass", kilograms, AS_DRAWN, 100.0);
}

void PlantStem::set_head_drag_area(double square_metres) {
	set_number(head_drag_area, "head_drag_area", square_metres, AS_DRAWN, 100.0);
}

void PlantStem::set_leaf_mass(double kilograms) {
	set_number(leaf_mass, "leaf_mass", kilograms, AS_DRAWN, 100.0);
}

void PlantStem::set_leaf_drag_area(double square_metres) {
	set_number(leaf_drag_area, "leaf_drag_area", square_metres, AS_DRAWN, 100.0);
}

void PlantStem::set_wind_weights(const PackedFloat32Array &weights) {
	for (int64_t i = 0; i < weights.size(); i++) {
		if (!std::isfinite(weights[i]) || weights[i] < 0.0f || weights[i] > MAX_WEIGHT) {
			report_error(this,
					"wind_weights[" + String::num_int64(i) + "] is " + String::num(weights[i]) +
							". Use shares of the wind's force from 0 to " + String::num(MAX_WEIGHT) +
							", one for each joint, or none. The old weights stay.");
			return;
		}
	}
	if (weights != wind_weights) {
		wind_weights = weights;
		emit_changed();
	}
}

void PlantStem::_bind_methods() {
	PROPERTY(INT, joints, SLIDER("1,8,1"));
	PROPERTY(INT, modes, SLIDER("1,2,1"));
	ADD_GROUP("Stiffness", "");
	PROPERTY(FLOAT, youngs_modulus, SLIDER("0,20000000000,1000000,or_greater,suffix:Pa"));
	PROPERTY(FLOAT, density, SLIDER("50,2000,1,or_greater,suffix:kg/m³"));
	PROPERTY(FLOAT, diameter, SLIDER("0,0.1,0.0001,or_greater,suffix:m"));
	PROPERTY(FLOAT, taper, SLIDER("-1,0.9,0.01"));
	PROPERTY(BOOL, nods);
	ADD_GROUP("Load", "");
	PROPERTY(FLOAT, head_mass, SLIDER("-1,1,0.0001,or_greater,suffix:kg"));
	PROPERTY(FLOAT, head_drag_area, SLIDER("-1,1,0.0001,or_greater,suffix:m²"));
	PROPERTY(FLOAT, leaf_mass, SLIDER("-1,1,0.0001,or_greater,suffix:kg"));
	PROPERTY(FLOAT, leaf_drag_area, SLIDER("-1,1,0.0001,or_greater,suffix:m²"));
	PROPERTY(PACKED_FLOAT32_ARRAY, wind_weights);
}

} // namespace undergrowth
