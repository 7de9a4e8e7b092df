#pragma once

#include "field/field_options.hpp"
#include "stand/area.hpp"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/string.hpp>

#include <vector>

namespace undergrowth {

// Where a field may grow, read from paths in the scene and from what is painted. Main thread. What returns a String
// tells what is wrong and what to do about it, or nothing.

/// The field's outline in its own axes: what is painted; else what a Path3D goes around, or a band along it; else the
/// rectangle.
Polygon read_outline(const godot::Node3D *field, const StandOptions &options);
/// Of an outline that is set.
godot::String find_outline_fault(const godot::Node3D *field, const StandOptions &options);

/// What an entry of the exclusions keeps free, in the field's axes.
godot::String read_exclusion(const godot::Node3D *field, const StandOptions &options, int entry, Polygon &into);

/// The nodes that outline and exclusions hang on; some may be null.
std::vector<godot::Node3D *> find_area_nodes(const godot::Node3D *field, const StandOptions &options);

} // namespace undergrowth
