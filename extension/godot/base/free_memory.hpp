#pragma once

namespace undergrowth {

/// Returns freed memory to the system where the C library keeps it (glibc). Elsewhere does nothing. Needs about 70 µs
/// per MB that it returns; allocations of other threads may wait for a part of that. Any thread.
void return_free_memory();

} // namespace undergrowth
