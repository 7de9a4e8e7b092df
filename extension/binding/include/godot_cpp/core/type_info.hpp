#pragma once

#include <type_traits>

#include <godot_cpp/classes/wrapped.hpp>
#include <godot_cpp/core/property_info.hpp>

// One description per C++ type. Calls in both directions use it: engine methods, bound methods, engine virtuals that
// the library overrides, and library methods that scripts override.
//   type, metadata   the engine's description of the type
//   Argument         contains a value in the form that a pointer call takes
//   Result           receives the result of a pointer call; is_direct: the value itself can receive it
//   load, store      read an argument that the engine passes, write a value that the library returns
//   from_variant, to_variant, accepts (beyond the Variant's type), describe

namespace godot {

template <typename T> class Ref;
template <typename T> class BitField;

namespace internal {

template <typename T, typename = void> struct TypeTraits;

template <typename T> using Plain = std::remove_cv_t<std::remove_reference_t<T>>;

template <typename T> struct PointerArgument {
	const T *value;
	PointerArgument(const T &p_value) : value(&p_value) {}
	const void *ptr() const { return value; }
};

template <typename T, int Type> struct DirectTraits {
	static constexpr Variant::Type type = Variant::Type(Type);
	static constexpr auto metadata = GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
	static constexpr bool is_direct = true;
	using Argument = PointerArgument<T>;
	static const T &load(const void *p_from) { return *static_cast<const T *>(p_from); }
	static void store(void *r_to, const T &p_value) { *static_cast<T *>(r_to) = p_value; }
	static T from_variant(const Variant &p_value) { return p_value.operator T(); }
	static Variant to_variant(const T &p_value) { return Variant(p_value); }
	static bool accepts(const Variant &) { return true; }
	static PropertyInfo describe() { return PropertyInfo(type, StringName()); }
};

#define GODOT_TYPE_TRAITS(m_type, m_id)                                                                                \
	template <> struct TypeTraits<m_type> : DirectTraits<m_type, GDEXTENSION_VARIANT_TYPE_##m_id> {};
GODOT_FOR_EACH_BUILTIN(GODOT_TYPE_TRAITS)
#undef GODOT_TYPE_TRAITS

template <> struct TypeTraits<Variant> : DirectTraits<Variant, GDEXTENSION_VARIANT_TYPE_NIL> {
	static Variant from_variant(const Variant &p_value) { return p_value; }
	static PropertyInfo describe() {
		return PropertyInfo(Variant::NIL, StringName(), PROPERTY_HINT_NONE, String(),
				PROPERTY_USAGE_DEFAULT | PROPERTY_USAGE_NIL_IS_VARIANT);
	}
};

// Types that are passed as another type: every integer as int64, float as double, bool as a byte.
template <typename T, typename Encoded, int Type, int Metadata> struct EncodedTraits {
	static constexpr Variant::Type type = Variant::Type(Type);
	static constexpr auto metadata = GDExtensionClassMethodArgumentMetadata(Metadata);
	static constexpr bool is_direct = false;
	struct Argument {
		Encoded value;
		Argument(T p_value) : value(Encoded(p_value)) {}
		const void *ptr() const { return &value; }
	};
	struct Result {
		Encoded value = 0;
		void *ptr() { return &value; }
		T take() { return T(value); }
	};
	static T load(const void *p_from) { return T(*static_cast<const Encoded *>(p_from)); }
	static void store(void *r_to, T p_value) { *static_cast<Encoded *>(r_to) = Encoded(p_value); }
	static T from_variant(const Variant &p_value) {
		if constexpr (std::is_floating_point_v<T>) {
			return T(p_value.operator double());
		} else if constexpr (std::is_same_v<T, bool>) {
			return p_value.operator bool();
		} else {
			return T(p_value.operator int64_t());
		}
	}
	static Variant to_variant(T p_value) { return Variant(p_value); }
	static bool accepts(const Variant &) { return true; }
	static PropertyInfo describe() { return PropertyInfo(type, StringName()); }
};

#define GODOT_NUMBER_TRAITS(m_type, m_encoded, m_id, m_metadata)                                                       \
	template <>                                                                                                        \
	struct TypeTraits<m_type> : EncodedTraits<m_type, m_encoded, GDEXTENSION_VARIANT_TYPE_##m_id,                      \
										GDEXTENSION_METHOD_ARGUMENT_METADATA_##m_metadata> {};
GODOT_NUMBER_TRAITS(bool, uint8_t, BOOL, NONE)
GODOT_NUMBER_TRAITS(int8_t, int64_t, INT, INT_IS_INT8)
GODOT_NUMBER_TRAITS(int16_t, int64_t, INT, INT_IS_INT16)
GODOT_NUMBER_TRAITS(int32_t, int64_t, INT, INT_IS_INT32)
GODOT_NUMBER_TRAITS(int64_t, int64_t, INT, INT_IS_INT64)
GODOT_NUMBER_TRAITS(uint8_t, int64_t, INT, INT_IS_UINT8)
GODOT_NUMBER_TRAITS(uint16_t, int64_t, INT, INT_IS_UINT16)
GODOT_NUMBER_TRAITS(uint32_t, int64_t, INT, INT_IS_UINT32)
GODOT_NUMBER_TRAITS(uint64_t, int64_t, INT, INT_IS_UINT64)
GODOT_NUMBER_TRAITS(char16_t, int64_t, INT, INT_IS_CHAR16)
GODOT_NUMBER_TRAITS(char32_t, int64_t, INT, INT_IS_CHAR32)
GODOT_NUMBER_TRAITS(float, double, FLOAT, REAL_IS_FLOAT)
GODOT_NUMBER_TRAITS(double, double, FLOAT, REAL_IS_DOUBLE)
#undef GODOT_NUMBER_TRAITS

// "undergrowth::Plant::Law" -> "Plant.Law", the engine's name of the enum.
StringName enum_class_name(const char *p_cpp_name);
// "undergrowth::Plant::Law" -> "Law", the registered name of its constants.
StringName enum_name(const char *p_cpp_name);

template <typename T, bool IsBitField>
struct EnumTraits : EncodedTraits<T, int64_t, GDEXTENSION_VARIANT_TYPE_INT, GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE> {
	static Variant to_variant(T p_value) { return Variant(int64_t(p_value)); }
	static PropertyInfo describe() {
		const uint32_t flag =
				IsBitField ? uint32_t(PROPERTY_USAGE_CLASS_IS_BITFIELD) : uint32_t(PROPERTY_USAGE_CLASS_IS_ENUM);
		return PropertyInfo(Variant::INT, StringName(), PROPERTY_HINT_NONE, String(), PROPERTY_USAGE_DEFAULT | flag,
				enum_class_name(TypeTraits<T>::cpp_name));
	}
};

// Returns the pointer of an engine object, for calls. Also for classes that are only declared.
inline void *owner_of(const void *p_wrapped) {
	return p_wrapped ? static_cast<const Wrapped *>(p_wrapped)->_owner : nullptr;
}

struct ObjectArgument {
	void *object;
	const void *ptr() const { return &object; }
};

template <typename T> struct TypeTraits<T *, std::enable_if_t<std::is_class_v<T>>> {
	using Class = std::remove_const_t<T>;
	static constexpr Variant::Type type = Variant::OBJECT;
	static constexpr auto metadata = GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
	static constexpr bool is_direct = false;
	struct Argument : ObjectArgument {
		Argument(const T *p_object) : ObjectArgument{ owner_of(p_object) } {}
	};
	struct Result {
		void *object = nullptr;
		void *ptr() { return &object; }
		T *take() { return static_cast<T *>(static_cast<void *>(wrapper_of(object))); }
	};
	static T *load(const void *p_from) {
		return p_from ? cast<T>(wrapper_of(*static_cast<void *const *>(p_from))) : nullptr;
	}
	static void store(void *r_to, const T *p_value) { *static_cast<void **>(r_to) = owner_of(p_value); }
	static T *from_variant(const Variant &p_value) { return cast<T>(wrapped_in(p_value)); }
	static Variant to_variant(const T *p_value) { return Variant(static_cast<const Object *>(p_value)); }
	static bool accepts(const Variant &p_value) { return !wrapped_in(p_value) || from_variant(p_value); }
	static PropertyInfo describe() {
		return PropertyInfo(
				type, StringName(), PROPERTY_HINT_NONE, String(), PROPERTY_USAGE_DEFAULT, Class::get_class_static());
	}
};

// A counted reference. An argument is a pointer to the object's pointer. A returned object has a reference for the
// caller.
template <typename T> struct TypeTraits<Ref<T>> {
	static constexpr Variant::Type type = Variant::OBJECT;
	static constexpr auto metadata = GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
	static constexpr bool is_direct = false;
	struct Argument : ObjectArgument {
		Argument(const Ref<T> &p_ref) : ObjectArgument{ owner_of(p_ref.ptr()) } {}
	};
	struct Result {
		void *object = nullptr;
		void *ptr() { return &object; }
		Ref<T> take() { return Ref<T>::adopt(static_cast<T *>(static_cast<void *>(wrapper_of(object)))); }
	};
	static Ref<T> load(const void *p_from) {
		return p_from ? Ref<T>(cast<T>(wrapper_of(gde.ref_get_object(p_from)))) : Ref<T>();
	}
	static void store(void *r_to, const Ref<T> &p_value) { gde.ref_set_object(r_to, owner_of(p_value.ptr())); }
	static Ref<T> from_variant(const Variant &p_value) { return Ref<T>(cast<T>(wrapped_in(p_value))); }
	static Variant to_variant(const Ref<T> &p_value) { return Variant(p_value); }
	static bool accepts(const Variant &p_value) {
		Wrapped *wrapped = wrapped_in(p_value);
		return !wrapped || cast<T>(wrapped);
	}
	static PropertyInfo describe() {
		return PropertyInfo(type, StringName(), PROPERTY_HINT_RESOURCE_TYPE, String(T::get_class_static()));
	}
};

} // namespace internal

// A set of flags of one enum.
template <typename T> class BitField {
	int64_t value = 0;

public:
	constexpr BitField() = default;
	constexpr BitField(int64_t p_value) : value(p_value) {}
	constexpr BitField(T p_value) : value(int64_t(p_value)) {}
	constexpr operator int64_t() const { return value; }
	constexpr void set_flag(T p_flag) { value |= int64_t(p_flag); }
	constexpr bool has_flag(T p_flag) const { return value & int64_t(p_flag); }
	constexpr void clear_flag(T p_flag) { value &= ~int64_t(p_flag); }
};

namespace internal {

template <typename T>
struct TypeTraits<BitField<T>>
		: EncodedTraits<BitField<T>, int64_t, GDEXTENSION_VARIANT_TYPE_INT, GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE> {
	static Variant to_variant(BitField<T> p_value) { return Variant(int64_t(p_value)); }
	static PropertyInfo describe() { return TypeTraits<T>::describe(); }
};

} // namespace internal

} // namespace godot

// After the class, outside of every namespace.
#define GODOT_ENUM_TRAITS(m_enum, m_is_bit_field)                                                                      \
	template <> struct internal::TypeTraits<m_enum> : EnumTraits<m_enum, m_is_bit_field> {                             \
		static constexpr const char *cpp_name = #m_enum;                                                               \
	};
#define VARIANT_ENUM_CAST(m_enum)                                                                                      \
	namespace godot {                                                                                                  \
	GODOT_ENUM_TRAITS(m_enum, false)                                                                                   \
	}
#define VARIANT_BITFIELD_CAST(m_enum)                                                                                  \
	namespace godot {                                                                                                  \
	GODOT_ENUM_TRAITS(m_enum, true)                                                                                    \
	}

namespace godot {

#define GODOT_GLOBAL_ENUM(m_enum) GODOT_ENUM_TRAITS(m_enum, false)
#include <godot_cpp/generated/global_enums.inc>
#undef GODOT_GLOBAL_ENUM
GODOT_ENUM_TRAITS(Variant::Type, false)
GODOT_ENUM_TRAITS(Variant::Operator, false)
GODOT_ENUM_TRAITS(Vector2::Axis, false)
GODOT_ENUM_TRAITS(Vector2i::Axis, false)
GODOT_ENUM_TRAITS(Vector3::Axis, false)
GODOT_ENUM_TRAITS(Vector3i::Axis, false)
GODOT_ENUM_TRAITS(Vector4::Axis, false)
GODOT_ENUM_TRAITS(Vector4i::Axis, false)
GODOT_ENUM_TRAITS(Projection::Planes, false)

} // namespace godot
