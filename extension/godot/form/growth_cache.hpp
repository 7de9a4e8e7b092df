#pragma once

#include "form/grown_plant.hpp"

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/variant/callable.hpp>

#include <list>
#include <memory>

namespace undergrowth {

/// The generated plants of a species, by seed, so that each seed is grown once. Any thread.
class GrowthCache {
public:
	/// Returns null if the seed was not grown since clear(), or with another `state` of the species.
	std::shared_ptr<const GrownPlant> find(int64_t seed, int64_t state);
	void keep(int64_t seed, int64_t state, const std::shared_ptr<const GrownPlant> &plant);
	void clear();

private:
	static constexpr size_t MAX_SEEDS = 64; ///< Largest number of variants of a field. The oldest leaves first.
	static constexpr size_t MAX_PARTS = 50000; ///< In all entries; about 150 bytes each.

	struct Entry {
		int64_t seed;
		int64_t state;
		std::shared_ptr<const GrownPlant> plant;
	};
	std::mutex mutex;
	std::list<Entry> entries; // Newest first.
	size_t parts = 0;
};

/// Returns a hash of the values of a resource's script variables and of its source; 0 without a script. It detects
/// changes that do not emit `changed`.
int64_t state_of_script(godot::Resource *resource);

/// Connects `listener` to the changes of all resources in the script's variables.
void follow_script_resources(godot::Resource *resource, const godot::Callable &listener);

} // namespace undergrowth
