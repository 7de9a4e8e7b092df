#include "allocations.hpp"

#include "../base/sanitized.hpp"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

// Every allocation of this program uses these operators, so tests can count those of a step.

#if !defined(_WIN32) && !defined(UNDERGROWTH_SANITIZED)

namespace {

std::atomic<long> allocations{ 0 };

void *take(std::size_t size, std::size_t alignment) {
	allocations++;
	const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
	void *memory = alignment > alignof(std::max_align_t) ? std::aligned_alloc(alignment, rounded) : std::malloc(size);
	if (!memory) {
		throw std::bad_alloc();
	}
	return memory;
}

} // namespace

void *operator new(std::size_t size) {
	return take(size > 0 ? size : 1, 1);
}
void *operator new(std::size_t size, std::align_val_t alignment) {
	return take(size > 0 ? size : 1, static_cast<std::size_t>(alignment));
}
void operator delete(void *memory) noexcept {
	std::free(memory);
}
void operator delete(void *memory, std::size_t) noexcept {
	std::free(memory);
}
void operator delete(void *memory, std::align_val_t) noexcept {
	std::free(memory);
}
void operator delete(void *memory, std::size_t, std::align_val_t) noexcept {
	std::free(memory);
}

namespace undergrowth {

long allocation_count() {
	return allocations.load();
}

bool counts_allocations() {
	return true;
}

} // namespace undergrowth

#else

namespace undergrowth {

long allocation_count() {
	return 0;
}

bool counts_allocations() {
	return false;
}

} // namespace undergrowth

#endif
