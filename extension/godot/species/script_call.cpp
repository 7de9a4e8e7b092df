#include "species/script_call.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/script.hpp>

using namespace godot;

namespace undergrowth {

Variant call_script_override(
		Resource *resource, const StringName &method, const Array &arguments, Variant::Type wanted, String &problem) {
	const Ref<Script> script = resource->get_script();
	if (script.is_valid() && Engine::get_singleton()->is_editor_hint() && !script->is_tool()) {
		problem = "its script cannot run in the editor. Begin the script with @tool.";
		return Variant();
	}
	const Variant result = resource->callv(method, arguments);
	const bool number_fits = wanted == Variant::FLOAT && result.get_type() == Variant::INT;
	if (wanted == Variant::NIL || result.get_type() == wanted || number_fits) {
		return result;
	}
	const String got =
			result.get_type() == Variant::NIL ? String("nothing") : Variant::get_type_name(result.get_type());
	problem =
			String(method) + "() of its script returned " + got + ". Return a " + Variant::get_type_name(wanted) + ".";
	return Variant();
}

} // namespace undergrowth
