#pragma once

#include "messages.hpp"
#include "wind/travelling_wind.hpp"

#include <godot_cpp/classes/material.hpp>
#include <godot_cpp/classes/resource.hpp>

namespace undergrowth {

/// A wind that any number of plants share: a force (thesis, section 4.3), or air that moves. Bridge to core/wind.
/// The simulation advances its clock once a step, whatever the number of plants.
class PlantWind : public godot::Resource {
	GDCLASS(PlantWind, godot::Resource)

public:
	enum Kind : int64_t {
		KIND_GUST = int(WindKind::gust),
		KIND_CONSTANT = int(WindKind::constant),
		KIND_BURSTS = int(WindKind::bursts),
		KIND_WAVES = int(WindKind::waves),
		KIND_AIR = int(WindKind::air),
	};

	/// One that feels this wind by a clock of its own: a gust that is called for begins for it when it hears of it,
	/// however far its clock is ahead of the wind's or behind.
	struct Listener {
		uint64_t heard = 0; ///< Gusts that were called for.
		double gust_start = 0.0; ///< s, of the last of them, by its own clock.
	};

private:
	/// Air on its way to be another.
	struct Blend {
		Air from, to;
		double begin = 0.0; ///< s, of the wind's clock.
		double duration = 0.0; ///< s; 0: none.
	};

	FieldWind blowing; ///< Direction as a float; what was set is in `direction`.
	Blend blend;
	godot::Vector3 pivot; ///< Where somebody looks from: patterns go on there when the air changes.
	mutable bool has_told_of_newtons = false;
	double direction = 0.0; ///< rad.
	double time = 0.0;
	uint64_t gusts = 0; ///< That were called for.
	uint64_t begun_step = 0;
	uint64_t advanced_in = UINT64_MAX; ///< Number of the frame in which the clock was advanced last.
	double step_start = 0.0; ///< s, of that step.

	void begin_gust();
	void go_on_to(double clock);
	void advance_to(double clock);
	void take_air(const Air &wanted);
	void change(const Air &wanted);
	void set_air(float Air::*part, const char *property, double value, const Range &range);
	bool is_air(const char *asked) const;
	godot::Vector3 sample_air_force(double at_time) const;
	static void bind_air();
	void set_number(float &slot, const char *property, double value, const Range &range);

protected:
	static void _bind_methods();
	bool _set(const godot::StringName &name, const godot::Variant &value);
	void _validate_property(godot::PropertyInfo &property) const;

public:
	PlantWind();

	void set_kind(Kind kind);
	Kind get_kind() const;
	/// Whether a wind, if there is one, blows in m/s.
	static bool is_air(const godot::Ref<PlantWind> &wind) { return wind.is_valid() && wind->get_kind() == KIND_AIR; }
	void set_strength(double newtons);
	double get_strength() const;
	void set_direction(double radians);
	double get_direction() const;
	void set_frequency(double hertz);
	double get_frequency() const;
	void set_gust_duration(double seconds);
	double get_gust_duration() const;
	void set_travel_speed(double metres_per_second);
	double get_travel_speed() const;

	void set_speed(double metres_per_second);
	double get_speed() const;
	void set_turbulence(double share);
	double get_turbulence() const;
	void set_gustiness(double gustiness);
	double get_gustiness() const;
	void set_roughness(double metres);
	double get_roughness() const;
	void set_canopy_height(double metres);
	double get_canopy_height() const;
	void set_canopy_wave_amount(double share);
	double get_canopy_wave_amount() const;
	int64_t get_beaufort() const;
	/// Of the air at a place (world, its height above the ground as y), m/s.
	godot::Vector3 sample_velocity(double at_time, const godot::Vector3 &place) const;
	/// Of the air at the tops of the stand, waves with it, at horizontal places of the world (x, z), m/s.
	godot::PackedVector2Array sample_over_canopy(double at_time, const godot::PackedVector2Array &places) const;
	/// Tells a material that includes undergrowth_wind.gdshaderinc how it blows now.
	void apply_to_material(const godot::Ref<godot::Material> &material) const;
	/// Within so many seconds of its clock this air becomes what another is.
	void blend_to(const godot::Ref<PlantWind> &wind, double seconds);

	godot::Vector3 sample(double at_time) const;
	/// A gust of `strength` (N) for `duration` (s), from now on; below 0: the wind's own.
	void trigger_gust(double strength, double duration);
	double get_time() const;

	/// The wind's clock goes on: by a step in the simulation, by a frame where someone drives plants by hand.
	void advance(double step);
	/// Whether anything advanced the clock in this frame.
	bool has_advanced_in_frame() const;
	/// The clock of a plant that is driven by hand: this wind's never stands behind it.
	void keep_up_with(double clock);
	/// Somebody looks from there (world).
	void look_from(const godot::Vector3 &place) { pivot = place; }
	/// What blows, for those who ask at a place and time of their own, with the speed at which it travels over the
	/// ground.
	FieldWind travelling() const;
	/// The same for `listener`, whose clock shows `clock`.
	FieldWind heard_by(Listener &listener, double clock) const;
	/// This wind's clock (s) at the start of step number `number` of the simulation. The first that asks moves it on to
	/// the step's end.
	double begin_step(uint64_t number, double step);
};

} // namespace undergrowth

VARIANT_ENUM_CAST(undergrowth::PlantWind::Kind);
