#pragma once

#include <cstdlib>

#include <godot_cpp/core/defs.hpp>

// Checks that print an error with its source location and return, as in the engine.

namespace godot {

class String;

void _err_print_error(const char *p_function, const char *p_file, int p_line, const char *p_error,
		const char *p_message = "", bool p_editor_notify = false, bool p_is_warning = false);
void _err_print_error(const char *p_function, const char *p_file, int p_line, const char *p_error,
		const String &p_message, bool p_editor_notify = false, bool p_is_warning = false);
void _err_print_error(const char *p_function, const char *p_file, int p_line, const String &p_error,
		const char *p_message = "", bool p_editor_notify = false, bool p_is_warning = false);
void _err_print_index_error(const char *p_function, const char *p_file, int p_line, int64_t p_index, int64_t p_size,
		const char *p_index_text, const char *p_size_text, const String &p_message);
void _err_print_index_error(const char *p_function, const char *p_file, int p_line, int64_t p_index, int64_t p_size,
		const char *p_index_text, const char *p_size_text);

} // namespace godot

#define GODOT_HERE __FUNCTION__, __FILE__, __LINE__
#define GODOT_FAIL_IF(m_condition, m_leave, ...)                                                                       \
	if (unlikely(m_condition)) {                                                                                       \
		::godot::_err_print_error(GODOT_HERE, __VA_ARGS__);                                                            \
		m_leave;                                                                                                       \
	} else                                                                                                             \
		((void)0)
#define GODOT_FAIL(m_leave, ...)                                                                                       \
	if (true) {                                                                                                        \
		::godot::_err_print_error(GODOT_HERE, __VA_ARGS__);                                                            \
		m_leave;                                                                                                       \
	} else                                                                                                             \
		((void)0)
#define GODOT_FAIL_INDEX(m_index, m_size, m_leave, ...)                                                                \
	if (unlikely((m_index) < 0 || (m_index) >= (m_size))) {                                                            \
		::godot::_err_print_index_error(GODOT_HERE, m_index, m_size, #m_index, #m_size __VA_ARGS__);                   \
		m_leave;                                                                                                       \
	} else                                                                                                             \
		((void)0)

#define ERR_FAIL() GODOT_FAIL(return, "Method/function failed.")
#define ERR_FAIL_MSG(m_msg) GODOT_FAIL(return, "Method/function failed.", m_msg)
#define ERR_FAIL_V(m_retval) GODOT_FAIL(return m_retval, "Method/function failed. Returning: " #m_retval)
#define ERR_FAIL_V_MSG(m_retval, m_msg)                                                                                \
	GODOT_FAIL(return m_retval, "Method/function failed. Returning: " #m_retval, m_msg)
#define ERR_FAIL_COND(m_cond) GODOT_FAIL_IF(m_cond, return, "Condition \"" #m_cond "\" is true.")
#define ERR_FAIL_COND_MSG(m_cond, m_msg) GODOT_FAIL_IF(m_cond, return, "Condition \"" #m_cond "\" is true.", m_msg)
#define ERR_FAIL_COND_V(m_cond, m_retval)                                                                              \
	GODOT_FAIL_IF(m_cond, return m_retval, "Condition \"" #m_cond "\" is true. Returning: " #m_retval)
#define ERR_FAIL_COND_V_MSG(m_cond, m_retval, m_msg)                                                                   \
	GODOT_FAIL_IF(m_cond, return m_retval, "Condition \"" #m_cond "\" is true. Returning: " #m_retval, m_msg)
#define ERR_FAIL_NULL(m_param) GODOT_FAIL_IF((m_param) == nullptr, return, "Parameter \"" #m_param "\" is null.")
#define ERR_FAIL_NULL_MSG(m_param, m_msg)                                                                              \
	GODOT_FAIL_IF((m_param) == nullptr, return, "Parameter \"" #m_param "\" is null.", m_msg)
#define ERR_FAIL_NULL_V(m_param, m_retval)                                                                             \
	GODOT_FAIL_IF((m_param) == nullptr, return m_retval, "Parameter \"" #m_param "\" is null.")
#define ERR_FAIL_NULL_V_MSG(m_param, m_retval, m_msg)                                                                  \
	GODOT_FAIL_IF((m_param) == nullptr, return m_retval, "Parameter \"" #m_param "\" is null.", m_msg)
#define GODOT_COMMA_MESSAGE(m_msg) , m_msg
#define ERR_FAIL_INDEX(m_index, m_size) GODOT_FAIL_INDEX(m_index, m_size, return, )
#define ERR_FAIL_INDEX_MSG(m_index, m_size, m_msg) GODOT_FAIL_INDEX(m_index, m_size, return, GODOT_COMMA_MESSAGE(m_msg))
#define ERR_FAIL_INDEX_V(m_index, m_size, m_retval) GODOT_FAIL_INDEX(m_index, m_size, return m_retval, )
#define ERR_FAIL_INDEX_V_MSG(m_index, m_size, m_retval, m_msg)                                                         \
	GODOT_FAIL_INDEX(m_index, m_size, return m_retval, GODOT_COMMA_MESSAGE(m_msg))
#define ERR_CONTINUE(m_cond) GODOT_FAIL_IF(m_cond, continue, "Condition \"" #m_cond "\" is true. Continuing.")
#define ERR_CONTINUE_MSG(m_cond, m_msg)                                                                                \
	GODOT_FAIL_IF(m_cond, continue, "Condition \"" #m_cond "\" is true. Continuing.", m_msg)
#define ERR_BREAK(m_cond) GODOT_FAIL_IF(m_cond, break, "Condition \"" #m_cond "\" is true. Breaking.")
#define ERR_BREAK_MSG(m_cond, m_msg) GODOT_FAIL_IF(m_cond, break, "Condition \"" #m_cond "\" is true. Breaking.", m_msg)
#define CRASH_COND(m_cond) GODOT_FAIL_IF(m_cond, std::abort(), "FATAL: Condition \"" #m_cond "\" is true.")
#define CRASH_COND_MSG(m_cond, m_msg)                                                                                  \
	GODOT_FAIL_IF(m_cond, std::abort(), "FATAL: Condition \"" #m_cond "\" is true.", m_msg)

#define ERR_PRINT(m_msg) ::godot::_err_print_error(GODOT_HERE, m_msg)
#define ERR_PRINT_ED(m_msg) ::godot::_err_print_error(GODOT_HERE, m_msg, "", true)
#define WARN_PRINT(m_msg) ::godot::_err_print_error(GODOT_HERE, m_msg, "", false, true)
#define WARN_PRINT_ED(m_msg) ::godot::_err_print_error(GODOT_HERE, m_msg, "", true, true)
#define GODOT_ONCE(m_statement)                                                                                        \
	if (true) {                                                                                                        \
		static bool already_printed = false;                                                                           \
		if (!already_printed) {                                                                                        \
			already_printed = true;                                                                                    \
			m_statement;                                                                                               \
		}                                                                                                              \
	} else                                                                                                             \
		((void)0)
#define ERR_PRINT_ONCE(m_msg) GODOT_ONCE(ERR_PRINT(m_msg))
#define WARN_PRINT_ONCE(m_msg) GODOT_ONCE(WARN_PRINT(m_msg))
