#include "base/free_memory.hpp"

#ifdef __linux__
#include <features.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace undergrowth {

void return_free_memory() {
#ifdef __GLIBC__
	malloc_trim(0);
#endif
}

} // namespace undergrowth
