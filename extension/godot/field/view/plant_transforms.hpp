#pragma once

#include "placement/plants.hpp"

#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <vector>

namespace undergrowth {

/// Reads an Array of Transform3D, or a PackedFloat32Array with 12 numbers each. Returns false for any other type.
bool read_transforms(const godot::Variant &from, std::vector<godot::Transform3D> &to);

/// Converts a transform to a plant: position, scale and turn. A tilt becomes a lean to that side.
PlacedPlant place_transform(const godot::Transform3D &transform);

/// Returns the transform from a mesh to the field's axes before bending. It has no lean: the plant's motion adds it.
godot::Transform3D drawn_transform(const PlacedPlant &plant);

/// Returns the transform of instances whose plants' y axis has this x in the field's axes. Points at `height` (m, field
/// axes) stay.
godot::Transform3D tilted(const godot::Transform3D &placed, float tilt, float height);

} // namespace undergrowth
