#pragma once

#include <memory>

#include <godot_cpp/core/signature.hpp>

namespace godot::internal {

// A method of the library that the engine calls: with Variants, after a check of their number and types, or with
// pointers.
class BoundMethod {
public:
	StringName name;
	std::vector<Variant> defaults; // of the last arguments
	uint32_t flags = METHOD_FLAG_NORMAL;
	bool returns = false;
	PropertyInfo result;
	GDExtensionClassMethodArgumentMetadata result_metadata = GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
	std::vector<PropertyInfo> arguments;
	std::vector<GDExtensionClassMethodArgumentMetadata> metadata;

	virtual ~BoundMethod() = default;
	virtual int first_wrong(const Variant *const *p_arguments, int32_t &r_expected) const = 0;
	virtual void call_variants(Wrapped *p_self, const Variant *const *p_arguments, Variant &r_result) const = 0;
	virtual void call_pointers(Wrapped *p_self, const GDExtensionConstTypePtr *p_arguments, void *r_result) const = 0;

	// Adds the defaults. Returns false and sets r_error if the arguments do not fit.
	bool call(Wrapped *p_self, const Variant *const *p_arguments, int64_t p_count, Variant &r_result,
			GDExtensionCallError &r_error) const;
	void register_in(const StringName &p_class);

protected:
	template <typename Parts> void describe() {
		returns = !std::is_void_v<typename Parts::Result>;
		result = Parts::describe_result();
		result_metadata = Parts::result_metadata();
		arguments = Parts::describe_arguments();
		metadata = Parts::describe_metadata();
	}
};

template <typename M> class MemberMethod final : public BoundMethod {
	using Class = typename FunctionType<M>::Class;
	using Parts = typename FunctionType<M>::Parts;
	M method;

	auto on(Wrapped *p_self) const {
		return [self = static_cast<Class *>(p_self), function = method](auto &&...p_values) -> decltype(auto) {
			return (self->*function)(std::forward<decltype(p_values)>(p_values)...);
		};
	}

public:
	explicit MemberMethod(M p_method) : method(p_method) {
		describe<Parts>();
		flags |= FunctionType<M>::is_const ? uint32_t(METHOD_FLAG_CONST) : 0u;
	}
	int first_wrong(const Variant *const *p_arguments, int32_t &r_expected) const override {
		return Parts::first_wrong(p_arguments, r_expected);
	}
	void call_variants(Wrapped *p_self, const Variant *const *p_arguments, Variant &r_result) const override {
		Parts::call_variants(on(p_self), p_arguments, r_result);
	}
	void call_pointers(Wrapped *p_self, const GDExtensionConstTypePtr *p_arguments, void *r_result) const override {
		Parts::call_pointers(on(p_self), p_arguments, r_result);
	}
};

template <typename M> class StaticMethod final : public BoundMethod {
	using Parts = typename FunctionType<M>::Parts;
	M function;

public:
	explicit StaticMethod(M p_function) : function(p_function) {
		describe<Parts>();
		flags |= METHOD_FLAG_STATIC;
	}
	int first_wrong(const Variant *const *p_arguments, int32_t &r_expected) const override {
		return Parts::first_wrong(p_arguments, r_expected);
	}
	void call_variants(Wrapped *, const Variant *const *p_arguments, Variant &r_result) const override {
		Parts::call_variants(function, p_arguments, r_result);
	}
	void call_pointers(Wrapped *, const GDExtensionConstTypePtr *p_arguments, void *r_result) const override {
		Parts::call_pointers(function, p_arguments, r_result);
	}
};

} // namespace godot::internal
