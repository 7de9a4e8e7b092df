#include "probe_counter.hpp"

#include <utility>

using namespace godot;

namespace probe {

Ref<ProbeCounter> ProbeCounter::make() {
	Ref<ProbeCounter> made;
	made.instantiate();
	return made;
}

Array ProbeCounter::make_many(int p_count) {
	Array result;
	for (int i = 0; i < p_count; i++) {
		result.push_back(make());
	}
	return result;
}

Ref<Resource> ProbeCounter::make_resource() {
	Ref<Resource> made;
	made.instantiate();
	made->set_name("made");
	return made;
}

int ProbeCounter::count_of(const Ref<RefCounted> &p_ref) const {
	return p_ref.is_valid() ? p_ref->get_reference_count() : 0;
}

bool ProbeCounter::juggle(const Ref<ProbeCounter> &p_ref) {
	const int before = p_ref->get_reference_count();
	{
		Ref<ProbeCounter> copy = p_ref;
		Ref<ProbeCounter> moved = std::move(copy);
		Ref<RefCounted> base = moved;
		Ref<ProbeCounter> back = base;
		Ref<Resource> wrong = base;
		Variant variant = back;
		Ref<ProbeCounter> from_variant = variant;
		Array array;
		array.push_back(back);
		array.push_back(variant);
		Ref<ProbeCounter> from_array = array[1];
		Ref<ProbeCounter> again(p_ref.ptr());
		const Ref<ProbeCounter> &itself = again; // By another name, or the compiler takes it for a slip.
		again = itself;
		again = from_array;
		if (copy.is_valid() || wrong.is_valid() || again != p_ref || from_variant != p_ref) {
			return false;
		}
		again.unref();
		if (again.is_valid() || p_ref->get_reference_count() <= before) {
			return false;
		}
	}
	return p_ref->get_reference_count() == before;
}

void ProbeCounter::_bind_methods() {
	ClassDB::bind_static_method("ProbeCounter", D_METHOD("get_alive"), &ProbeCounter::get_alive);
	ClassDB::bind_static_method("ProbeCounter", D_METHOD("make"), &ProbeCounter::make);
	ClassDB::bind_static_method("ProbeCounter", D_METHOD("make_many", "count"), &ProbeCounter::make_many, DEFVAL(2));
	ClassDB::bind_static_method("ProbeCounter", D_METHOD("make_resource"), &ProbeCounter::make_resource);
	ClassDB::bind_method(D_METHOD("hold", "ref"), &ProbeCounter::hold);
	ClassDB::bind_method(D_METHOD("get_held"), &ProbeCounter::get_held);
	ADD_PROPERTY(PropertyInfo(Variant::OBJECT, "held", PROPERTY_HINT_RESOURCE_TYPE, "RefCounted"), "hold", "get_held");
	ClassDB::bind_method(D_METHOD("pass", "ref"), &ProbeCounter::pass);
	ClassDB::bind_method(D_METHOD("pass_variant", "value"), &ProbeCounter::pass_variant);
	ClassDB::bind_method(D_METHOD("count_of", "ref"), &ProbeCounter::count_of);
	ClassDB::bind_method(D_METHOD("juggle", "ref"), &ProbeCounter::juggle);
	ClassDB::bind_method(D_METHOD("get_self"), &ProbeCounter::get_self);
}

} // namespace probe
