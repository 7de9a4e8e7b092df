#include <godot_cpp/variant/variant.hpp>

#include <utility>

#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/core/engine_calls.hpp>

namespace godot {

using internal::gde;
using internal::type_functions;

Variant::Variant() {
	gde.variant_new_nil(this);
}

Variant::Variant(const Variant &p_from) {
	gde.variant_new_copy(this, &p_from);
}

Variant::Variant(Variant &&p_from) : Variant() {
	std::swap(_opaque, p_from._opaque);
}

Variant::~Variant() {
	gde.variant_destroy(this);
}

Variant &Variant::operator=(const Variant &p_from) {
	if (this != &p_from) {
		Variant copy(p_from);
		std::swap(_opaque, copy._opaque);
	}
	return *this;
}

Variant &Variant::operator=(Variant &&p_from) {
	std::swap(_opaque, p_from._opaque);
	return *this;
}

void Variant::_set_int(int64_t p_value) {
	type_functions[INT].to_variant(this, &p_value);
}

void Variant::_set_float(double p_value) {
	type_functions[FLOAT].to_variant(this, &p_value);
}

void Variant::_set_bool(bool p_value) {
	GDExtensionBool encoded = p_value;
	type_functions[BOOL].to_variant(this, &encoded);
}

Variant::Variant(const char *p_text) : Variant(String(p_text)) {}

Variant::Variant(const Object *p_object) {
	void *owner = internal::owner_of(p_object);
	type_functions[OBJECT].to_variant(this, &owner);
}

#define GODOT_VARIANT_CONVERSIONS(m_type, m_id)                                                                        \
	Variant::Variant(const ::godot::m_type &p_value) {                                                                 \
		type_functions[m_id].to_variant(this, const_cast<::godot::m_type *>(&p_value));                                \
	}                                                                                                                  \
	Variant::operator ::godot::m_type() const {                                                                        \
		return internal::from_variant<::godot::m_type>(m_id, *this);                                                   \
	}

namespace internal {

template <typename T> T from_variant(Variant::Type p_type, const Variant &p_value) {
	if constexpr (std::is_constructible_v<T, Uninitialized>) {
		T result{ Uninitialized() };
		type_functions[p_type].from_variant(&result, const_cast<Variant *>(&p_value));
		return result;
	} else {
		T result;
		type_functions[p_type].from_variant(&result, const_cast<Variant *>(&p_value));
		return result;
	}
}

} // namespace internal

GODOT_FOR_EACH_BUILTIN(GODOT_VARIANT_CONVERSIONS)

Variant::operator bool() const {
	return internal::from_variant<GDExtensionBool>(BOOL, *this) != 0;
}

Variant::operator int64_t() const {
	return internal::from_variant<int64_t>(INT, *this);
}

Variant::operator double() const {
	return internal::from_variant<double>(FLOAT, *this);
}

Variant::operator Object *() const {
	return static_cast<Object *>(internal::wrapped_in(*this));
}

String Variant::get_type_name(Type p_type) {
	String name{ internal::Uninitialized() };
	gde.variant_get_type_name(GDExtensionVariantType(p_type), &name);
	return name;
}

bool Variant::can_convert(Type p_from, Type p_to) {
	return gde.variant_can_convert(GDExtensionVariantType(p_from), GDExtensionVariantType(p_to));
}

bool Variant::can_convert_strict(Type p_from, Type p_to) {
	return gde.variant_can_convert_strict(GDExtensionVariantType(p_from), GDExtensionVariantType(p_to));
}

void Variant::evaluate(Operator p_operator, const Variant &p_a, const Variant &p_b, Variant &r_result, bool &r_valid) {
	Variant result{ internal::Uninitialized() };
	GDExtensionBool valid = 0;
	gde.variant_evaluate(GDExtensionVariantOperator(p_operator), &p_a, &p_b, &result, &valid);
	r_result = std::move(result);
	r_valid = valid;
}

bool Variant::operator==(const Variant &p_other) const {
	Variant result;
	bool valid = false;
	evaluate(OP_EQUAL, *this, p_other, result, valid);
	return valid && result.booleanize();
}

bool Variant::operator<(const Variant &p_other) const {
	Variant result;
	bool valid = false;
	evaluate(OP_LESS, *this, p_other, result, valid);
	return valid && result.booleanize();
}

Variant Variant::get(const Variant &p_key, bool *r_valid) const {
	Variant result{ internal::Uninitialized() };
	GDExtensionBool valid = 0;
	gde.variant_get(this, &p_key, &result, &valid);
	if (r_valid) {
		*r_valid = valid;
	}
	return result;
}

void Variant::set(const Variant &p_key, const Variant &p_value, bool *r_valid) {
	GDExtensionBool valid = 0;
	gde.variant_set(this, &p_key, &p_value, &valid);
	if (r_valid) {
		*r_valid = valid;
	}
}

bool Variant::has_method(const StringName &p_method) const {
	return gde.variant_has_method(this, &p_method);
}

bool Variant::booleanize() const {
	return gde.variant_booleanize(this);
}

String Variant::stringify() const {
	String text;
	gde.variant_stringify(this, &text);
	return text;
}

int64_t Variant::hash() const {
	return gde.variant_hash(this);
}

Variant Variant::duplicate(bool p_deep) const {
	Variant result;
	gde.variant_duplicate(this, &result, p_deep);
	return result;
}

String vformat_array(const String &p_format, const Variant *p_values, int64_t p_count) {
	Array values;
	values.resize(p_count);
	for (int64_t i = 0; i < p_count; i++) {
		values[i] = p_values[i];
	}
	Variant result;
	bool valid = false;
	Variant::evaluate(Variant::OP_MODULE, p_format, values, result, valid);
	return valid ? result.operator String() : p_format;
}

} // namespace godot
