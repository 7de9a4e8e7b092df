#pragma once

#include <gdextension_interface.h>

#include <atomic>

#include <godot_cpp/core/defs.hpp>

#include <godot_cpp/generated/interface_aliases.inc>

namespace godot {

class StringName;

namespace internal {

// The engine's C functions. Filled once, before all other code of the binding runs.
struct Interface {
#define GODOT_INTERFACE_FUNCTION(m_type, m_name) m_type m_name = nullptr;
#include <godot_cpp/generated/interface_functions.inc>
#undef GODOT_INTERFACE_FUNCTION
};

// Functions that create, copy and destroy one built-in type and convert it to and from a Variant.
struct TypeFunctions {
	GDExtensionPtrConstructor create = nullptr;
	GDExtensionPtrConstructor copy = nullptr;
	GDExtensionPtrDestructor destroy = nullptr;
	GDExtensionVariantFromTypeConstructorFunc to_variant = nullptr;
	GDExtensionTypeFromVariantConstructorFunc from_variant = nullptr;
};

extern Interface gde;
extern GDExtensionClassLibraryPtr library;
extern TypeFunctions type_functions[GDEXTENSION_VARIANT_TYPE_VARIANT_MAX];

// Returns false, with an error for each, if the engine does not have one of the functions.
bool load_interface(GDExtensionInterfaceGetProcAddress p_get);

// A name in static storage, created at its first use and released when the library is unloaded.
class StaticName {
	const char *text;
	std::atomic<bool> ready{ false };
	alignas(8) uint8_t storage[8] = {};
	StaticName *next = nullptr;

	void create();

public:
	constexpr explicit StaticName(const char *p_text) : text(p_text) {}
	const StringName &get() {
		if (unlikely(!ready.load(std::memory_order_acquire))) {
			create();
		}
		return *reinterpret_cast<const StringName *>(storage);
	}
	static void release_all();
};

} // namespace internal

} // namespace godot
