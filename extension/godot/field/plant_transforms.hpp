#pragma once

#include "stand/plants.hpp"

#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <vector>

namespace undergrowth {

/// Reads an Array of Transform3D, or a PackedFloat32Array with 12 numbers for each; false where it is neither.
bool read_transforms(const godot::Variant &from, std::vector<godot::Transform3D> &to);

/// What a transform says about a plant: its place, scale and turn; a tilt becomes a lean to that side.
PlacedPlant place_transform(const godot::Transform3D &transform);

/// From a mesh to the field's axes, before it bends: a lean is in the plant's motion, and not in here.
godot::Transform3D drawn_transform(const PlacedPlant &plant);

} // namespace undergrowth
