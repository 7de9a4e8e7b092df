#pragma once

#include "wind/field_wind.hpp"

#include <godot_cpp/classes/material.hpp>

namespace undergrowth {

/// Sets `air` at `time` of its clock in a material that includes undergrowth_wind.gdshaderinc.
void show_wind(const FieldWind &air, double time, const godot::Ref<godot::Material> &material);

/// Adds the global shader parameters that undergrowth_scene_wind.gdshaderinc declares, in calm air. In the editor it
/// adds them to the settings of the project, too, so that they exist before a game loads its first shader.
void add_scene_wind_parameters();
/// Sets `air` at `time` of its clock in the global shader parameters.
void show_scene_wind(const FieldWind &air, double time);
/// Sets calm air in them.
void calm_scene_wind();

/// Frees the textures that the materials share. The library calls it before it is unloaded.
void free_wind_textures();

} // namespace undergrowth
