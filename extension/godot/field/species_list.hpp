#pragma once

#include "field/field_options.hpp"
#include "field/followed_entries.hpp"

namespace undergrowth {

/// The species that users list of a field, which grows by a copy of that list. Where it is empty, grass grows.
class SpeciesList {
public:
	/// `into` gets the copy. The node's _on_species_changed() hears of what changes in an entry.
	SpeciesList(godot::Object *of, StandOptions &into) : node(of), options(into) {}

	/// Returns whether these entries are other ones.
	bool set(const godot::TypedArray<PlantFieldSpecies> &entries);
	/// Scripts may append to it.
	const godot::TypedArray<PlantFieldSpecies> &get() const { return listed; }
	/// Whether any have, so that it is to be followed anew.
	bool differs() const { return followed.differ(listed); }
	void follow();
	/// Before the field grows, and not earlier: a resource may be loaded only once its classes are known.
	void choose_grass();

	/// While one of them tells of a change: the function that it comes from, or null where it is of the entry itself.
	/// False where the library was reloaded, and the engine has not set an entry again yet.
	bool find_teller(godot::Ref<PlantFunction> &function) const;

private:
	godot::Object *node;
	StandOptions &options;
	godot::TypedArray<PlantFieldSpecies> listed;
	FollowedEntries followed;
};

} // namespace undergrowth
