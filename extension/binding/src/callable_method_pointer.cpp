#include <godot_cpp/variant/callable_method_pointer.hpp>

#include <functional>
#include <string>
#include <string_view>

namespace godot::internal {

namespace {

struct NativeCallable {
	uint64_t object_id;
	std::unique_ptr<BoundMethod> method;
	std::string function; // the bytes of the pointer, for comparison
};

NativeCallable &callable_at(void *p_data) {
	return *static_cast<NativeCallable *>(p_data);
}

void call(void *p_data, const GDExtensionConstVariantPtr *p_arguments, GDExtensionInt p_count,
		GDExtensionVariantPtr r_result, GDExtensionCallError *r_error) {
	const NativeCallable &callable = callable_at(p_data);
	Wrapped *self = callable.object_id ? ObjectDB::get_instance(callable.object_id) : nullptr;
	if (callable.object_id && !self) {
		*r_error = { GDEXTENSION_CALL_ERROR_INSTANCE_IS_NULL, 0, 0 };
		return;
	}
	callable.method->call(self, reinterpret_cast<const Variant *const *>(p_arguments), p_count,
			*static_cast<Variant *>(r_result), *r_error);
}

GDExtensionBool is_valid(void *p_data) {
	const NativeCallable &callable = callable_at(p_data);
	return !callable.object_id || gde.object_get_instance_from_id(callable.object_id) != nullptr;
}

void free_callable(void *p_data) {
	delete static_cast<NativeCallable *>(p_data);
}

uint32_t hash(void *p_data) {
	const NativeCallable &callable = callable_at(p_data);
	return uint32_t(std::hash<std::string>()(callable.function) ^ std::hash<uint64_t>()(callable.object_id));
}

GDExtensionBool equal(void *p_left, void *p_right) {
	const NativeCallable &left = callable_at(p_left);
	const NativeCallable &right = callable_at(p_right);
	return left.object_id == right.object_id && left.function == right.function;
}

GDExtensionBool less_than(void *p_left, void *p_right) {
	const NativeCallable &left = callable_at(p_left);
	const NativeCallable &right = callable_at(p_right);
	return left.object_id != right.object_id ? left.object_id < right.object_id : left.function < right.function;
}

GDExtensionInt argument_count(void *p_data, GDExtensionBool *r_is_valid) {
	*r_is_valid = true;
	return GDExtensionInt(callable_at(p_data).method->arguments.size());
}

} // namespace

Callable make_callable(Object *p_object, std::unique_ptr<BoundMethod> p_method, const void *p_function, size_t p_size) {
	auto *data = new NativeCallable{ p_object ? p_object->get_instance_id() : 0, std::move(p_method),
		std::string(static_cast<const char *>(p_function), p_size) };
	GDExtensionCallableCustomInfo2 info = { data, library, data->object_id, call, is_valid, free_callable, hash, equal,
		less_than, nullptr, argument_count };
	return Callable::custom(info);
}

} // namespace godot::internal
