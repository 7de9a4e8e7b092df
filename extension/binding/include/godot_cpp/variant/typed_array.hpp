#pragma once

#include <godot_cpp/core/type_info.hpp>
#include <godot_cpp/variant/array.hpp>

namespace godot {

// An Array with elements of one type, which the engine checks.
template <typename T> class TypedArray : public Array {
	using Held = std::conditional_t<std::is_base_of_v<Object, T>, T *, T>;

	void _declare() {
		const PropertyInfo info = internal::TypeTraits<Held>::describe();
		set_typed(uint32_t(info.type), info.class_name, Variant());
	}

public:
	TypedArray() { _declare(); }
	TypedArray(const Array &p_array) {
		_declare();
		if (is_same_typed(p_array)) {
			_share(p_array);
		} else {
			assign(p_array);
		}
	}
	TypedArray(const Variant &p_variant) : TypedArray(p_variant.operator Array()) {}
	TypedArray(std::initializer_list<Variant> p_values) : TypedArray(Array(p_values)) {}
	void operator=(const Array &p_array) { *this = TypedArray(p_array); }
};

namespace internal {

template <typename T> struct TypeTraits<TypedArray<T>> {
	static constexpr Variant::Type type = Variant::ARRAY;
	static constexpr auto metadata = GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
	static constexpr bool is_direct = false;
	using Argument = PointerArgument<TypedArray<T>>;
	struct Result {
		Array value;
		void *ptr() { return &value; }
		TypedArray<T> take() { return TypedArray<T>(value); }
	};
	static TypedArray<T> load(const void *p_from) { return TypedArray<T>(*static_cast<const Array *>(p_from)); }
	static void store(void *r_to, const TypedArray<T> &p_value) { *static_cast<Array *>(r_to) = p_value; }
	static TypedArray<T> from_variant(const Variant &p_value) { return TypedArray<T>(p_value.operator Array()); }
	static Variant to_variant(const TypedArray<T> &p_value) { return Variant(p_value); }
	static bool accepts(const Variant &) { return true; }
	static PropertyInfo describe() {
		using Held = std::conditional_t<std::is_base_of_v<Object, T>, T *, T>;
		const PropertyInfo element = TypeTraits<Held>::describe();
		const String name =
				element.type == Variant::OBJECT ? String(element.class_name) : Variant::get_type_name(element.type);
		return PropertyInfo(Variant::ARRAY, StringName(), PROPERTY_HINT_ARRAY_TYPE, name);
	}
};

} // namespace internal

} // namespace godot
