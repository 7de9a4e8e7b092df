#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

/// FNV-1a, 64 bits: one number for many bytes. A golden hash in a test fixes a result to the bit, on every platform.
/// After an intended change of the result, the test's output contains the new number.
class GoldenHash {
public:
	template <class T> GoldenHash &add(const std::vector<T> &values) { return add(values.data(), values.size()); }

	/// `count` values of a type without padding.
	template <class T> GoldenHash &add(const T *values, std::size_t count) {
		const auto *bytes = reinterpret_cast<const unsigned char *>(values);
		for (std::size_t i = 0; i < count * sizeof(T); i++) {
			hash = (hash ^ bytes[i]) * 0x100000001b3ull;
		}
		return *this;
	}

	uint64_t value() const { return hash; }

private:
	uint64_t hash = 0xcbf29ce484222325ull;
};
