#include "base/auto_name.hpp"

#include <godot_cpp/classes/script.hpp>

using namespace godot;

namespace undergrowth {

void update_auto_name(Resource *resource, String &given, const String &name) {
	const String current = resource->get_name();
	if ((!current.is_empty() && current != given) || name == given) {
		return;
	}
	given = name;
	const bool was_silent = resource->is_blocking_signals();
	resource->set_block_signals(true);
	resource->set_name(name);
	resource->set_block_signals(was_silent);
}

void hide_auto_name(const Resource *resource, const String &given, PropertyInfo &property) {
	if (property.name == StringName("resource_name") && resource->get_name() == given) {
		property.usage &= ~uint32_t(PROPERTY_USAGE_STORAGE);
	}
}

static String file_name(const Resource *resource) {
	const String path = resource->get_path();
	return path.contains("::") ? String() : path.get_file().get_basename();
}

String name_of_species(const Ref<PlantFunction> &species) {
	if (species.is_null()) {
		return String();
	}
	String name = species->get_name();
	if (!name.is_empty()) {
		return name;
	}
	name = file_name(species.ptr());
	const Ref<Script> script = species->get_script();
	if (name.is_empty() && script.is_valid()) {
		name = file_name(script.ptr());
	}
	return (name.is_empty() ? species->get_class().trim_suffix("Function") : name).capitalize();
}

} // namespace undergrowth
