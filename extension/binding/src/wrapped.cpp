#include <godot_cpp/classes/wrapped.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <unordered_map>

#include <godot_cpp/classes/class_db_singleton.hpp>
#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/engine_calls.hpp>
#include <godot_cpp/core/engine_class.hpp>
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/memory.hpp>
#include <godot_cpp/core/object.hpp>

namespace godot {

thread_local internal::Construction *internal::Construction::current = nullptr;

Wrapped::Wrapped() {
	internal::Construction *construction = internal::Construction::current;
	while (construction && construction->taken) {
		construction = construction->previous;
	}
	if (!construction) {
		std::fputs("FATAL: an object of a Godot class was made without memnew.\n", stderr);
		std::abort();
	}
	construction->taken = true;
	_owner = construction->owner ? construction->owner
								 : internal::gde.classdb_construct_object2(construction->native_name);
	if (!_owner) {
		std::fputs("FATAL: memnew of a class that the engine does not instantiate.\n", stderr);
		std::abort();
	}
}

Object *ObjectDB::get_instance(uint64_t p_id) {
	return static_cast<Object *>(internal::wrapper_of(internal::gde.object_get_instance_from_id(p_id)));
}

namespace internal {

namespace {

// The binding of an object of a library class is freed with the object itself.
void keep_binding(void *, void *, void *) {}
void *no_binding(void *, void *) {
	return nullptr;
}
GDExtensionBool agree(void *, void *, GDExtensionBool) {
	return true;
}
constexpr GDExtensionInstanceBindingCallbacks own_callbacks = { no_binding, keep_binding, agree };

// All wrappers of existing engine objects, as a doubly linked list.
std::mutex wrappers_mutex;
Wrapped *first_wrapper = nullptr;

void enlist(Wrapped *p_wrapped) {
	const std::lock_guard<std::mutex> lock(wrappers_mutex);
	p_wrapped->_wrapper.next = first_wrapper;
	if (first_wrapper) {
		first_wrapper->_wrapper.previous = p_wrapped;
	}
	first_wrapper = p_wrapped;
}

void delist(Wrapped *p_wrapped) {
	const std::lock_guard<std::mutex> lock(wrappers_mutex);
	auto &link = p_wrapped->_wrapper;
	(link.previous ? link.previous->_wrapper.next : first_wrapper) = link.next;
	if (link.next) {
		link.next->_wrapper.previous = link.previous;
	}
}

using WrapFunction = Wrapped *(*)(void *);

WrapFunction find_class(const std::string &p_name) {
	const EngineClass *end = engine_classes + engine_class_count;
	const EngineClass *found = std::lower_bound(engine_classes, end, p_name,
			[](const EngineClass &p_class, const std::string &p_wanted) { return p_class.name < p_wanted; });
	return found != end && found->name == p_name ? found->wrap : nullptr;
}

std::mutex ancestors_mutex;
std::unordered_map<std::string, WrapFunction> ancestors;

// Returns the nearest generated class, at or above the given one.
WrapFunction find_ancestor(const std::string &p_name) {
	if (const WrapFunction known = find_class(p_name)) {
		return known;
	}
	const std::lock_guard<std::mutex> lock(ancestors_mutex);
	WrapFunction &found = ancestors[p_name];
	for (std::string name = p_name; !found;) {
		const String parent = ClassDBSingleton::get_singleton()->get_parent_class(StringName(name.c_str()));
		name = parent.is_empty() ? "Object" : parent.utf8().get_data();
		found = find_class(name);
	}
	return found;
}

void *wrap(void *, void *p_owner) {
	StringName name{ Uninitialized() };
	if (!gde.object_get_class_name(p_owner, library, &name)) {
		name = StringName("Object");
	}
	Wrapped *wrapped = find_ancestor(String(name).utf8().get_data())(p_owner);
	enlist(wrapped);
	return wrapped;
}
void unwrap(void *, void *, void *p_binding) {
	Wrapped *wrapped = static_cast<Wrapped *>(p_binding);
	if (wrapped->_wrapper.is_singleton) {
		Singleton::forget(wrapped);
	}
	delist(wrapped);
	delete wrapped;
}
constexpr GDExtensionInstanceBindingCallbacks engine_callbacks = { wrap, unwrap, agree };

} // namespace

Wrapped *wrapper_of(void *p_owner) {
	if (!p_owner) {
		return nullptr;
	}
	return static_cast<Wrapped *>(gde.object_get_instance_binding(p_owner, library, &engine_callbacks));
}

Wrapped *wrapped_in(const Variant &p_value) {
	if (p_value.get_type() != Variant::OBJECT) {
		return nullptr;
	}
	const GDObjectInstanceID id = gde.variant_get_object_instance_id(&p_value);
	return id ? wrapper_of(gde.object_get_instance_from_id(id)) : nullptr;
}

void join(Wrapped *p_wrapped, const StringName *p_extension_class) {
	if (p_extension_class) {
		gde.object_set_instance(p_wrapped->_owner, p_extension_class, p_wrapped);
		bind_own(p_wrapped);
	} else {
		gde.object_set_instance_binding(p_wrapped->_owner, library, p_wrapped, &engine_callbacks);
		enlist(p_wrapped);
	}
}

void release_wrappers() {
	while (true) {
		void *owner = nullptr;
		{
			const std::lock_guard<std::mutex> lock(wrappers_mutex);
			if (!first_wrapper) {
				return;
			}
			owner = first_wrapper->_owner;
		}
		gde.object_free_instance_binding(owner, library); // calls unwrap
	}
}

void bind_own(Wrapped *p_wrapped) {
	gde.object_set_instance_binding(p_wrapped->_owner, library, p_wrapped, &own_callbacks);
}

void announce(Wrapped *p_wrapped) {
	static_cast<Object *>(p_wrapped)->notification(Object::NOTIFICATION_POSTINITIALIZE);
}

void destroy(Wrapped *p_wrapped) {
	gde.object_destroy(p_wrapped->_owner);
}

bool ref_first(void *p_wrapped) {
	return static_cast<RefCounted *>(p_wrapped)->init_ref();
}

bool ref_more(void *p_wrapped) {
	return static_cast<RefCounted *>(p_wrapped)->reference();
}

void ref_release(void *p_wrapped) {
	RefCounted *object = static_cast<RefCounted *>(p_wrapped);
	if (object->unreference()) {
		gde.object_destroy(object->_owner);
	}
}

void VirtualTable::add(const char *p_name, uint32_t p_hash, VirtualCall p_call) {
	names.emplace_back(p_name);
	overrides[names.back().identity()] = { p_hash, p_call };
}

const VirtualOverride *VirtualTable::find(const StringName &p_name, uint32_t p_hash) const {
	const auto found = overrides.find(p_name.identity());
	if (found == overrides.end()) {
		return nullptr;
	}
	if (found->second.hash != p_hash) {
		report_missing("a class of ours (virtual)", String(p_name).utf8().get_data(), found->second.hash);
		return nullptr;
	}
	return &found->second;
}

} // namespace internal

} // namespace godot
