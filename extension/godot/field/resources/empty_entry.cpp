#include "field/resources/empty_entry.hpp"

#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

using namespace godot;

namespace undergrowth {

// Returns the missing dependencies of a file. A dependency is "uid::type::path", or only a path.
static PackedStringArray missing_files_of(const String &file) {
	PackedStringArray missing;
	ResourceLoader *loader = ResourceLoader::get_singleton();
	if (file.is_empty() || !loader->exists(file)) {
		return missing;
	}
	const PackedStringArray used = loader->get_dependencies(file);
	for (const String &one : used) {
		const String path = one.contains("::") ? one.get_slice("::", one.get_slice_count("::") - 1) : one;
		const String uid = one.get_slice("::", 0);
		const bool is_there = loader->exists(path) || (uid.begins_with("uid://") && loader->exists(uid));
		if (!is_there) {
			missing.push_back(path);
		}
	}
	return missing;
}

// The file that contains the entry: its own, else the field's scene.
static String file_of(const Node *field, const Ref<PlantFieldSpecies> &entry) {
	const String own = entry.is_valid() ? entry->get_path().get_slice("::", 0) : String();
	if (!own.is_empty()) {
		return own;
	}
	const Node *owner = field->get_owner();
	return field->get_scene_file_path().is_empty() && owner ? owner->get_scene_file_path()
															: field->get_scene_file_path();
}

String describe_empty_entry(const Node *field, int number, const Ref<PlantFieldSpecies> &entry) {
	const String file = field ? file_of(field, entry) : String();
	const PackedStringArray missing = missing_files_of(file);
	String which = "species[" + String::num_int64(number) + "]";
	if (!missing.is_empty()) {
		return which + " is empty and grows no plants: '" + String("', '").join(missing) + "', which '" + file +
				"' uses, is missing. Restore the file, set another species, or remove the entry.";
	}
	return which + " is empty and grows no plants. Set a PlantFieldSpecies with a PlantFunction, or remove the entry.";
}

} // namespace undergrowth
