#pragma once

#include "wind/field_wind.hpp"

#include <godot_cpp/classes/material.hpp>

namespace undergrowth {

/// Sets `air` at `time` of its clock in a material that includes undergrowth_wind.gdshaderinc.
void show_wind(const FieldWind &air, double time, const godot::Ref<godot::Material> &material);

/// Frees the textures that the materials share. The library calls it before it is unloaded.
void free_wind_textures();

} // namespace undergrowth
