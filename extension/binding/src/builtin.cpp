#include <godot_cpp/core/engine_calls.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

// Members of the built-in types besides their generated methods.

namespace godot {

using internal::gde;

String::String(const char *p_text) {
	gde.string_new_with_utf8_chars(this, p_text ? p_text : "");
}

String::String(const char32_t *p_text) {
	gde.string_new_with_utf32_chars(this, p_text);
}

String String::utf8(const char *p_text, int64_t p_length) {
	String result{ internal::Uninitialized() };
	gde.string_new_with_utf8_chars_and_len(&result, p_text, p_length);
	return result;
}

CharString String::utf8() const {
	std::string bytes(size_t(gde.string_to_utf8_chars(this, nullptr, 0)), '\0');
	gde.string_to_utf8_chars(this, bytes.data(), int64_t(bytes.size()));
	return CharString(std::move(bytes));
}

String &String::operator+=(const String &p_other) {
	gde.string_operator_plus_eq_string(this, &p_other);
	return *this;
}

String &String::operator+=(const char *p_text) {
	return *this += String(p_text);
}

String &String::operator+=(char32_t p_character) {
	gde.string_operator_plus_eq_char(this, p_character);
	return *this;
}

char32_t String::operator[](int64_t p_index) const {
	return *gde.string_operator_index_const(this, p_index);
}

bool String::operator==(const StringName &p_name) const {
	return *this == String(p_name);
}

// The engine creates names faster from Latin-1, which is equal to ASCII here.
StringName::StringName(const char *p_text, bool) {
	const char *text = p_text ? p_text : "";
	const char *end = text;
	while (static_cast<signed char>(*end) > 0) {
		end++;
	}
	if (*end == 0) {
		gde.string_name_new_with_latin1_chars(this, text, false);
	} else {
		gde.string_name_new_with_utf8_chars(this, text);
	}
}

bool StringName::operator==(const char *p_text) const {
	return String(*this) == p_text;
}

NodePath::NodePath(const char *p_text) : NodePath(String(p_text)) {}

Array::Array(std::initializer_list<Variant> p_values) : Array() {
	resize(int64_t(p_values.size()));
	int64_t index = 0;
	for (const Variant &value : p_values) {
		(*this)[index++] = value;
	}
}

Variant &Array::operator[](int64_t p_index) {
	return *static_cast<Variant *>(gde.array_operator_index(this, p_index));
}

const Variant &Array::operator[](int64_t p_index) const {
	return *static_cast<const Variant *>(gde.array_operator_index_const(this, p_index));
}

void Array::set_typed(uint32_t p_type, const StringName &p_class_name, const Variant &p_script) {
	gde.array_set_typed(this, GDExtensionVariantType(p_type), &p_class_name, &p_script);
}

void Array::_share(const Array &p_from) {
	gde.array_ref(this, &p_from);
}

Variant &Dictionary::operator[](const Variant &p_key) {
	return *static_cast<Variant *>(gde.dictionary_operator_index(this, &p_key));
}

const Variant &Dictionary::operator[](const Variant &p_key) const {
	return *static_cast<const Variant *>(gde.dictionary_operator_index_const(this, &p_key));
}

Callable Callable::custom(GDExtensionCallableCustomInfo2 &p_info) {
	Callable result{ internal::Uninitialized() };
	gde.callable_custom_create2(&result, &p_info);
	return result;
}

Quaternion::Quaternion(const Vector3 &p_axis, real_t p_angle) {
	const real_t s = std::sin(p_angle / 2) / p_axis.length();
	*this = Quaternion(p_axis.x * s, p_axis.y * s, p_axis.z * s, std::cos(p_angle / 2));
}

Quaternion::Quaternion(const Vector3 &p_from, const Vector3 &p_to) {
	internal::construct(GDEXTENSION_VARIANT_TYPE_QUATERNION, 4, this, p_from, p_to);
}

Quaternion::Quaternion(const Basis &p_basis) : Quaternion(p_basis.get_rotation_quaternion()) {}

Basis::Basis(const Quaternion &p_q) :
		Basis(p_q.xform(Vector3(1, 0, 0)), p_q.xform(Vector3(0, 1, 0)), p_q.xform(Vector3(0, 0, 1))) {}

void _err_print_error(const char *p_function, const char *p_file, int p_line, const char *p_error,
		const char *p_message, bool p_editor_notify, bool p_is_warning) {
	const bool has_message = p_message && *p_message;
	if (has_message) {
		(p_is_warning ? gde.print_warning_with_message : gde.print_error_with_message)(
				p_error, p_message, p_function, p_file, p_line, p_editor_notify);
	} else {
		(p_is_warning ? gde.print_warning : gde.print_error)(p_error, p_function, p_file, p_line, p_editor_notify);
	}
}

void _err_print_error(const char *p_function, const char *p_file, int p_line, const char *p_error,
		const String &p_message, bool p_editor_notify, bool p_is_warning) {
	_err_print_error(p_function, p_file, p_line, p_error, p_message.utf8().get_data(), p_editor_notify, p_is_warning);
}

void _err_print_error(const char *p_function, const char *p_file, int p_line, const String &p_error,
		const char *p_message, bool p_editor_notify, bool p_is_warning) {
	_err_print_error(p_function, p_file, p_line, p_error.utf8().get_data(), p_message, p_editor_notify, p_is_warning);
}

void _err_print_index_error(const char *p_function, const char *p_file, int p_line, int64_t p_index, int64_t p_size,
		const char *p_index_text, const char *p_size_text, const String &p_message) {
	const String error =
			vformat("Index %s = %d is out of bounds (%s = %d).", p_index_text, p_index, p_size_text, p_size);
	_err_print_error(p_function, p_file, p_line, error.utf8().get_data(), p_message);
}

void _err_print_index_error(const char *p_function, const char *p_file, int p_line, int64_t p_index, int64_t p_size,
		const char *p_index_text, const char *p_size_text) {
	_err_print_index_error(p_function, p_file, p_line, p_index, p_size, p_index_text, p_size_text, String());
}

} // namespace godot
