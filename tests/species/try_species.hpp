#pragma once

#include <atomic>
#include <cstdint>
#include <string>

/// What a species goes through, told while it does.
using Stage = std::atomic<const char *>;

/// Grows the species of a seed, draws it at a level and bends it. What is wrong with it, or nothing; `is_grown`:
/// whether it was not refused.
std::string try_species(uint64_t seed, Stage &stage, bool &is_grown);
