#pragma once

#include <godot_cpp/core/interface.hpp>

namespace godot {

enum ModuleInitializationLevel {
	MODULE_INITIALIZATION_LEVEL_CORE = GDEXTENSION_INITIALIZATION_CORE,
	MODULE_INITIALIZATION_LEVEL_SERVERS = GDEXTENSION_INITIALIZATION_SERVERS,
	MODULE_INITIALIZATION_LEVEL_SCENE = GDEXTENSION_INITIALIZATION_SCENE,
	MODULE_INITIALIZATION_LEVEL_EDITOR = GDEXTENSION_INITIALIZATION_EDITOR,
	MODULE_INITIALIZATION_LEVEL_MAX
};

// Initializes and deinitializes the library.
class GDExtensionBinding {
public:
	using Callback = void (*)(ModuleInitializationLevel p_level);

	// For the entry function of the library: register the two callbacks, then return init().
	class InitObject {
		GDExtensionInterfaceGetProcAddress get_proc_address;
		GDExtensionClassLibraryPtr library;
		GDExtensionInitialization *initialization;

	public:
		InitObject(GDExtensionInterfaceGetProcAddress p_get_proc_address, GDExtensionClassLibraryPtr p_library,
				GDExtensionInitialization *r_initialization);

		void register_initializer(Callback p_initialize) const;
		void register_terminator(Callback p_terminate) const;
		void set_minimum_library_initialization_level(ModuleInitializationLevel p_level) const;
		// Returns false if the engine does not have something that the binding requires.
		GDExtensionBool init() const;
	};
};

} // namespace godot
