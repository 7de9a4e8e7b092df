#include <godot_cpp/core/class_db.hpp>

#include <algorithm>

#include "c_info.hpp"

namespace godot {

using internal::BoundMethod;
using internal::ClassRecord;
using internal::gde;
using internal::library;

namespace {

// In the order of registration. Created when the library is initialized, emptied when it is unloaded.
std::vector<std::unique_ptr<ClassRecord>> records;
int current_level = 0;

} // namespace

ClassRecord *ClassDB::current_record(const StringName &p_class) {
	const auto found = std::find_if(
			records.begin(), records.end(), [&](const auto &p_record) { return p_record->class_name == p_class; });
	return found == records.end() ? nullptr : found->get();
}

void ClassDB::add_class(std::unique_ptr<ClassRecord> p_record) {
	ERR_FAIL_COND_MSG(
			current_record(p_record->class_name), vformat("The class %s is registered twice.", p_record->class_name));
	p_record->parent = current_record(p_record->parent_name);
	p_record->level = current_level;
	records.push_back(std::move(p_record));
	records.back()->register_class();
}

void ClassDB::add_method(const StringName &p_class, std::unique_ptr<BoundMethod> p_method,
		const MethodDefinition &p_definition, std::vector<Variant> p_defaults) {
	ClassRecord *record = current_record(p_class);
	ERR_FAIL_NULL_MSG(
			record, vformat("%s is bound in a class that is not registered: %s.", p_definition.name, p_class));
	p_method->name = p_definition.name;
	p_method->defaults = std::move(p_defaults);
	for (size_t i = 0; i < p_method->arguments.size(); i++) {
		p_method->arguments[i].name =
				i < p_definition.args.size() ? p_definition.args[i] : StringName(vformat("arg%d", int64_t(i)));
	}
	p_method->register_in(p_class);
	record->methods.push_back(std::move(p_method));
}

void ClassDB::add_virtual_method(
		const StringName &p_class, const MethodInfo &p_method, const std::vector<StringName> &p_names) {
	std::vector<PropertyInfo> arguments = p_method.arguments;
	for (size_t i = 0; i < arguments.size() && i < p_names.size(); i++) {
		arguments[i].name = p_names[i];
	}
	std::vector<GDExtensionPropertyInfo> c_arguments = internal::c_infos(arguments);
	std::vector<GDExtensionClassMethodArgumentMetadata> metadata = p_method.arguments_metadata;
	metadata.resize(arguments.size());
	const GDExtensionClassVirtualMethodInfo info = { const_cast<StringName *>(&p_method.name), p_method.flags,
		p_method.return_val.c_info(), p_method.return_val_metadata, uint32_t(arguments.size()), c_arguments.data(),
		metadata.data() };
	gde.classdb_register_extension_class_virtual_method(library, &p_class, &info);
}

void ClassDB::add_property(const StringName &p_class, const PropertyInfo &p_info, const StringName &p_setter,
		const StringName &p_getter, int p_index) {
	const GDExtensionPropertyInfo info = p_info.c_info();
	gde.classdb_register_extension_class_property_indexed(library, &p_class, &info, &p_setter, &p_getter, p_index);
}

void ClassDB::add_property_group(const StringName &p_class, const String &p_name, const String &p_prefix) {
	gde.classdb_register_extension_class_property_group(library, &p_class, &p_name, &p_prefix);
}

void ClassDB::add_property_subgroup(const StringName &p_class, const String &p_name, const String &p_prefix) {
	gde.classdb_register_extension_class_property_subgroup(library, &p_class, &p_name, &p_prefix);
}

void ClassDB::add_signal(const StringName &p_class, const MethodInfo &p_signal) {
	const std::vector<GDExtensionPropertyInfo> arguments = internal::c_infos(p_signal.arguments);
	gde.classdb_register_extension_class_signal(
			library, &p_class, &p_signal.name, arguments.data(), int64_t(arguments.size()));
}

void ClassDB::bind_integer_constant(const StringName &p_class, const StringName &p_enum, const StringName &p_name,
		int64_t p_value, bool p_is_bit_field) {
	gde.classdb_register_extension_class_integer_constant(library, &p_class, &p_enum, &p_name, p_value, p_is_bit_field);
}

void ClassDB::initialize(GDExtensionInitializationLevel p_level) {
	current_level = p_level;
}

void ClassDB::deinitialize(GDExtensionInitializationLevel p_level) {
	while (!records.empty() && records.back()->level == int(p_level)) {
		gde.classdb_unregister_extension_class(library, &records.back()->class_name);
		records.pop_back();
	}
	current_level = int(p_level) - 1;
}

namespace internal {

namespace {

// Returns the last two parts: "undergrowth::Plant::Law" -> { "Plant", "Law" }.
std::pair<std::string, std::string> last_parts(const std::string &p_name) {
	const size_t last = p_name.rfind("::");
	if (last == std::string::npos) {
		return { "", p_name };
	}
	const size_t before = last == 0 ? std::string::npos : p_name.rfind("::", last - 1);
	const size_t start = before == std::string::npos ? 0 : before + 2;
	return { p_name.substr(start, last - start), p_name.substr(last + 2) };
}

} // namespace

StringName enum_class_name(const char *p_cpp_name) {
	const auto [owner, name] = last_parts(p_cpp_name);
	return StringName((owner.empty() ? name : owner + "." + name).c_str());
}

StringName enum_name(const char *p_cpp_name) {
	return StringName(last_parts(p_cpp_name).second.c_str());
}

} // namespace internal

} // namespace godot
