#pragma once

#include <godot_cpp/variant/array.hpp>

namespace undergrowth {

/// Removes the vertices of the engine's arrays of a surface that no triangle uses, as in coarse levels of detail.
void keep_used_vertices(godot::Array &arrays);

} // namespace undergrowth
