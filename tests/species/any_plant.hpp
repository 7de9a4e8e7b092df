#pragma once

#include "../core/form/any_species.hpp"

/// Grows one plant at random: a recipe or, as scripts do, part by part; with a stem or without; at times with numbers
/// and handles that no plant can have. Tells whether anything has grown that can be drawn.
bool grow_any_plant(Chance &chance, uint64_t seed, undergrowth::PlantForm &form);
