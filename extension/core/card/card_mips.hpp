#pragma once

#include "card/card_sheet.hpp"

namespace undergrowth {

/// Writes both textures of a layer with all their mipmaps, and its mean colour, from a picture. Each mipmap covers as
/// much as the picture (Castaño 2010). Texels that are not covered get the colours of their neighbours.
void write_layers(const std::vector<CardPicture> &pictures, const std::vector<CardLayer *> &layers);

/// Returns the size of the largest texel of a sheet (m). Nearer cards look blurred.
float texel_of(const CardSheet &sheet);

} // namespace undergrowth
