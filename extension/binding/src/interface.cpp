#include <godot_cpp/core/interface.hpp>

#include <cstdio>
#include <mutex>

#include <godot_cpp/variant/builtin_types.hpp>
#include <godot_cpp/variant/variant.hpp>

namespace godot::internal {

Interface gde;
GDExtensionClassLibraryPtr library = nullptr;
TypeFunctions type_functions[GDEXTENSION_VARIANT_TYPE_VARIANT_MAX];

namespace {

#define GODOT_BUILTIN_SIZE(m_type, m_size)                                                                             \
	static_assert(sizeof(m_type) == m_size, "the engine's size of " #m_type " differs");
#include <godot_cpp/generated/builtin_sizes.inc>
#undef GODOT_BUILTIN_SIZE

void load_types() {
	for (int i = GDEXTENSION_VARIANT_TYPE_BOOL; i < GDEXTENSION_VARIANT_TYPE_VARIANT_MAX; i++) {
		const GDExtensionVariantType type = GDExtensionVariantType(i);
		TypeFunctions &functions = type_functions[i];
		functions.to_variant = gde.get_variant_from_type_constructor(type);
		functions.from_variant = gde.get_variant_to_type_constructor(type);
		if (type != GDEXTENSION_VARIANT_TYPE_OBJECT) {
			functions.create = gde.variant_get_ptr_constructor(type, 0);
			functions.copy = gde.variant_get_ptr_constructor(type, 1);
			functions.destroy = gde.variant_get_ptr_destructor(type);
		}
	}
}

// Names in static storage, to be released at unload. The mutex guards the list.
std::mutex names_mutex;
StaticName *first_name = nullptr;

} // namespace

bool load_interface(GDExtensionInterfaceGetProcAddress p_get) {
	int missing = 0;
#define GODOT_INTERFACE_FUNCTION(m_type, m_name)                                                                       \
	gde.m_name = reinterpret_cast<m_type>(reinterpret_cast<void *>(p_get(#m_name)));                                   \
	if (!gde.m_name) {                                                                                                 \
		missing++;                                                                                                     \
		std::fprintf(stderr, "ERROR: this Godot has no interface function %s; a newer one is needed.\n", #m_name);     \
	}
#include <godot_cpp/generated/interface_functions.inc>
#undef GODOT_INTERFACE_FUNCTION
	if (missing == 0) {
		load_types();
	}
	return missing == 0;
}

void StaticName::create() {
	const std::lock_guard<std::mutex> lock(names_mutex);
	if (!ready.load(std::memory_order_relaxed)) {
		gde.string_name_new_with_utf8_chars(storage, text);
		next = first_name;
		first_name = this;
		ready.store(true, std::memory_order_release);
	}
}

void StaticName::release_all() {
	const std::lock_guard<std::mutex> lock(names_mutex);
	while (first_name) {
		StaticName *name = first_name;
		first_name = name->next;
		name->ready.store(false, std::memory_order_release);
		type_functions[GDEXTENSION_VARIANT_TYPE_STRING_NAME].destroy(name->storage);
	}
}

} // namespace godot::internal
