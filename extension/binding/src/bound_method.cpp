#include <godot_cpp/core/bound_method.hpp>

#include <godot_cpp/core/object.hpp>

#include "c_info.hpp"

namespace godot::internal {

namespace {

constexpr int max_arguments = 16;

void call(void *p_method, GDExtensionClassInstancePtr p_self, const GDExtensionConstVariantPtr *p_arguments,
		GDExtensionInt p_count, GDExtensionVariantPtr r_result, GDExtensionCallError *r_error) {
	static_cast<const BoundMethod *>(p_method)->call(static_cast<Wrapped *>(p_self),
			reinterpret_cast<const Variant *const *>(p_arguments), p_count, *static_cast<Variant *>(r_result),
			*r_error);
}

void call_pointers(void *p_method, GDExtensionClassInstancePtr p_self, const GDExtensionConstTypePtr *p_arguments,
		GDExtensionTypePtr r_result) {
	static_cast<const BoundMethod *>(p_method)->call_pointers(static_cast<Wrapped *>(p_self), p_arguments, r_result);
}

} // namespace

bool BoundMethod::call(Wrapped *p_self, const Variant *const *p_arguments, int64_t p_count, Variant &r_result,
		GDExtensionCallError &r_error) const {
	const int64_t count = int64_t(arguments.size());
	const int64_t required = count - int64_t(defaults.size());
	r_error = { GDEXTENSION_CALL_OK, 0, 0 };
	if (p_count > count) {
		r_error = { GDEXTENSION_CALL_ERROR_TOO_MANY_ARGUMENTS, int32_t(count), int32_t(count) };
		return false;
	}
	if (p_count < required) {
		r_error = { GDEXTENSION_CALL_ERROR_TOO_FEW_ARGUMENTS, int32_t(required), int32_t(required) };
		return false;
	}
	const Variant *all[max_arguments];
	for (int64_t i = 0; i < count; i++) {
		all[i] = i < p_count ? p_arguments[i] : &defaults[size_t(i - required)];
	}
	int32_t expected = 0;
	const int wrong = first_wrong(all, expected);
	if (wrong >= 0) {
		r_error = { GDEXTENSION_CALL_ERROR_INVALID_ARGUMENT, wrong, expected };
		return false;
	}
	call_variants(p_self, all, r_result);
	return true;
}

void BoundMethod::register_in(const StringName &p_class) {
	if (arguments.size() > max_arguments || defaults.size() > arguments.size()) {
		ERR_PRINT(vformat("The method %s of %s has too many arguments or default values.", name, p_class));
		return;
	}
	GDExtensionPropertyInfo c_result = result.c_info();
	std::vector<GDExtensionPropertyInfo> c_arguments = c_infos(arguments);
	std::vector<GDExtensionVariantPtr> c_defaults;
	for (Variant &value : defaults) {
		c_defaults.push_back(&value);
	}
	const GDExtensionClassMethodInfo info = { &name, this, internal::call, internal::call_pointers, flags, returns,
		&c_result, result_metadata, uint32_t(arguments.size()), c_arguments.data(), metadata.data(),
		uint32_t(defaults.size()), c_defaults.data() };
	gde.classdb_register_extension_class_method(library, &p_class, &info);
}

} // namespace godot::internal
