#pragma once

namespace undergrowth {

/// Number of allocations that this program has made with new. Always 0 if they are not counted.
long allocation_count();
/// False with MSVC, which has no std::aligned_alloc(): its replacement needs a different delete. Also false with a
/// sanitizer, which tracks allocations itself.
bool counts_allocations();

} // namespace undergrowth
