#pragma once

#include "wind/field_wind.hpp"
#include "wind/plant_wind.hpp"

#include <godot_cpp/variant/transform3d.hpp>

namespace undergrowth {

/// Returns the wind in a field's axes (`axes`: from those to the world's) on the clock of a motion. The wind's own
/// clock is `offset` seconds ahead of it. A field has the wind that has arrived at its origin, as a Plant3D there.
/// `steps`: for the step of this frame that began so many steps ago; 0: now. Null: still air.
FieldWind field_wind(const godot::Ref<PlantWind> &wind, const godot::Transform3D &axes, double offset, int steps = 0);

} // namespace undergrowth
