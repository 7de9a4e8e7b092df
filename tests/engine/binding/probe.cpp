#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/godot.hpp>

#include "probe_checks.hpp"
#include "probe_counter.hpp"
#include "probe_node.hpp"
#include "probe_resource.hpp"

// A library for tests only: one class per feature of the binding. The same sources are built with godot-cpp.

using namespace godot;

namespace probe {

class ProbeServer : public Object {
	GDCLASS(ProbeServer, Object)

protected:
	static void _bind_methods() { ClassDB::bind_method(D_METHOD("answer"), &ProbeServer::answer); }

public:
	int answer() const { return 42; }
};

class ProbeRuntime : public Node {
	GDCLASS(ProbeRuntime, Node)

protected:
	static void _bind_methods() { ClassDB::bind_method(D_METHOD("is_real"), &ProbeRuntime::is_real); }

public:
	bool is_real() const { return true; }
};

class ProbeAbstract : public RefCounted {
	GDCLASS(ProbeAbstract, RefCounted)

protected:
	static void _bind_methods() {}

public:
	virtual int value() const = 0;
};

class ProbeInternal : public RefCounted {
	GDCLASS(ProbeInternal, RefCounted)

protected:
	static void _bind_methods() {}
};

ProbeServer *server = nullptr;

void initialize(ModuleInitializationLevel p_level) {
	if (p_level != MODULE_INITIALIZATION_LEVEL_SCENE) {
		return;
	}
	GDREGISTER_CLASS(ProbeResource);
	GDREGISTER_CLASS(ProbeNode);
	GDREGISTER_CLASS(ProbeDerived);
	GDREGISTER_CLASS(ProbeCounter);
	GDREGISTER_CLASS(ProbeChecks);
	GDREGISTER_CLASS(ProbeServer);
	GDREGISTER_RUNTIME_CLASS(ProbeRuntime);
	GDREGISTER_ABSTRACT_CLASS(ProbeAbstract);
	GDREGISTER_INTERNAL_CLASS(ProbeInternal);
	server = memnew(ProbeServer);
	Engine::get_singleton()->register_singleton("ProbeServer", server);
}

void terminate(ModuleInitializationLevel p_level) {
	if (p_level != MODULE_INITIALIZATION_LEVEL_SCENE) {
		return;
	}
	Engine::get_singleton()->unregister_singleton("ProbeServer");
	memdelete(server);
	server = nullptr;
}

} // namespace probe

extern "C" GDExtensionBool GDE_EXPORT probe_init(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) {
	const GDExtensionBinding::InitObject init(p_get_proc_address, p_library, r_initialization);
	init.register_initializer(probe::initialize);
	init.register_terminator(probe::terminate);
	init.set_minimum_library_initialization_level(MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
