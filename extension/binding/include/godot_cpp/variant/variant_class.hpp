#pragma once

#include <type_traits>

#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/core/interface.hpp>

namespace godot {

template <typename T> class Ref;

// All built-in types that a Variant contains, each with its engine type.
#define GODOT_FOR_EACH_BUILTIN(m_do)                                                                                   \
	m_do(String, STRING) m_do(Vector2, VECTOR2) m_do(Vector2i, VECTOR2I) m_do(Rect2, RECT2) m_do(Rect2i, RECT2I) m_do( \
			Vector3, VECTOR3) m_do(Vector3i, VECTOR3I) m_do(Transform2D, TRANSFORM2D) m_do(Vector4,                    \
			VECTOR4) m_do(Vector4i, VECTOR4I) m_do(Plane, PLANE) m_do(Quaternion, QUATERNION) m_do(AABB,               \
			AABB) m_do(Basis, BASIS) m_do(Transform3D, TRANSFORM3D) m_do(Projection, PROJECTION) m_do(Color,           \
			COLOR) m_do(StringName, STRING_NAME) m_do(NodePath, NODE_PATH) m_do(RID, RID) m_do(Callable,               \
			CALLABLE) m_do(Signal, SIGNAL) m_do(Dictionary, DICTIONARY) m_do(Array, ARRAY) m_do(PackedByteArray,       \
			PACKED_BYTE_ARRAY) m_do(PackedInt32Array, PACKED_INT32_ARRAY) m_do(PackedInt64Array, PACKED_INT64_ARRAY)   \
			m_do(PackedFloat32Array, PACKED_FLOAT32_ARRAY) m_do(PackedFloat64Array, PACKED_FLOAT64_ARRAY)              \
					m_do(PackedStringArray, PACKED_STRING_ARRAY) m_do(PackedVector2Array, PACKED_VECTOR2_ARRAY)        \
							m_do(PackedVector3Array, PACKED_VECTOR3_ARRAY) m_do(PackedColorArray, PACKED_COLOR_ARRAY)  \
									m_do(PackedVector4Array, PACKED_VECTOR4_ARRAY)

// A value of any type of the engine.
class Variant {
	alignas(8) uint8_t _opaque[24];

	void _set_int(int64_t p_value);
	void _set_float(double p_value);
	void _set_bool(bool p_value);

public:
#include <godot_cpp/generated/variant_enums.inc>

	Variant();
	Variant(const Variant &p_from);
	Variant(Variant &&p_from);
	explicit Variant(internal::Uninitialized) {}
	Variant(std::nullptr_t) : Variant() {}
	template <typename T, std::enable_if_t<std::is_arithmetic_v<T>, int> = 0> Variant(T p_value) {
		if constexpr (std::is_same_v<T, bool>) {
			_set_bool(p_value);
		} else if constexpr (std::is_integral_v<T>) {
			_set_int(int64_t(p_value));
		} else {
			_set_float(double(p_value));
		}
	}
	template <typename T, std::enable_if_t<std::is_enum_v<T>, int> = 0> Variant(T p_value) {
		_set_int(int64_t(p_value));
	}
	Variant(const char *p_text);
	Variant(const Object *p_object);
	template <typename T> Variant(const Ref<T> &p_ref) : Variant(static_cast<const Object *>(p_ref.ptr())) {}
#define GODOT_VARIANT_CONSTRUCTOR(m_type, m_id) Variant(const ::godot::m_type &p_value);
	GODOT_FOR_EACH_BUILTIN(GODOT_VARIANT_CONSTRUCTOR)
#undef GODOT_VARIANT_CONSTRUCTOR
	~Variant();
	Variant &operator=(const Variant &p_from);
	Variant &operator=(Variant &&p_from);

	Type get_type() const { return Type(internal::gde.variant_get_type(this)); }
	static String get_type_name(Type p_type);
	static bool can_convert(Type p_from, Type p_to);
	static bool can_convert_strict(Type p_from, Type p_to);

	operator bool() const;
	operator int64_t() const;
	operator int32_t() const { return int32_t(operator int64_t()); }
	operator uint64_t() const { return uint64_t(operator int64_t()); }
	operator uint32_t() const { return uint32_t(operator int64_t()); }
	operator double() const;
	operator float() const { return float(operator double()); }
	// Returns the object, or null if there is none or it was freed.
	operator Object *() const;
	Object *get_validated_object() const { return operator Object *(); }
#define GODOT_VARIANT_OPERATOR(m_type, m_id) operator ::godot::m_type() const;
	GODOT_FOR_EACH_BUILTIN(GODOT_VARIANT_OPERATOR)
#undef GODOT_VARIANT_OPERATOR

	bool operator==(const Variant &p_other) const;
	bool operator!=(const Variant &p_other) const { return !(*this == p_other); }
	bool operator<(const Variant &p_other) const;

	Variant get(const Variant &p_key, bool *r_valid = nullptr) const;
	void set(const Variant &p_key, const Variant &p_value, bool *r_valid = nullptr);
	bool has_method(const StringName &p_method) const;
	bool booleanize() const;
	String stringify() const;
	int64_t hash() const;
	Variant duplicate(bool p_deep = false) const;
	static void evaluate(Operator p_operator, const Variant &p_a, const Variant &p_b, Variant &r_result, bool &r_valid);
};

static_assert(sizeof(Variant) == 24, "the engine's Variant takes 24 bytes");

} // namespace godot
