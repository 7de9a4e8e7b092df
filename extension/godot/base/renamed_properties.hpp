#pragma once

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/string_name.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <cstdint>
#include <initializer_list>

namespace undergrowth {

/// A property's name in version 0.2 and its present name.
struct RenamedProperty {
	const char *old_name;
	const char *name;
};

/// Sets a property by its old name, so that scenes and resources of version 0.2 load. Warns once for each file, at the
/// end of the frame, when the path of `object` exists. Returns false if `old_name` is not in `renamed`. For `_set()`.
bool set_renamed_property(godot::Object *object, const godot::StringName &old_name, const godot::Variant &value,
		std::initializer_list<RenamedProperty> renamed);

/// Sends the deferred warning of set_renamed_property(). Internal: scripts do not see this class.
class OldNameWarning : public godot::Object {
	GDCLASS(OldNameWarning, godot::Object)

public:
	static void post(const godot::Object *object, const RenamedProperty &property);

protected:
	static void _bind_methods();

private:
	uint64_t object_id = 0;
	RenamedProperty property{};

	void warn() const;
};

} // namespace undergrowth
