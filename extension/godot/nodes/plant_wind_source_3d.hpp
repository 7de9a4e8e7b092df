#pragma once

#include "base/messages.hpp"
#include "wind/air_sources.hpp"
#include "wind/source_way.hpp"

#include <godot_cpp/classes/node3d.hpp>

#include <vector>

namespace undergrowth {

/// A node that stirs the air around it, for all fields and plants nearby. Bridge to core/wind/air_sources.hpp.
class PlantWindSource3D : public godot::Node3D {
	GDCLASS(PlantWindSource3D, godot::Node3D)

public:
	enum Kind : int64_t {
		KIND_EXPLOSION = int(AirSource::Kind::explosion),
		KIND_FAN = int(AirSource::Kind::fan),
		KIND_WAKE = int(AirSource::Kind::wake),
	};

	PlantWindSource3D();

	/// Reads the positions of all sources, once in a frame. PlantSimulation calls it before nodes process.
	static void follow_all();
	/// Appends all sources that stir the air of a World3D (`world`: its instance id) `ago` seconds before this frame,
	/// in world axes. Main thread.
	static void gather(uint64_t world, double ago, std::vector<AirSource> &into);
	/// gather() in the axes of a field (`axes`: from those to the world's).
	static void gather_in(uint64_t world, const godot::Transform3D &axes, double ago, std::vector<AirSource> &into);

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
	uint64_t world = 0; ///< Instance id of its World3D.
	SourceWay way; ///< In world axes.

	void set_number(float &slot, const char *property, double value, const Range &range);
	void follow(double delta);
	bool stirs_now() const;
	AirSource at(double ago) const;
};

} // namespace undergrowth

VARIANT_ENUM_CAST(undergrowth::PlantWindSource3D::Kind);
