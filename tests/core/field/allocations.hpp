#pragma once

namespace undergrowth {

/// Allocations that this program has made with new. Always 0 where they are not counted.
long allocation_count();
/// Not with MSVC, which has no std::aligned_alloc(): what it has instead needs a delete of its own. Nor with a
/// sanitizer, which looks at allocations itself.
bool counts_allocations();

} // namespace undergrowth
