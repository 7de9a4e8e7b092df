#pragma once

#include <godot_cpp/core/object.hpp>

#include <utility>

namespace undergrowth {

/// A method that an object calls once at the end of a frame, however often that is asked for before.
class QueuedCall {
public:
	QueuedCall(godot::Object *of, const char *named) : object(of), method(named) {}

	void queue() {
		if (!std::exchange(is_on_its_way, true)) {
			object->call_deferred(method);
		}
	}
	bool is_queued() const { return is_on_its_way; }
	/// It is called now, so who asks from now on asks for the next one.
	void begin() { is_on_its_way = false; }

private:
	godot::Object *object;
	const char *method;
	bool is_on_its_way = false;
};

} // namespace undergrowth
