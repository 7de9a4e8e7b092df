#pragma once

#include "form/grown_plant.hpp"

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/callable.hpp>

#include <list>
#include <memory>

namespace undergrowth {

/// What a species has grown, by seed, so that it is asked once for each. Forgets everything when told that the species
/// is another one now. On any thread.
class GrowthCache {
public:
	/// Null where it has not grown since the last change, or where the species' `state` was another.
	std::shared_ptr<const GrownPlant> find(int64_t seed, int64_t state);
	void keep(int64_t seed, int64_t state, const std::shared_ptr<const GrownPlant> &plant);
	void clear();

private:
	static constexpr size_t MOST_SEEDS = 64; ///< As many as a field has variants; the oldest goes first.
	static constexpr size_t MOST_PARTS = 50000; ///< Of all, about 150 bytes each.

	struct Entry {
		int64_t seed;
		int64_t state;
		std::shared_ptr<const GrownPlant> plant;
	};
	std::mutex mutex;
	std::list<Entry> entries; // The latest first.
	size_t parts = 0;
};

/// A number for the values of a resource's script variables and its source: another when a script says something else,
/// which need not be told by `changed`. 0 without a script.
int64_t state_of_script(godot::Resource *resource);

/// Calls `listener` when a resource changes that one of the script's variables holds.
void follow_script_resources(godot::Resource *resource, const godot::Callable &listener);

} // namespace undergrowth
