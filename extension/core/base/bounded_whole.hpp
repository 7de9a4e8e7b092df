#pragma once

namespace undergrowth {

/// The whole number next to `value` towards 0, within `min` and `max`, which an int can hold exactly as doubles; `min`
/// where `value` is not a number. A plain conversion is undefined outside an int's range.
inline int bounded_whole(double value, int min, int max) {
	const auto low = static_cast<double>(min);
	const auto high = static_cast<double>(max);
	const double above = value >= low ? value : low;
	return static_cast<int>(above <= high ? above : high);
}

} // namespace undergrowth
