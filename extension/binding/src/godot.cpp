#include <godot_cpp/godot.hpp>

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/engine_calls.hpp>

namespace godot {

namespace {

struct Library {
	GDExtensionBinding::Callback initialize = nullptr;
	GDExtensionBinding::Callback terminate = nullptr;
	GDExtensionInitializationLevel minimum_level = GDEXTENSION_INITIALIZATION_SCENE;
	int depth = 0; // number of initialized levels
};
Library state;

void initialize_level(void *, GDExtensionInitializationLevel p_level) {
	state.depth++;
	ClassDB::initialize(p_level);
	if (state.initialize) {
		state.initialize(ModuleInitializationLevel(p_level));
	}
}

// After the last level, the engine must not contain any name, Variant or wrapper of the library.
void deinitialize_level(void *, GDExtensionInitializationLevel p_level) {
	if (state.terminate) {
		state.terminate(ModuleInitializationLevel(p_level));
	}
	ClassDB::deinitialize(p_level);
	if (--state.depth == 0) {
		internal::release_wrappers();
		internal::StaticName::release_all();
	}
}

} // namespace

GDExtensionBinding::InitObject::InitObject(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) :
		get_proc_address(p_get_proc_address), library(p_library), initialization(r_initialization) {}

void GDExtensionBinding::InitObject::register_initializer(Callback p_initialize) const {
	state.initialize = p_initialize;
}

void GDExtensionBinding::InitObject::register_terminator(Callback p_terminate) const {
	state.terminate = p_terminate;
}

void GDExtensionBinding::InitObject::set_minimum_library_initialization_level(ModuleInitializationLevel p_level) const {
	state.minimum_level = GDExtensionInitializationLevel(p_level);
}

GDExtensionBool GDExtensionBinding::InitObject::init() const {
	internal::library = library;
	if (!internal::load_interface(get_proc_address)) {
		return false;
	}
	*initialization = { state.minimum_level, nullptr, initialize_level, deinitialize_level };
	return true;
}

} // namespace godot
