#pragma once

#include <array>

#include <godot_cpp/variant/builtin_types.hpp>
#include <godot_cpp/variant/variant_class.hpp>

namespace godot {

String vformat_array(const String &p_format, const Variant *p_values, int64_t p_count);

// GDScript's % operator: vformat("%s is %d", name, count).
template <typename... Args> String vformat(const String &p_format, const Args &...p_args) {
	const std::array<Variant, sizeof...(Args)> values{ { Variant(p_args)... } };
	return vformat_array(p_format, values.data(), int64_t(values.size()));
}

} // namespace godot
