#pragma once

namespace undergrowth {

/// The shortest decimal number that rounds to `value`: what a user wrote before the core stored it in single precision.
/// Properties return this, so that scenes and the inspector show 0.1 and not 0.10000000149.
double as_written(float value);

} // namespace undergrowth
