#include <godot_cpp/core/class_record.hpp>

#include <cstdlib>

#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/core/object.hpp>

#include "c_info.hpp"

// The engine calls these functions for an object of a library class. It passes only the class of the object, so these
// functions also call those of its base classes.

namespace godot::internal {

namespace {

const ClassRecord &record_of(const Wrapped *p_self) {
	return *p_self->_get_class_record();
}

Wrapped *wrapped(void *p_instance) {
	return static_cast<Wrapped *>(p_instance);
}

const StringName &name_at(GDExtensionConstStringNamePtr p_name) {
	return *static_cast<const StringName *>(p_name);
}

void *create(void *p_record, GDExtensionBool p_announce) {
	const ClassRecord *record = static_cast<const ClassRecord *>(p_record);
	Construction construction(&record->native_name, nullptr);
	Wrapped *made = record->construct();
	join(made, &record->class_name);
	if (p_announce) {
		announce(made);
	}
	return made->_owner;
}

// After a reload: creates a new C++ object for an existing engine object.
void *recreate(void *p_record, void *p_owner) {
	const ClassRecord *record = static_cast<const ClassRecord *>(p_record);
	Construction construction(&record->native_name, p_owner);
	Wrapped *made = record->construct();
	bind_own(made);
	return made;
}

void free_instance(void *, void *p_instance) {
	delete wrapped(p_instance);
}

void notify_forward(const ClassRecord *p_record, Wrapped *p_self, int p_what) {
	if (p_record->parent) {
		notify_forward(p_record->parent, p_self, p_what);
	}
	if (p_record->notification) {
		p_record->notification(p_self, p_what);
	}
}

void notify(void *p_instance, int32_t p_what, GDExtensionBool p_reversed) {
	const ClassRecord *record = &record_of(wrapped(p_instance));
	if (!p_reversed) {
		notify_forward(record, wrapped(p_instance), p_what);
		return;
	}
	for (; record; record = record->parent) {
		if (record->notification) {
			record->notification(wrapped(p_instance), p_what);
		}
	}
}

GDExtensionBool set(void *p_instance, GDExtensionConstStringNamePtr p_name, GDExtensionConstVariantPtr p_value) {
	for (const ClassRecord *r = &record_of(wrapped(p_instance)); r; r = r->parent) {
		if (r->set && r->set(wrapped(p_instance), name_at(p_name), *static_cast<const Variant *>(p_value))) {
			return true;
		}
	}
	return false;
}

GDExtensionBool get(void *p_instance, GDExtensionConstStringNamePtr p_name, GDExtensionVariantPtr r_value) {
	for (const ClassRecord *r = &record_of(wrapped(p_instance)); r; r = r->parent) {
		if (r->get && r->get(wrapped(p_instance), name_at(p_name), *static_cast<Variant *>(r_value))) {
			return true;
		}
	}
	return false;
}

void collect_properties(const ClassRecord *p_record, const Wrapped *p_self, List<PropertyInfo> *r_list) {
	if (p_record->parent) {
		collect_properties(p_record->parent, p_self, r_list);
	}
	if (p_record->get_property_list) {
		p_record->get_property_list(p_self, r_list);
	}
}

// The engine returns only the pointer to the first entry. This header in the bytes before it contains the owner of the
// strings.
struct PropertyListHeader {
	List<PropertyInfo> *list;
	void *padding;
};

const GDExtensionPropertyInfo *get_property_list(void *p_instance, uint32_t *r_count) {
	auto *list = new List<PropertyInfo>;
	collect_properties(&record_of(wrapped(p_instance)), wrapped(p_instance), list);
	*r_count = uint32_t(list->size());
	void *bytes = std::malloc(sizeof(PropertyListHeader) + list->size() * sizeof(GDExtensionPropertyInfo));
	auto *header = static_cast<PropertyListHeader *>(bytes);
	*header = { list, nullptr };
	auto *entries = reinterpret_cast<GDExtensionPropertyInfo *>(header + 1);
	for (const PropertyInfo &info : *list) {
		*entries++ = info.c_info();
	}
	return reinterpret_cast<GDExtensionPropertyInfo *>(header + 1);
}

void free_property_list(void *, const GDExtensionPropertyInfo *p_list, uint32_t) {
	auto *header = reinterpret_cast<PropertyListHeader *>(const_cast<GDExtensionPropertyInfo *>(p_list)) - 1;
	delete header->list;
	std::free(header);
}

GDExtensionBool can_revert(void *p_instance, GDExtensionConstStringNamePtr p_name) {
	for (const ClassRecord *r = &record_of(wrapped(p_instance)); r; r = r->parent) {
		if (r->property_can_revert && r->property_can_revert(wrapped(p_instance), name_at(p_name))) {
			return true;
		}
	}
	return false;
}

GDExtensionBool get_revert(void *p_instance, GDExtensionConstStringNamePtr p_name, GDExtensionVariantPtr r_value) {
	for (const ClassRecord *r = &record_of(wrapped(p_instance)); r; r = r->parent) {
		if (r->property_get_revert &&
				r->property_get_revert(wrapped(p_instance), name_at(p_name), *static_cast<Variant *>(r_value))) {
			return true;
		}
	}
	return false;
}

void validate(const ClassRecord *p_record, const Wrapped *p_self, PropertyInfo &r_info) {
	if (p_record->parent) {
		validate(p_record->parent, p_self, r_info);
	}
	if (p_record->validate_property) {
		p_record->validate_property(p_self, r_info);
	}
}

GDExtensionBool validate_property(void *p_instance, GDExtensionPropertyInfo *r_property) {
	PropertyInfo info(Variant::Type(r_property->type), name_at(r_property->name), PropertyHint(r_property->hint),
			*static_cast<const String *>(r_property->hint_string), r_property->usage);
	info.class_name = name_at(r_property->class_name);
	validate(&record_of(wrapped(p_instance)), wrapped(p_instance), info);
	r_property->type = GDExtensionVariantType(info.type);
	*static_cast<StringName *>(r_property->name) = info.name;
	*static_cast<StringName *>(r_property->class_name) = info.class_name;
	r_property->hint = info.hint;
	*static_cast<String *>(r_property->hint_string) = info.hint_string;
	r_property->usage = info.usage;
	return true;
}

void to_string(void *p_instance, GDExtensionBool *r_is_valid, GDExtensionStringPtr r_text) {
	*r_is_valid = false;
	for (const ClassRecord *r = &record_of(wrapped(p_instance)); r; r = r->parent) {
		if (r->to_string) {
			*static_cast<String *>(r_text) = r->to_string(wrapped(p_instance));
			*r_is_valid = true;
			return;
		}
	}
}

void *get_virtual(void *p_record, GDExtensionConstStringNamePtr p_name, uint32_t p_hash) {
	return const_cast<VirtualOverride *>(
			static_cast<const ClassRecord *>(p_record)->virtuals.find(name_at(p_name), p_hash));
}

void call_virtual(void *p_instance, GDExtensionConstStringNamePtr, void *p_override,
		const GDExtensionConstTypePtr *p_arguments, GDExtensionTypePtr r_result) {
	static_cast<const VirtualOverride *>(p_override)->call(wrapped(p_instance), p_arguments, r_result);
}

} // namespace

void ClassRecord::register_class() {
	GDExtensionClassCreationInfo5 info = {};
	info.is_virtual = is_virtual;
	info.is_abstract = is_abstract;
	info.is_exposed = is_exposed;
	info.is_runtime = is_runtime;
	info.set_func = internal::set;
	info.get_func = internal::get;
	info.get_property_list_func = internal::get_property_list;
	info.free_property_list_func = free_property_list;
	info.property_can_revert_func = can_revert;
	info.property_get_revert_func = get_revert;
	info.validate_property_func = internal::validate_property;
	info.notification_func = notify;
	info.to_string_func = internal::to_string;
	info.create_instance_func = construct && !is_abstract ? create : nullptr;
	info.free_instance_func = free_instance;
	info.recreate_instance_func = construct ? recreate : nullptr;
	info.get_virtual_call_data_func = get_virtual;
	info.call_virtual_with_data_func = call_virtual;
	info.class_userdata = this;
	gde.classdb_register_extension_class5(library, &class_name, &parent_name, &info);
}

} // namespace godot::internal
