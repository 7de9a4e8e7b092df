#pragma once

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/object.hpp>
#include <godot_cpp/variant/string.hpp>

namespace undergrowth {

/// A deferred error about a resource that is being read from its file. The resource has no path until it is read
/// completely. So the error is printed at the end of the frame, with the path. Internal: scripts do not see this class.
class DeferredError : public godot::Object {
	GDCLASS(DeferredError, godot::Object)

public:
	/// True if `object` is a resource without a path that is probably being read. If a script runs, its current line
	/// must load something. An error by a script that sets a property of its own resource is immediate, so that a
	/// debugger shows the line.
	static bool suits(const godot::Object *object);
	/// Prints `what` about `resource` at the end of the frame.
	static void post(const godot::Object *resource, const godot::String &what);

protected:
	static void _bind_methods();

private:
	godot::Ref<godot::Resource> resource;
	godot::String what;

	void print() const;
};

} // namespace undergrowth
