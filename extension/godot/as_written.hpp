#pragma once

namespace undergrowth {

/// The shortest decimal number that rounds to `value`: what a user wrote before the core stored it in single precision.
/// Properties return this, so that scenes and the inspector show 0.1 and not 0.10000000149.
double as_written(float value);

/// An angle (rad) that was written in degrees, such as deg_to_rad(0.9), without the last bits that files lose of it:
/// saved and loaded any number of times it stays what it was. All other angles stay as they are.
double angle_as_written(double radians);

} // namespace undergrowth
