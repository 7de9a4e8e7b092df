#pragma once

#include "messages.hpp"
#include "wind/travelling_wind.hpp"

#include <godot_cpp/classes/resource.hpp>

namespace undergrowth {

/// A wind that any number of plants share (thesis, section 4.3). Bridge to core/wind.
/// The simulation advances its clock once a step, whatever the number of plants.
class PlantWind : public godot::Resource {
	GDCLASS(PlantWind, godot::Resource)

public:
	enum Kind : int64_t {
		KIND_GUST = int(WindKind::gust),
		KIND_CONSTANT = int(WindKind::constant),
		KIND_BURSTS = int(WindKind::bursts),
		KIND_WAVES = int(WindKind::waves),
	};

	/// One that feels this wind by a clock of its own: a gust that is called for begins for it when it hears of it,
	/// however far its clock is ahead of the wind's or behind.
	struct Listener {
		uint64_t heard = 0; ///< Gusts that were called for.
		double gust_start = 0.0; ///< s, of the last of them, by its own clock.
	};

private:
	FieldWind air; ///< Direction as a float; what was set is in `direction`.
	double direction = 0.0; ///< rad.
	double time = 0.0;
	uint64_t gusts = 0; ///< That were called for.
	uint64_t begun_step = 0;
	double step_start = 0.0; ///< s, of that step.

	void begin_gust();
	void set_number(float &slot, const char *property, double value, const Range &range);

protected:
	static void _bind_methods();
	void _validate_property(godot::PropertyInfo &property) const;

public:
	PlantWind();

	void set_kind(Kind kind);
	Kind get_kind() const;
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

	godot::Vector3 sample(double at_time) const;
	/// A gust of `strength` (N) for `duration` (s), from now on; below 0: the wind's own.
	void trigger_gust(double strength, double duration);
	double get_time() const;

	/// The wind's clock goes on: by a step in the simulation, by a frame where someone drives plants by hand.
	void advance(double step);
	/// The clock of a plant that is driven by hand: this wind's never stands behind it.
	void keep_up_with(double clock);
	/// What blows, for those who ask at a place and time of their own.
	const Wind &description() const { return air.wind; }
	/// The same, with the speed at which it travels over the ground.
	const FieldWind &travelling() const { return air; }
	/// The same for `listener`, whose clock shows `clock`.
	FieldWind heard_by(Listener &listener, double clock) const;
	/// This wind's clock (s) at the start of step number `number` of the simulation. The first that asks moves it on to
	/// the step's end.
	double begin_step(uint64_t number, double step);
};

} // namespace undergrowth

VARIANT_ENUM_CAST(undergrowth::PlantWind::Kind);
