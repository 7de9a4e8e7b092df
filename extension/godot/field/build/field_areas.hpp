#pragma once

#include "field/resources/field_options.hpp"
#include "placement/area.hpp"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/variant/string.hpp>

#include <vector>

namespace undergrowth {

// Reads the area of a field from paths in the scene and from its map. Main thread. A returned String describes a fault
// and its remedy; empty: no fault.

/// Returns the field's outline in its own axes: the painted area, else the inside of a Path3D or a band along it, else
/// the rectangle.
Polygon read_outline(const godot::Node3D *field, const PlacementOptions &options);
/// Checks an outline that is set.
godot::String find_outline_fault(const godot::Node3D *field, const PlacementOptions &options);

/// Reads the area of an entry of the exclusions, in the field's axes.
godot::String read_exclusion(const godot::Node3D *field, const PlacementOptions &options, int entry, Polygon &into);

/// Returns the points of a Path3D, or of the outline of a PlantField3D, in the field's axes. Sets whether it is closed.
Polygon read_line(const godot::Node3D *field, const godot::Node3D *node, bool &is_closed);

/// Returns the nodes that outline and exclusions depend on; some may be null.
std::vector<godot::Node3D *> find_area_nodes(const godot::Node3D *field, const PlacementOptions &options);

} // namespace undergrowth
