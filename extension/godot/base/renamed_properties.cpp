#include "base/renamed_properties.hpp"

#include "base/messages.hpp"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

#include <set>
#include <string>

using namespace godot;

namespace undergrowth {

bool set_renamed_property(Object *object, const StringName &old_name, const Variant &value,
		std::initializer_list<RenamedProperty> renamed) {
	const String wanted = old_name;
	for (const RenamedProperty &property : renamed) {
		if (wanted == property.old_name) {
			object->set(property.name, value);
			OldNameWarning::post(object, property);
			return true;
		}
	}
	return false;
}

void OldNameWarning::post(const Object *object, const RenamedProperty &property) {
	OldNameWarning *warning = memnew(OldNameWarning);
	warning->object_id = uint64_t(object->get_instance_id());
	warning->property = property;
	warning->call_deferred("_warn");
	warning->call_deferred("free");
}

// Returns the file that contains the object: the resource's own, or that of the scene of a node.
static String find_file(Object *object) {
	if (const Resource *resource = Object::cast_to<Resource>(object)) {
		return resource->get_path().get_slice("::", 0);
	}
	const Node *node = Object::cast_to<Node>(object);
	const Node *owner = node ? node->get_owner() : nullptr;
	const Node *root = owner ? owner : node;
	return root ? root->get_scene_file_path() : String();
}

void OldNameWarning::warn() const {
	static std::set<std::string> warned_files; // One warning per file and process.
	Object *object = ObjectDB::get_instance(object_id);
	const String file = object ? find_file(object) : String();
	if (!object || !warned_files.insert(file.utf8().get_data()).second) {
		return;
	}
	String place = file.is_empty() ? describe(object) : "'" + file + "'";
	UtilityFunctions::push_warning(place + " uses property names of Undergrowth 0.2: '" + property.old_name +
			"' is called '" + property.name +
			"' now. Save it once in the editor to update it; the next release does not read the old names.");
}

void OldNameWarning::_bind_methods() {
	ClassDB::bind_method(D_METHOD("_warn"), &OldNameWarning::warn);
}

} // namespace undergrowth
