#pragma once

#include <type_traits>
#include <utility>

#include <godot_cpp/classes/wrapped.hpp>

namespace godot {

namespace internal {

// Connects a new C++ object with its engine object and sends the notification that it is complete.
void join(Wrapped *p_wrapped, const StringName *p_extension_class);
void bind_own(Wrapped *p_wrapped);
void announce(Wrapped *p_wrapped);
void destroy(Wrapped *p_wrapped);

// A construction by memnew, from before the constructor until after it. It has no effect for a plain type.
template <typename T, bool IsWrapped = std::is_base_of_v<Wrapped, T>> struct Making {
	T *finish(T *p_made) { return p_made; }
};

template <typename T> struct Making<T, true> : Construction {
	Making() : Construction(&T::native_type::get_class_static(), nullptr) {}
	T *finish(T *p_made) {
		constexpr bool is_native = std::is_same_v<typename T::self_type, typename T::native_type>;
		join(p_made, is_native ? nullptr : &T::self_type::get_class_static());
		announce(p_made);
		return p_made;
	}
};

} // namespace internal

template <typename T> void memdelete(T *p_object) {
	if constexpr (std::is_base_of_v<Wrapped, T>) {
		internal::destroy(p_object);
	} else {
		delete p_object;
	}
}

} // namespace godot

// memnew(Node3D), memnew(Thing(argument)): creates the C++ object together with its engine object.
#define memnew(m_class)                                                                                                \
	(::godot::internal::Making<std::remove_reference_t<decltype(*new m_class)>>().finish(new m_class))
#define memdelete_notnull(m_object)                                                                                    \
	{                                                                                                                  \
		if (m_object) {                                                                                                \
			::godot::memdelete(m_object);                                                                              \
		}                                                                                                              \
	}
