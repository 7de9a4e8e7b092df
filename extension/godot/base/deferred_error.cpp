#include "base/deferred_error.hpp"

#include "base/messages.hpp"

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/resource_loader.hpp>
#include <godot_cpp/classes/script.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

using namespace godot;

namespace undergrowth {

// Covers load(), preload(), load_threaded_get(), reload_current_scene() and change_scene_to_file().
static bool is_loading(const String &line) {
	return line.contains("load") || line.contains("scene");
}

// Returns the current line of a script, from the innermost frame.
static String running_line(Object *trace) {
	const Ref<Script> script = ResourceLoader::get_singleton()->load(trace->call("get_frame_file", 0));
	const PackedStringArray lines = script.is_valid() ? script->get_source_code().split("\n") : PackedStringArray();
	const int64_t number = int64_t(trace->call("get_frame_line", 0)) - 1;
	return number >= 0 && number < lines.size() ? lines[number] : String();
}

static bool is_read_now() {
	const Array traces = Engine::get_singleton()->capture_script_backtraces();
	for (int64_t i = 0; i < traces.size(); i++) {
		Object *trace = traces[i];
		if (trace && int64_t(trace->call("get_frame_count")) > 0) {
			return is_loading(running_line(trace));
		}
	}
	return true;
}

bool DeferredError::suits(const Object *object) {
	const Resource *resource = Object::cast_to<Resource>(object);
	return resource && resource->get_path().is_empty() && is_read_now();
}

void DeferredError::post(const Object *resource, const String &what) {
	DeferredError *report = memnew(DeferredError);
	report->resource = Ref<Resource>(Object::cast_to<Resource>(const_cast<Object *>(resource)));
	report->what = what;
	report->call_deferred("_print");
	report->call_deferred("free");
}

void DeferredError::print() const {
	UtilityFunctions::push_error(describe(resource.ptr()) + ": " + what);
}

void DeferredError::_bind_methods() {
	ClassDB::bind_method(D_METHOD("_print"), &DeferredError::print);
}

} // namespace undergrowth
