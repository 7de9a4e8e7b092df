#pragma once

#include "wind/wind.hpp"

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

private:
	Wind wind;
	double time = 0.0;
	uint64_t sampled_step = 0;
	glm::vec3 sampled_force = { 0.0f, 0.0f, 0.0f }; // N, of that step.

protected:
	static void _bind_methods();
	void _validate_property(godot::PropertyInfo &property) const;

public:
	void set_kind(Kind kind);
	Kind get_kind() const;
	void set_strength(double newtons);
	double get_strength() const;
	void set_direction_degrees(double degrees);
	double get_direction_degrees() const;
	void set_frequency(double hertz);
	double get_frequency() const;
	void set_gust_duration(double seconds);
	double get_gust_duration() const;

	godot::Vector3 sample(double at_time) const;
	double get_travel_speed() const { return 10.0; }
	void trigger_gust();
	double get_time() const;

	/// The wind's clock goes on: by a step in the simulation, by a frame where someone drives plants by hand.
	void advance(double step);
	/// The clock of a plant that is stepped by hand: this wind's never stands behind it, so that a gust blows there
	/// now.
	void keep_up_with(double clock);
	/// What blows, for those who ask at a place and time of their own.
	const Wind &description() const { return wind; }
	/// The force of step number `number` of the simulation (N, world axes). The first that asks advances the clock and
	/// samples, for all others of that step.
	glm::vec3 force_of_step(uint64_t number, double step);
};

} // namespace undergrowth

VARIANT_ENUM_CAST(undergrowth::PlantWind::Kind);
