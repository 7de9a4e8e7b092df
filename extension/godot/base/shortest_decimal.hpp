#pragma once

namespace undergrowth {

/// Returns the shortest decimal number that rounds to `value`: the number that the user wrote before the core stored it
/// in single precision. Properties return it, so that scenes and the inspector show 0.1 and not 0.10000000149.
double shortest_decimal(float value);

/// Restores an angle (rad) that was written in degrees, such as deg_to_rad(0.9): adds the last bits that resource files
/// lose. The angle is then stable over any number of saves and loads. Returns all other angles unchanged.
double exact_angle(double radians);

} // namespace undergrowth
