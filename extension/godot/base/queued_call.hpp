#pragma once

#include <godot_cpp/core/object.hpp>

#include <utility>

namespace undergrowth {

/// Calls a method of an object once at the end of the frame, for any number of requests before.
class QueuedCall {
public:
	QueuedCall(godot::Object *of, const char *named) : object(of), method(named) {}

	void queue() {
		if (!std::exchange(is_on_its_way, true)) {
			object->call_deferred(method);
		}
	}
	bool is_queued() const { return is_on_its_way; }
	/// Call at the start of the method: later requests queue the next call.
	void begin() { is_on_its_way = false; }

private:
	godot::Object *object;
	const char *method;
	bool is_on_its_way = false;
};

} // namespace undergrowth
