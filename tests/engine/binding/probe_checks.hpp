#pragma once

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>

// Inside of ProbeChecks.
#define CHECK(m_condition) check(m_condition, #m_condition)

namespace probe {

// What only C++ can see. Each method returns the checks that failed, as text.
class ProbeChecks : public godot::RefCounted {
	GDCLASS(ProbeChecks, godot::RefCounted)

	godot::PackedStringArray failures;

	void check(bool p_passed, const char *p_text);
	void check_threads();

protected:
	static void _bind_methods();

public:
	// Only the bundled binding reports some of these errors.
	static bool is_bundled_binding();
	// A method that no engine has: an error that names it, and an empty result.
	static godot::String call_missing_method();

	godot::PackedStringArray check_strings();
	godot::PackedStringArray check_arrays();
	godot::PackedStringArray check_math();
	godot::PackedStringArray check_variants();
	godot::PackedStringArray check_objects();
	godot::PackedStringArray check_engine();
};

} // namespace probe
