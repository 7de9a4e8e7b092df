#pragma once

#include <cstddef>

#include <godot_cpp/classes/wrapped.hpp>
#include <godot_cpp/core/memory.hpp>

namespace godot {

class RefCounted;

namespace internal {

// Take the first reference to a new object, or one more. Both return false if the object is being freed.
bool ref_first(void *p_wrapped);
bool ref_more(void *p_wrapped);
// Releases a reference and frees the object with the last one.
void ref_release(void *p_wrapped);

} // namespace internal

// A counted reference to an object of a class derived from RefCounted.
template <typename T> class Ref {
	T *reference = nullptr;

	template <typename U> friend class Ref;

	static void *_bytes(const T *p_object) { return const_cast<void *>(static_cast<const void *>(p_object)); }
	void _share(T *p_object) {
		if (p_object == reference) {
			return;
		}
		T *before = reference;
		reference = p_object && internal::ref_more(_bytes(p_object)) ? p_object : nullptr;
		if (before) {
			internal::ref_release(_bytes(before));
		}
	}

public:
	constexpr Ref() = default;
	constexpr Ref(std::nullptr_t) {}
	Ref(T *p_object) {
		if (p_object && internal::ref_first(_bytes(p_object))) {
			reference = p_object;
		}
	}
	Ref(const Ref &p_from) { _share(p_from.reference); }
	Ref(Ref &&p_from) : reference(p_from.reference) { p_from.reference = nullptr; }
	// Null if the object is of another class.
	template <typename U> Ref(const Ref<U> &p_from) { _share(dynamic_cast<T *>(p_from.reference)); }
	Ref(const Variant &p_from) : Ref(internal::cast<T>(internal::wrapped_in(p_from))) {}
	~Ref() { unref(); }

	// Uses a reference that was already counted for the caller.
	static Ref adopt(T *p_object) {
		Ref ref;
		ref.reference = p_object;
		return ref;
	}

	Ref &operator=(const Ref &p_from) {
		_share(p_from.reference);
		return *this;
	}
	Ref &operator=(Ref &&p_from) {
		if (this != &p_from) {
			unref();
			reference = p_from.reference;
			p_from.reference = nullptr;
		}
		return *this;
	}
	template <typename U> Ref &operator=(const Ref<U> &p_from) {
		_share(dynamic_cast<T *>(p_from.reference));
		return *this;
	}
	Ref &operator=(const Variant &p_from) { return *this = Ref(p_from); }

	template <typename... Args> void instantiate(Args &&...p_args) {
		*this = Ref(memnew(T(std::forward<Args>(p_args)...)));
	}
	void unref() {
		if (reference) {
			T *before = reference;
			reference = nullptr;
			internal::ref_release(_bytes(before));
		}
	}

	T *ptr() const { return reference; }
	T *operator->() const { return reference; }
	T *operator*() const { return reference; }
	bool is_valid() const { return reference != nullptr; }
	bool is_null() const { return reference == nullptr; }
	bool operator==(const T *p_object) const { return reference == p_object; }
	bool operator!=(const T *p_object) const { return reference != p_object; }
	bool operator==(const Ref &p_other) const { return reference == p_other.reference; }
	bool operator!=(const Ref &p_other) const { return reference != p_other.reference; }
	bool operator<(const Ref &p_other) const { return reference < p_other.reference; }
};

} // namespace godot
