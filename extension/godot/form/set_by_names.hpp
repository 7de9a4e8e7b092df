#pragma once

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/dictionary.hpp>

namespace undergrowth {

/// Sets properties of a resource by their names. A number for a range sets both of its ends. Names that do not exist
/// are reported in one error, which lists the existing ones.
void set_by_names(godot::Resource *resource, const godot::Dictionary &values);

} // namespace undergrowth
