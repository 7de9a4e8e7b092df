#pragma once

#include <atomic>
#include <utility>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/core/type_info.hpp>

// Used by the generated code: records of engine functions, found at their first use, and calls of them.

namespace godot::internal {

// Reports a function that this engine does not have, because the library was built for another version.
void report_missing(const char *p_class, const char *p_name, int64_t p_hash);
// Reports an error of a call, with its name.
void report_call_error(const char *p_name, const GDExtensionCallError &p_error);

// A function of the engine, given by its name and the hash of its signature. Constant until its first call finds it.
template <typename Pointer, Pointer (*Find)(const char *, const char *, int, int64_t)> class EngineFunction {
	const char *owner;
	const char *name;
	int type;
	int64_t hash;
	std::atomic<Pointer> found{ nullptr };

public:
	constexpr EngineFunction(const char *p_owner, const char *p_name, int64_t p_hash) :
			owner(p_owner), name(p_name), type(0), hash(p_hash) {}
	constexpr EngineFunction(GDExtensionVariantType p_type, const char *p_name, int64_t p_hash) :
			owner("a built-in type"), name(p_name), type(p_type), hash(p_hash) {}
	constexpr EngineFunction(const char *p_name, int64_t p_hash) :
			owner("the utility functions"), name(p_name), type(0), hash(p_hash) {}

	const char *get_name() const { return name; }
	Pointer get() {
		Pointer pointer = found.load(std::memory_order_acquire);
		if (unlikely(!pointer)) {
			pointer = Find(owner, name, type, hash);
			if (!pointer) {
				report_missing(owner, name, hash);
			}
			found.store(pointer, std::memory_order_release);
		}
		return pointer;
	}
};

GDExtensionMethodBindPtr find_engine_method(const char *p_class, const char *p_name, int, int64_t p_hash);
GDExtensionPtrBuiltInMethod find_builtin_method(const char *, const char *p_name, int p_type, int64_t p_hash);
GDExtensionPtrUtilityFunction find_utility_function(const char *, const char *p_name, int, int64_t p_hash);

using EngineMethod = EngineFunction<GDExtensionMethodBindPtr, find_engine_method>;
using BuiltinMethod = EngineFunction<GDExtensionPtrBuiltInMethod, find_builtin_method>;
using UtilityFunction = EngineFunction<GDExtensionPtrUtilityFunction, find_utility_function>;

class Operator {
	GDExtensionVariantOperator op;
	GDExtensionVariantType left;
	GDExtensionVariantType right;
	std::atomic<GDExtensionPtrOperatorEvaluator> found{ nullptr };

public:
	constexpr Operator(GDExtensionVariantOperator p_op, GDExtensionVariantType p_left, GDExtensionVariantType p_right) :
			op(p_op), left(p_left), right(p_right) {}
	GDExtensionPtrOperatorEvaluator get() {
		GDExtensionPtrOperatorEvaluator pointer = found.load(std::memory_order_acquire);
		if (unlikely(!pointer)) {
			pointer = gde.variant_get_ptr_operator_evaluator(op, left, right);
			found.store(pointer, std::memory_order_release);
		}
		return pointer;
	}
};

// The wrapper of a singleton, found at its first use. Valid until the engine frees the singleton or the library is
// unloaded.
class Singleton {
	const char *name;
	std::atomic<Wrapped *> found{ nullptr };
	Singleton *next = nullptr;

	Wrapped *find();

public:
	constexpr explicit Singleton(const char *p_name) : name(p_name) {}
	Wrapped *get() {
		Wrapped *wrapped = found.load(std::memory_order_acquire);
		return likely(wrapped) ? wrapped : find();
	}
	static void forget(const Wrapped *p_wrapped);
};

// Calls with pointers to the arguments and to the result.
template <typename R, typename F, typename... Held> inline R with_pointers(F p_call, const Held &...p_held) {
	const GDExtensionConstTypePtr arguments[sizeof...(Held) + 1] = { p_held.ptr()..., nullptr };
	if constexpr (std::is_void_v<R>) {
		p_call(arguments, nullptr);
	} else if constexpr (TypeTraits<R>::is_direct) {
		R result{};
		p_call(arguments, &result);
		return result;
	} else {
		typename TypeTraits<R>::Result result;
		p_call(arguments, result.ptr());
		return result.take();
	}
}

template <typename R, typename... A>
inline R call_engine(EngineMethod &p_method, void *p_owner, const A &...p_arguments) {
	const GDExtensionMethodBindPtr bind = p_method.get();
	if (unlikely(!bind)) {
		return R();
	}
	return with_pointers<R>(
			[&](const GDExtensionConstTypePtr *p_pointers, void *r_result) {
				gde.object_method_bind_ptrcall(bind, p_owner, p_pointers, r_result);
			},
			typename TypeTraits<A>::Argument(p_arguments)...);
}

template <typename R, typename... A>
inline R call_builtin(BuiltinMethod &p_method, void *p_base, const A &...p_arguments) {
	const GDExtensionPtrBuiltInMethod function = p_method.get();
	if (unlikely(!function)) {
		return R();
	}
	return with_pointers<R>([&](const GDExtensionConstTypePtr *p_pointers,
									void *r_result) { function(p_base, p_pointers, r_result, int32_t(sizeof...(A))); },
			typename TypeTraits<A>::Argument(p_arguments)...);
}

template <typename R, typename... A> inline R call_utility(UtilityFunction &p_function, const A &...p_arguments) {
	const GDExtensionPtrUtilityFunction function = p_function.get();
	if (unlikely(!function)) {
		return R();
	}
	return with_pointers<R>([&](const GDExtensionConstTypePtr *p_pointers,
									void *r_result) { function(r_result, p_pointers, int32_t(sizeof...(A))); },
			typename TypeTraits<A>::Argument(p_arguments)...);
}

// Pointers to consecutive values.
class ValuePointers {
	static constexpr int64_t few = 12;
	const void *small[few];
	const void **all = small;

public:
	ValuePointers(const Variant *p_values, int64_t p_count) {
		if (p_count > few) {
			all = new const void *[size_t(p_count)];
		}
		for (int64_t i = 0; i < p_count; i++) {
			all[i] = p_values + i;
		}
	}
	~ValuePointers() {
		if (all != small) {
			delete[] all;
		}
	}
	ValuePointers(const ValuePointers &) = delete;
	ValuePointers &operator=(const ValuePointers &) = delete;
	const void **get() { return all; }
};

Variant call_with_values(EngineMethod &p_method, void *p_owner, const Variant *p_values, int64_t p_count);

// The same for functions with any number of values.
template <typename R>
inline R call_engine_array(EngineMethod &p_method, void *p_owner, const Variant *p_values, int64_t p_count) {
	const Variant result = call_with_values(p_method, p_owner, p_values, p_count);
	if constexpr (!std::is_void_v<R>) {
		return TypeTraits<R>::from_variant(result);
	}
}

template <typename R>
inline R call_builtin_array(BuiltinMethod &p_method, void *p_base, const Variant *p_values, int64_t p_count) {
	ValuePointers pointers(p_values, p_count);
	return with_pointers<R>([&](const GDExtensionConstTypePtr *, void *r_result) {
		p_method.get()(p_base, pointers.get(), r_result, int32_t(p_count));
	});
}

template <typename R>
inline R call_utility_array(UtilityFunction &p_function, const Variant *p_values, int64_t p_count) {
	ValuePointers pointers(p_values, p_count);
	return with_pointers<R>([&](const GDExtensionConstTypePtr *, void *r_result) {
		p_function.get()(r_result, pointers.get(), int32_t(p_count));
	});
}

template <typename R> inline R call_operator(Operator &p_operator, const void *p_left, const void *p_right) {
	return with_pointers<R>(
			[&](const GDExtensionConstTypePtr *, void *r_result) { p_operator.get()(p_left, p_right, r_result); });
}

template <typename... A>
inline void construct(GDExtensionVariantType p_type, int p_index, void *r_base, const A &...p_arguments) {
	const GDExtensionPtrConstructor constructor = gde.variant_get_ptr_constructor(p_type, p_index);
	with_pointers<void>([&](const GDExtensionConstTypePtr *p_pointers, void *) { constructor(r_base, p_pointers); },
			typename TypeTraits<A>::Argument(p_arguments)...);
}

} // namespace godot::internal

// Constructors, copies and destructor of a built-in type with a layout that only the engine has.
#define GODOT_OPAQUE_TYPE(m_type, m_id)                                                                                \
	m_type::m_type() {                                                                                                 \
		internal::type_functions[m_id].create(this, nullptr);                                                          \
	}                                                                                                                  \
	m_type::m_type(const m_type &p_from) {                                                                             \
		const GDExtensionConstTypePtr arguments[] = { &p_from };                                                       \
		internal::type_functions[m_id].copy(this, arguments);                                                          \
	}                                                                                                                  \
	m_type::m_type(m_type &&p_from) : m_type() {                                                                       \
		std::swap(_opaque, p_from._opaque);                                                                            \
	}                                                                                                                  \
	m_type::~m_type() {                                                                                                \
		internal::type_functions[m_id].destroy(this);                                                                  \
	}                                                                                                                  \
	m_type &m_type::operator=(const m_type &p_from) {                                                                  \
		if (this != &p_from) {                                                                                         \
			m_type copy(p_from);                                                                                       \
			std::swap(_opaque, copy._opaque);                                                                          \
		}                                                                                                              \
		return *this;                                                                                                  \
	}                                                                                                                  \
	m_type &m_type::operator=(m_type &&p_from) {                                                                       \
		std::swap(_opaque, p_from._opaque);                                                                            \
		return *this;                                                                                                  \
	}
