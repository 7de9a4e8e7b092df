#include "form/growth_cache.hpp"

#include "base/follow_changes.hpp"

#include <godot_cpp/classes/script.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/dictionary.hpp>

using namespace godot;

namespace undergrowth {

std::shared_ptr<const GrownPlant> GrowthCache::find(int64_t seed, int64_t state) {
	const std::lock_guard<std::mutex> lock(mutex);
	for (const Entry &entry : entries) {
		if (entry.seed == seed && entry.state == state) {
			return entry.plant;
		}
	}
	return nullptr;
}

void GrowthCache::keep(int64_t seed, int64_t state, const std::shared_ptr<const GrownPlant> &plant) {
	const std::lock_guard<std::mutex> lock(mutex);
	entries.remove_if([&](const Entry &entry) {
		const bool goes = entry.seed == seed || entry.state != state;
		parts -= goes ? entry.plant->form.placed.size() : 0;
		return goes;
	});
	entries.push_front({ seed, state, plant });
	parts += plant->form.placed.size();
	while (entries.size() > 1 && (entries.size() > MAX_SEEDS || parts > MAX_PARTS)) {
		parts -= entries.back().plant->form.placed.size();
		entries.pop_back();
	}
}

void GrowthCache::clear() {
	const std::lock_guard<std::mutex> lock(mutex);
	entries.clear();
	parts = 0;
}

// Returns the values of the variables that a script or its base scripts declare.
static Array values_of(Resource *resource, const Ref<Script> &script) {
	Array values;
	const TypedArray<Dictionary> properties = script->get_script_property_list();
	for (int64_t i = 0; i < properties.size(); i++) {
		const Dictionary property = properties[i];
		if (int64_t(property[Variant("usage")]) & PROPERTY_USAGE_SCRIPT_VARIABLE) {
			values.push_back(resource->get(StringName(property[Variant("name")])));
		}
	}
	return values;
}

int64_t state_of_script(Resource *resource) {
	const Ref<Script> script = resource->get_script();
	if (script.is_null()) {
		return 0;
	}
	int64_t state = values_of(resource, script).hash();
	for (Ref<Script> one = script; one.is_valid(); one = one->get_base_script()) {
		state = state * 31 + int64_t(one->get_source_code().hash());
	}
	return state;
}

void follow_script_resources(Resource *resource, const Callable &listener) {
	const Ref<Script> script = resource->get_script();
	const Array values = script.is_valid() ? values_of(resource, script) : Array();
	for (int64_t i = 0; i < values.size(); i++) {
		const Array several = values[i].get_type() == Variant::ARRAY ? Array(values[i]) : Array();
		for (int64_t k = -1; k < several.size(); k++) {
			const Ref<Resource> held = k < 0 ? values[i] : several[k];
			if (held.ptr() != resource) {
				follow_changes(held.ptr(), listener);
			}
		}
	}
}

} // namespace undergrowth
