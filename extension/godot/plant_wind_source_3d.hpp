#pragma once

#include "messages.hpp"
#include "wind/air_sources.hpp"

#include <godot_cpp/classes/node3d.hpp>

#include <vector>

namespace undergrowth {

/// What stirs the air at one place, for all fields and plants near it. Bridge to core/wind/air_sources.hpp.
class PlantWindSource3D : public godot::Node3D {
	GDCLASS(PlantWindSource3D, godot::Node3D)

public:
	enum Kind : int64_t {
		KIND_EXPLOSION = int(AirSource::Kind::explosion),
		KIND_FAN = int(AirSource::Kind::fan),
		KIND_WAKE = int(AirSource::Kind::wake),
	};

	PlantWindSource3D();

	/// All that stir the air in this frame, in world axes. Main thread.
	static const std::vector<AirSource> &all_now();
	/// The same in the axes of a field (`axes`: from those to the world's).
	static std::vector<AirSource> all_in(const godot::Transform3D &axes);

	void set_kind(Kind new_kind);
	Kind get_kind() const;
	void set_speed(double metres_per_second);
	double get_speed() const;
	void set_thrust(double newtons);
	double get_thrust() const;
	void set_radius(double metres);
	double get_radius() const;
	void set_duration(double seconds);
	double get_duration() const;
	void set_active(bool stirs);
	bool is_active() const { return active; }
	void explode();

protected:
	static void _bind_methods();
	void _notification(int what);
	void _validate_property(godot::PropertyInfo &property) const;

private:
	AirSource air;
	float speed = 60.0f; ///< m/s, of an explosion.
	float thrust = 12000.0f; ///< N, of a fan.
	bool active = true;
	bool is_exploding = false;
	godot::Vector3 last_place;

	void set_number(float &slot, const char *property, double value, const Range &range);
	void follow(double delta);
	bool stirs_now() const;
};

} // namespace undergrowth

VARIANT_ENUM_CAST(undergrowth::PlantWindSource3D::Kind);
