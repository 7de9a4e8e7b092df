#pragma once

#include <cstring>

#include <godot_cpp/core/bound_method.hpp>
#include <godot_cpp/core/object.hpp>

namespace godot {

namespace internal {

// Returns a Callable of a C++ function. Callables of the same object and function are equal, so that it can be
// disconnected.
Callable make_callable(Object *p_object, std::unique_ptr<BoundMethod> p_method, const void *p_function, size_t p_size);

} // namespace internal

template <typename C, typename M> Callable create_callable(C *p_object, M p_method) {
	return internal::make_callable(
			p_object, std::make_unique<internal::MemberMethod<M>>(p_method), &p_method, sizeof(M));
}
template <typename M> Callable create_static_callable(M p_function) {
	return internal::make_callable(
			nullptr, std::make_unique<internal::StaticMethod<M>>(p_function), &p_function, sizeof(M));
}

} // namespace godot

#define callable_mp(m_object, m_method) ::godot::create_callable(m_object, m_method)
#define callable_mp_static(m_function) ::godot::create_static_callable(m_function)
