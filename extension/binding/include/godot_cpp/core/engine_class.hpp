#pragma once

#include <unordered_map>
#include <vector>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/core/signature.hpp>

// Used by the generated engine classes.

namespace godot::internal {

// The function by which the engine calls one of its virtual methods, overridden in a class of the library.
using VirtualCall = void (*)(Wrapped *p_self, const GDExtensionConstTypePtr *p_arguments, void *r_result);

struct VirtualOverride {
	uint32_t hash;
	VirtualCall call;
};

// The engine's virtual methods that one class of the library overrides, itself or in a base class of the library.
class VirtualTable {
	std::unordered_map<const void *, VirtualOverride> overrides;
	std::vector<StringName> names; // their identities are keys, so they must exist

	void add(const char *p_name, uint32_t p_hash, VirtualCall p_call);

public:
	template <typename T, auto Method> void bind(const char *p_name, uint32_t p_hash) {
		add(p_name, p_hash, [](Wrapped *p_self, const GDExtensionConstTypePtr *p_arguments, void *r_result) {
			FunctionType<decltype(Method)>::Parts::call_pointers(
					[p_self](auto &&...p_values) -> decltype(auto) {
						return (static_cast<T *>(p_self)->*Method)(std::forward<decltype(p_values)>(p_values)...);
					},
					p_arguments, r_result);
		});
	}
	// Returns null if the method is not overridden. If this engine declares it differently, prints an error, too.
	const VirtualOverride *find(const StringName &p_name, uint32_t p_hash) const;
};

struct EngineClass {
	const char *name;
	Wrapped *(*wrap)(void *p_owner);
};
// All generated classes, sorted by name.
extern const EngineClass engine_classes[];
extern const int engine_class_count;

template <typename T> Wrapped *create_wrapper(void *p_owner) {
	Construction construction(nullptr, p_owner);
	return new T;
}

} // namespace godot::internal

#define GODOT_ENGINE_CLASS(m_class, m_base, m_engine_name)                                                             \
public:                                                                                                                \
	using self_type = m_class;                                                                                         \
	using native_type = m_class;                                                                                       \
	static const StringName &get_class_static() {                                                                      \
		static internal::StaticName name(m_engine_name);                                                               \
		return name.get();                                                                                             \
	}                                                                                                                  \
                                                                                                                       \
private:

// A virtual method is overridden if the name has another declaration than that of the engine class.
#define GODOT_ENGINE_VIRTUAL(m_class, m_name, m_hash)                                                                  \
	if constexpr (!std::is_same_v<decltype(&T::m_name), decltype(&m_class::m_name)>) {                                 \
		r_table.bind<T, &T::m_name>(#m_name, m_hash);                                                                  \
	}
