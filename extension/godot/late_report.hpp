#pragma once

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/string.hpp>

namespace undergrowth {

/// An error about a resource that is being read from its file. Only when all of it is read does the resource know
/// that file, so it is told at the end of the frame, when it names it. Nobody sees this class from outside.
class LateReport : public godot::Object {
	GDCLASS(LateReport, godot::Object)

public:
	/// Whether `object` is a resource that nobody has a file of yet, and something is being read, as far as can be told:
	/// no script runs, or its line loads. A script that sets a property of its own resource is told at once, where a
	/// debugger can show its line.
	static bool suits(const godot::Object *object);
	/// Tells `what` of `resource` late.
	static void post(const godot::Object *resource, const godot::String &what);

protected:
	static void _bind_methods();

private:
	godot::Ref<godot::Resource> resource;
	godot::String what;

	void tell() const;
};

} // namespace undergrowth
