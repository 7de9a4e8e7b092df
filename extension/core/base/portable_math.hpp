#pragma once

namespace undergrowth {

/// Sine, cosine, tangent, exponential and the angle of a direction that give the same bits on every platform.
/// The C library's differ in the last digit from one system to the next; these use only operations that IEEE 754
/// rounds exactly. For finite arguments up to 1e6 in size the error is below 1e-14 relative to 1 (sine, cosine) or to
/// the result (exponential, which saturates at 0 and at the largest finite number instead of overflowing).
double portable_sin(double angle);
double portable_cos(double angle);
double portable_tan(double angle);
double portable_exp(double exponent);
/// The angle of (x, y) from the x axis, -π to π; 0 for (0, 0). Within 1e-14 rad.
double portable_atan2(double y, double x);

} // namespace undergrowth
