#include "field/resources/followed_entries.hpp"

#include "base/follow_changes.hpp"

#include <godot_cpp/core/object.hpp>

using namespace godot;

namespace undergrowth {

static uint64_t id_of(const Object *entry) {
	return entry ? uint64_t(entry->get_instance_id()) : 0;
}

void FollowedEntries::follow(const Array &entries, const Callable &changed) {
	for (const uint64_t old : followed) {
		unfollow_changes(Object::cast_to<Resource>(ObjectDB::get_instance(old)), changed);
	}
	followed.clear();
	for (int64_t i = 0; i < entries.size(); i++) {
		Resource *entry = Object::cast_to<Resource>(entries[i]);
		followed.push_back(id_of(entry));
		follow_changes(entry, changed);
	}
}

bool FollowedEntries::differ(const Array &entries) const {
	bool differs = int64_t(followed.size()) != entries.size();
	for (size_t i = 0; i < followed.size() && !differs; i++) {
		differs = id_of(entries[int64_t(i)]) != followed[i];
	}
	return differs;
}

} // namespace undergrowth
