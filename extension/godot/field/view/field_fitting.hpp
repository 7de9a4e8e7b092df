#pragma once

#include "field/view/field_render_setup.hpp"

namespace undergrowth {

/// Sets the levels of all styles: those of the field, at distances that fit each species. Species of parts whose levels
/// are chosen by error need measure() before. Any thread.
void fit_levels(FieldRenderSetup &setup);
/// The same for one style, without a limit of triangles.
void fit_levels(const FieldRenderSetup &setup, SpeciesStyle &style);

/// Gives each style of parts one coarse level, at all distances, which needs no measure(). Any thread.
void fit_drafts(FieldRenderSetup &setup);

/// Changes the squares of a level to its distances: small near the camera, where levels are short and plants have many
/// vertices, and large far away.
void fit_tiles(FieldLevel &level, float tile_size, bool is_wider);

} // namespace undergrowth
