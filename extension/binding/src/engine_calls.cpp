#include <godot_cpp/core/engine_calls.hpp>

#include <cstdio>
#include <mutex>
#include <string>

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/gdvirtual.gen.inc>

namespace godot::internal {

namespace {

std::mutex singletons_mutex;
Singleton *first_singleton = nullptr;

} // namespace

void report_missing(const char *p_class, const char *p_name, int64_t p_hash) {
	char text[512];
	std::snprintf(text, sizeof(text),
			"This Godot has no method %s of %s with the signature this library was built for (hash %lld). "
			"Use the Godot version that the library names, or a newer library.",
			p_name, p_class, static_cast<long long>(p_hash));
	ERR_PRINT(text);
}

void report_call_error(const char *p_name, const GDExtensionCallError &p_error) {
	char text[256];
	std::snprintf(text, sizeof(text), "A call of %s failed: error %d, argument %d, expected %d.", p_name,
			int(p_error.error), p_error.argument, p_error.expected);
	ERR_PRINT(text);
}

GDExtensionMethodBindPtr find_engine_method(const char *p_class, const char *p_name, int, int64_t p_hash) {
	const StringName class_name(p_class);
	const StringName name(p_name);
	return gde.classdb_get_method_bind(&class_name, &name, p_hash);
}

GDExtensionPtrBuiltInMethod find_builtin_method(const char *, const char *p_name, int p_type, int64_t p_hash) {
	const StringName name(p_name);
	return gde.variant_get_ptr_builtin_method(GDExtensionVariantType(p_type), &name, p_hash);
}

GDExtensionPtrUtilityFunction find_utility_function(const char *, const char *p_name, int, int64_t p_hash) {
	const StringName name(p_name);
	return gde.variant_get_ptr_utility_function(&name, p_hash);
}

Variant call_with_values(EngineMethod &p_method, void *p_owner, const Variant *p_values, int64_t p_count) {
	const GDExtensionMethodBindPtr bind = p_method.get();
	if (!bind) {
		return Variant();
	}
	ValuePointers pointers(p_values, p_count);
	Variant result{ Uninitialized() };
	GDExtensionCallError error{ GDEXTENSION_CALL_OK, 0, 0 };
	gde.object_method_bind_call(bind, p_owner, pointers.get(), p_count, &result, &error);
	if (error.error != GDEXTENSION_CALL_OK) {
		report_call_error(p_method.get_name(), error);
	}
	return result;
}

Wrapped *Singleton::find() {
	const StringName singleton_name(name);
	Wrapped *wrapped = wrapper_of(gde.global_get_singleton(&singleton_name));
	if (!wrapped) {
		return nullptr; // does not exist yet, or not in this build of the engine
	}
	const std::lock_guard<std::mutex> lock(singletons_mutex);
	if (!found.load(std::memory_order_relaxed)) {
		next = first_singleton;
		first_singleton = this;
		wrapped->_wrapper.is_singleton = true;
		found.store(wrapped, std::memory_order_release);
	}
	return wrapped;
}

void Singleton::forget(const Wrapped *p_wrapped) {
	const std::lock_guard<std::mutex> lock(singletons_mutex);
	Singleton **link = &first_singleton;
	while (Singleton *singleton = *link) {
		if (singleton->found.load(std::memory_order_relaxed) == p_wrapped) {
			singleton->found.store(nullptr, std::memory_order_release);
			*link = singleton->next;
		} else {
			link = &singleton->next;
		}
	}
}

bool script_has(const Wrapped *p_self, const StringName &p_name) {
	return gde.object_has_script_method(p_self->_owner, &p_name);
}

bool call_script(
		const Wrapped *p_self, const StringName &p_name, const Variant *p_values, int64_t p_count, Variant &r_result) {
	ValuePointers pointers(p_values, p_count);
	Variant result{ Uninitialized() };
	GDExtensionCallError error{ GDEXTENSION_CALL_OK, 0, 0 };
	gde.object_call_script_method(p_self->_owner, &p_name, pointers.get(), p_count, &result, &error);
	r_result = std::move(result);
	return error.error == GDEXTENSION_CALL_OK;
}

} // namespace godot::internal
