#pragma once

namespace undergrowth {

/// Sine, cosine, tangent, exponential, logarithm, powers and the angle of a direction that give the same bits on every
/// platform. The C library's differ in the last digit from one system to the next; these use only operations that IEEE
/// 754 rounds exactly. For finite arguments up to 1e6 in size the error is below 1e-14 relative to 1 (sine, cosine) or
/// to the result (exponential, which saturates at 0 and at the largest finite number instead of overflowing).
double portable_sin(double angle);
double portable_cos(double angle);
double portable_tan(double angle);
/// Both functions of an angle, bit for bit as above, in little more than the time of one.
struct SineAndCosine {
	double sine;
	double cosine;
};
SineAndCosine portable_sine_and_cosine(double angle);
double portable_exp(double exponent);
/// The natural logarithm of a number above 0, within 1e-14 relative to it or to 1; NaN for all other values.
double portable_log(double value);
/// `base` to the power `exponent`, for bases from 0 on. 0 to the power 0 is 1; 0 to a negative one is infinite.
double portable_pow(double base, double exponent);
/// The angle of (x, y) from the x axis, -π to π; 0 for (0, 0). Within 1e-14 rad.
double portable_atan2(double y, double x);

} // namespace undergrowth
