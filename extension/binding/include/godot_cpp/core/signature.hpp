#pragma once

#include <utility>
#include <vector>

#include <godot_cpp/core/type_info.hpp>

// Functions of the library that the engine calls, with any parameters.

namespace godot::internal {

template <typename R, typename... A> struct Signature {
	using Result = R;
	static constexpr size_t count = sizeof...(A);

	// The engine passes pointers to the values and to the result.
	template <typename F>
	static void call_pointers(F p_function, const GDExtensionConstTypePtr *p_arguments, void *r_result) {
		call_pointers(p_function, p_arguments, r_result, std::index_sequence_for<A...>());
	}
	// The engine passes Variants of the correct types.
	template <typename F>
	static void call_variants(F p_function, const Variant *const *p_arguments, Variant &r_result) {
		call_variants(p_function, p_arguments, r_result, std::index_sequence_for<A...>());
	}
	// Returns the index of the first value that cannot be converted to its argument, or -1. Sets r_expected to the
	// argument's type.
	static int first_wrong(const Variant *const *p_arguments, int32_t &r_expected) {
		int index = 0;
		int wrong = -1;
		((wrong < 0 && !fits<A>(*p_arguments[index], r_expected) ? void(wrong = index) : void(), index++), ...);
		(void)p_arguments;
		(void)r_expected;
		return wrong;
	}
	static std::vector<PropertyInfo> describe_arguments() { return { TypeTraits<Plain<A>>::describe()... }; }
	static std::vector<GDExtensionClassMethodArgumentMetadata> describe_metadata() {
		return { TypeTraits<Plain<A>>::metadata... };
	}
	static PropertyInfo describe_result() {
		if constexpr (std::is_void_v<R>) {
			return PropertyInfo();
		} else {
			return TypeTraits<Plain<R>>::describe();
		}
	}
	static GDExtensionClassMethodArgumentMetadata result_metadata() {
		if constexpr (std::is_void_v<R>) {
			return GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
		} else {
			return TypeTraits<Plain<R>>::metadata;
		}
	}

private:
	template <typename T> static bool fits(const Variant &p_value, int32_t &r_expected) {
		using Traits = TypeTraits<Plain<T>>;
		r_expected = int32_t(Traits::type);
		if constexpr (Traits::type == Variant::NIL) {
			return true;
		}
		const Variant::Type given = p_value.get_type();
		return (given == Traits::type || Variant::can_convert_strict(given, Traits::type)) && Traits::accepts(p_value);
	}
	template <typename F, size_t... I>
	static void call_pointers(F p_function, [[maybe_unused]] const GDExtensionConstTypePtr *p_arguments,
			[[maybe_unused]] void *r_result, std::index_sequence<I...>) {
		if constexpr (std::is_void_v<R>) {
			p_function(TypeTraits<Plain<A>>::load(p_arguments[I])...);
		} else {
			TypeTraits<Plain<R>>::store(r_result, p_function(TypeTraits<Plain<A>>::load(p_arguments[I])...));
		}
	}
	template <typename F, size_t... I>
	static void call_variants(F p_function, [[maybe_unused]] const Variant *const *p_arguments,
			[[maybe_unused]] Variant &r_result, std::index_sequence<I...>) {
		if constexpr (std::is_void_v<R>) {
			p_function(TypeTraits<Plain<A>>::from_variant(*p_arguments[I])...);
		} else {
			r_result = TypeTraits<Plain<R>>::to_variant(
					p_function(TypeTraits<Plain<A>>::from_variant(*p_arguments[I])...));
		}
	}
};

// The parts of a function type: the class that declares it, its signature and its constness.
template <typename M> struct FunctionType;
template <typename R, typename C, typename... A> struct FunctionType<R (C::*)(A...)> {
	using Class = C;
	using Parts = Signature<R, A...>;
	static constexpr bool is_const = false;
};
template <typename R, typename C, typename... A> struct FunctionType<R (C::*)(A...) const> {
	using Class = C;
	using Parts = Signature<R, A...>;
	static constexpr bool is_const = true;
};
template <typename R, typename... A> struct FunctionType<R (*)(A...)> {
	using Class = void;
	using Parts = Signature<R, A...>;
	static constexpr bool is_const = false;
};

} // namespace godot::internal
