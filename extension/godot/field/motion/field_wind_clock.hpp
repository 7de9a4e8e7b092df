#pragma once

#include "wind/field_wind.hpp"
#include "wind/plant_wind.hpp"

#include <godot_cpp/variant/transform3d.hpp>

namespace undergrowth {

/// Returns the wind in a field's axes (`axes`: from those to the world's) on the clock of a motion. The wind's own
/// clock is `offset` seconds ahead of it. A field has the wind that has arrived at its origin, as a Plant3D there.
/// Null: still air.
FieldWind field_wind(const godot::Ref<PlantWind> &wind, const godot::Transform3D &axes, double offset);

/// The offset of a wind's clock against a motion's. In each frame the first simulation advances the wind's clock: a
/// Plant3D, another field or this one.
class FieldWindClock {
public:
	/// Call before `steps` steps of `step` seconds that begin at `motion_time` (s). Advances the wind if no other
	/// simulation has advanced it in this frame.
	void follow(const godot::Ref<PlantWind> &wind, int steps, double step, double motion_time);
	/// Offset of the last followed wind (s).
	double ahead() const { return offset; }
	/// Call when a motion restarts.
	void forget() { seen_time = -1.0; }

private:
	uint64_t seen = 0; ///< Instance id.
	double seen_time = -1.0; ///< s.
	double offset = 0.0; ///< s.
};

} // namespace undergrowth
