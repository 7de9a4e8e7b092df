#pragma once

#include "wind/travelling_wind.hpp"

#include <godot_cpp/classes/material.hpp>

namespace undergrowth {

/// Tells a material whose shader includes undergrowth_wind.gdshaderinc how air blows at a time of its clock.
void show_wind(const FieldWind &air, double time, const godot::Ref<godot::Material> &material);

/// Lets the textures go that they share. The library calls it before it is unloaded.
void free_wind_textures();

} // namespace undergrowth
