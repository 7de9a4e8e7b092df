#pragma once

#include <string>

#include <godot_cpp/core/defs.hpp>

namespace godot {

// The UTF-8 bytes of a String.
class CharString {
	std::string bytes;

public:
	CharString() = default;
	explicit CharString(std::string p_bytes) : bytes(std::move(p_bytes)) {}
	const char *get_data() const { return bytes.c_str(); }
	const char *ptr() const { return bytes.c_str(); }
	// Without the final zero.
	int64_t length() const { return int64_t(bytes.size()); }
	// With the final zero.
	int64_t size() const { return bytes.empty() ? 0 : int64_t(bytes.size()) + 1; }
};

} // namespace godot
