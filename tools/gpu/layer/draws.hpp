#pragma once

#include "driver.hpp"

#include <vector>

/// Command buffers that execute nothing, and the draws that the engine records into them. Each frame goes into the log:
/// its draws, summed up by pipeline and size of the target.
///
///     draw 12 1920x1080 draws=40 instances=5120 indices=245760 vertices=122880
///     frame 7
///
/// indices, vertices: those of the meshes, times instances. Indices repeat vertices, which a card mostly shades once.
namespace gpu {

/// Writes the draws since the last call.
void end_frame();

std::vector<Replacement> draw_replacements();

} // namespace gpu
