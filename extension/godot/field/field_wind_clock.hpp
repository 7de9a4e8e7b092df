#pragma once

#include "plant_wind.hpp"
#include "wind/travelling_wind.hpp"

#include <godot_cpp/variant/transform3d.hpp>

namespace undergrowth {

/// The wind in a field's axes (`axes`: from those to the world's), by a clock that the wind's own is `offset` seconds
/// ahead of. A field feels the wind that has come to its origin, as a Plant3D there does. Null: still air.
FieldWind field_wind(const godot::Ref<PlantWind> &wind, const godot::Transform3D &axes, double offset);

/// How far the wind's clock is ahead of a motion's. A wind's clock goes on with whoever simulates first in a frame:
/// Plant3Ds, another field or this one.
class FieldWindClock {
public:
	/// `steps` steps of `step` seconds begin at `motion_time` (s): makes the wind go on where nobody has in this frame.
	void follow(const godot::Ref<PlantWind> &wind, int steps, double step, double motion_time);
	/// s, of the wind that was followed last.
	double ahead() const { return offset; }
	/// A motion begins anew.
	void forget() { seen_time = -1.0; }

private:
	uint64_t seen = 0; ///< Instance id.
	double seen_time = -1.0; ///< s.
	double offset = 0.0; ///< s.
};

} // namespace undergrowth
