#pragma once

/// Conventions of the whole core. Other headers refer to this page instead of repeating it.
///
/// - Units: SI. Metres, kilograms, seconds, newtons; angles in radians, frequencies in hertz (cycles per second).
/// - Axes: Godot's. x right, y up, z towards the viewer. The ground is the plane y = 0, a root is at the origin.
/// - Offset: place along a plant's height, 0 at the ground, 1 at the tip.
/// - Ring: a closed, simple polygon in the plane y = 0, stored as (x, z) pairs. It runs counter-clockwise as seen from
///   above with x to the right and z towards the viewer: (-1, 0), (0, 1), (1, 0), (0, -1).
/// - Winding: triangles are clockwise as seen from outside, which is Godot's front face (thesis, figure 2.1).
/// - Direction: a unit vector from a plant's root to its tip, in world axes. Its rate of change (1/s) times the plant's
///   length is the tip's velocity (m/s).
/// - Wind: a force on the tip (N). Direction 0 blows from -z to +z, a quarter turn blows from -x to +x.
/// - Colours: interpolated as the author wrote them; components from 0 to 1, not premultiplied.
/// - Seeds: 64 bits. Equal arguments and equal seeds give equal bytes on every platform: the core uses only operations
///   that IEEE 754 rounds exactly, and its own sine, cosine and exponential (base/portable_math.hpp).
///
/// The core includes the standard library and GLM only. Time and seed are arguments, there is no global state.
namespace undergrowth {

inline constexpr double PI = 3.14159265358979323846;
inline constexpr float STANDARD_GRAVITY = 9.81f; ///< m/s², as in the thesis, snippet 3.1.

} // namespace undergrowth
