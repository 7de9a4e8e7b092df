#pragma once

#include "base/shortest_decimal.hpp"
#include "form/plant_part.hpp"

namespace undergrowth {

/// A round, long part: stem, twig, petiole, rachis, awn; with an open tip a bell or a trumpet.
class PlantAxis : public PlantPart {
	GDCLASS(PlantAxis, PlantPart)

protected:
	static void _bind_methods();

public:
	PlantAxis();
	static godot::Ref<PlantAxis> of(const godot::Dictionary &values);

	void set_diameter(const godot::Vector2 &metres);
	godot::Vector2 get_diameter() const;
	void set_open_tip(bool open);
	bool get_open_tip() const { return part.axis.open_tip; }
	UNDERGROWTH_ANGLE(bend, part.curve.bend, -720.0, 720.0)
	UNDERGROWTH_NUMBER(bend_power, part.curve.power, 0.5, 4.0)
	UNDERGROWTH_ANGLE(wander, part.curve.wander, 0.0, 85.0)
	UNDERGROWTH_COUNT(lobes, part.axis.lobes, 0, 64)
	UNDERGROWTH_NUMBER(lobe_depth, part.axis.lobe_depth, 0.0, 0.9)
};

/// An open sheet on a midrib: leaf, petal, ray, bract, pinna.
class PlantBlade : public PlantPart {
	GDCLASS(PlantBlade, PlantPart)

public:
	enum BladeProfile : int64_t {
		PROFILE_GRASS,
		PROFILE_STRAP,
		PROFILE_LANCEOLATE,
		PROFILE_OVATE,
		PROFILE_ELLIPTIC,
		PROFILE_OBOVATE,
		PROFILE_SPATULATE,
		PROFILE_TEPAL,
		PROFILE_RAY,
		PROFILE_EVEN,
	};

private:
	BladeProfile profile = PROFILE_LANCEOLATE;

protected:
	static void _bind_methods();
	void _validate_property(godot::PropertyInfo &property) const;

public:
	PlantBlade();
	static godot::Ref<PlantBlade> of(const godot::Dictionary &values);

	void set_profile(BladeProfile kind);
	BladeProfile get_profile() const { return profile; }
	UNDERGROWTH_NUMBER(width, part.width, 1e-5, 10.0)
	UNDERGROWTH_NUMBER(base_width, part.widths.base_width, 0.0, 1.0)
	UNDERGROWTH_ANGLE(bend, part.curve.bend, -720.0, 720.0)
	UNDERGROWTH_NUMBER(bend_power, part.curve.power, 0.5, 4.0)
	UNDERGROWTH_ANGLE(wander, part.curve.wander, 0.0, 85.0)
	UNDERGROWTH_ANGLE(fold, part.blade.fold, -85.0, 85.0)
	UNDERGROWTH_ANGLE(roll, part.blade.roll, -340.0, 340.0)
	UNDERGROWTH_ANGLE(twist, part.blade.twist, -1140.0, 1140.0)
	UNDERGROWTH_NUMBER(wave, part.blade.wave, 0.0, 1.0)
	UNDERGROWTH_NUMBER(wave_count, part.blade.wave_count, 0.0, 32.0)
	UNDERGROWTH_COUNT(teeth, part.blade.teeth, 0, 32)
	UNDERGROWTH_NUMBER(tooth_depth, part.blade.tooth_depth, 0.0, 0.9)
	UNDERGROWTH_ANGLE(roundness, part.blade.roundness, 0.0, 57.0)
};

/// A small closed part: floret, spikelet, anther, seed.
class PlantBead : public PlantPart {
	GDCLASS(PlantBead, PlantPart)

protected:
	static void _bind_methods();

public:
	PlantBead();
	static godot::Ref<PlantBead> of(const godot::Dictionary &values);

	UNDERGROWTH_NUMBER(diameter, part.width, 1e-5, 10.0)
};

} // namespace undergrowth

VARIANT_ENUM_CAST(undergrowth::PlantBlade::BladeProfile);
