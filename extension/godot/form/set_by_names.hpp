#pragma once

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/dictionary.hpp>

namespace undergrowth {

/// Sets a resource's properties by their names. A number for a range means both of its ends. Names that it has not are
/// one error, which tells those that it has.
void set_by_names(godot::Resource *resource, const godot::Dictionary &values);

} // namespace undergrowth
