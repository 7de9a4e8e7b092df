#pragma once

#include "base/messages.hpp"
#include "motion/step_time.hpp"
#include "wind/field_wind.hpp"

#include <godot_cpp/classes/material.hpp>
#include <godot_cpp/classes/resource.hpp>

#include <vector>

namespace undergrowth {

/// A wind that any number of plants share: a force (thesis, section 4.3) or moving air, with water and snow on plants.
/// Bridge to core/wind.
/// PlantSimulation advances its clock, once a step for any number of plants and fields.
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

	/// A user of this wind with its own clock. A triggered gust begins for it when it next reads the wind, for any
	/// difference between the clocks.
	struct Listener {
		uint64_t received_gusts = 0; ///< Number of triggered gusts that it received.
		double gust_start = 0.0; ///< s, of the last of them, by its own clock.
	};

private:
	/// A change from one air to another over time.
	struct Blend {
		Air from, to;
		Precipitation wet_from, wet_to;
		double begin = 0.0; ///< s, of the wind's clock.
		double duration = 0.0; ///< s; 0: none.
	};

	FieldWind blowing; ///< Its direction is a float; `direction` is the value that was set.
	Blend blend;
	std::vector<FieldWind> blended; ///< The wind in each step of this frame, if a blend changes it; else empty.
	mutable bool has_reported_newtons = false;
	double direction = 0.0; ///< rad.
	StepTime clock;
	uint64_t gusts = 0; ///< Number of triggered gusts.
	uint64_t last_step = 0; ///< Number of the step that last advanced the clock.
	bool is_scene_wind = false;

	void begin_gust();
	void set_clock(const StepTime &next);
	void take_air(const Air &wanted);
	void change(const Air &wanted);
	void set_air(float Air::*part, const char *property, double value, const Range &range);
	void set_precipitation(float Precipitation::*part, const char *property, double value, const Range &range);
	bool is_air(const char *method) const;
	godot::Vector3 sample_air_force(double at_time) const;
	static void bind_air();
	static void bind_precipitation();
	void set_number(float &slot, const char *property, double value, const Range &range);

protected:
	static void _bind_methods();
	bool _set(const godot::StringName &name, const godot::Variant &value);
	void _validate_property(godot::PropertyInfo &property) const;

public:
	PlantWind();
	~PlantWind() override;

	void set_kind(Kind kind);
	Kind get_kind() const;
	/// True if there is a wind and it is in m/s.
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
	void set_wetness(double share);
	double get_wetness() const;
	void set_snow(double share);
	double get_snow() const;
	void set_rain(double millimetres_per_hour);
	double get_rain() const;
	const Precipitation &precipitation() const { return blowing.precipitation; }
	/// Returns the velocity of the air (m/s) at a position (world axes; y is the height above the ground).
	godot::Vector3 sample_velocity(double at_time, const godot::Vector3 &place) const;
	/// Returns the velocities of the air (m/s) at the tops of the canopy, with its waves, at horizontal world positions
	/// (x, z).
	godot::PackedVector2Array sample_over_canopy(double at_time, const godot::PackedVector2Array &places) const;
	/// Sets the present wind in a material that includes undergrowth_wind.gdshaderinc.
	void apply_to_material(const godot::Ref<godot::Material> &material) const;
	/// True: each frame sets this wind in the global shader parameters. The last wind for which it was set has effect.
	void set_scene_wind(bool on);
	bool get_scene_wind() const { return is_scene_wind; }
	/// Returns the wind that the global shader parameters have, or null.
	static PlantWind *scene_wind();
	/// Sets the wind of `seconds` ago in the global shader parameters, if it is theirs.
	void show_in_shaders(double seconds) const;
	/// Changes this air to that of another wind within `seconds` of its clock.
	void blend_to(const godot::Ref<PlantWind> &wind, double seconds);

	godot::Vector3 sample(double at_time) const;
	/// Starts a gust of `strength` (N) for `duration` (s) now. A value below 0 uses that of the wind.
	void trigger_gust(double strength, double duration);
	double get_time() const;

	/// Advances the clock by hand.
	void advance(double seconds);
	/// Begins a frame. For its owner, PlantSimulation.
	void begin_frame() { blended.clear(); }
	/// Advances the clock by a step of `length` seconds, unless step `number` has already done that. For its owner.
	void advance_step(uint64_t number, double length);
	/// Returns the clock (s) `steps` steps of `length` seconds ago.
	double time_before(int steps, double length) const { return clock.before(steps, length); }
	/// Advances the clock to `clock`, the clock of a plant that code advances, if it is behind it.
	void catch_up_to(double seconds);
	/// Returns the wind for sampling at any position and time, with the speed at which it travels over the ground.
	FieldWind travelling() const;
	/// Returns the wind in the step of this frame that began `steps` steps ago; 0: now.
	FieldWind travelling_before(int steps) const {
		const bool is_listed = steps > 0 && size_t(steps) <= blended.size();
		return is_listed ? blended[blended.size() - size_t(steps)] : travelling();
	}
	/// Returns the wind for `listener` at `seconds` of its clock.
	FieldWind for_listener(Listener &listener, double seconds) const;
};

} // namespace undergrowth

VARIANT_ENUM_CAST(undergrowth::PlantWind::Kind);
