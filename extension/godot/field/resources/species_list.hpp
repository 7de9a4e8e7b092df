#pragma once

#include "field/resources/field_options.hpp"
#include "field/resources/followed_entries.hpp"

namespace undergrowth {

/// The list of species that users set. The field is built from a copy of it. If the list is empty, the field grows
/// grass.
class SpeciesList {
public:
	/// `into` gets the copy. Changes of an entry call the node's _on_species_changed().
	SpeciesList(godot::Object *of, PlacementOptions &into) : node(of), options(into) {}

	/// Returns true if the entries differ from the former ones.
	bool set(const godot::TypedArray<PlantFieldSpecies> &entries);
	/// Scripts may append to this array.
	const godot::TypedArray<PlantFieldSpecies> &get() const { return listed; }
	/// True if scripts changed the array, so that it needs follow().
	bool differs() const { return followed.differ(listed); }
	void follow();
	/// Adds grass to an empty list. Call it before a build and not earlier: a resource can be loaded only when its
	/// classes are registered.
	void choose_grass();

	/// Returns the entry that emits `changed` now; null: none. It is null after the library was reloaded, until the
	/// engine has restored all entries.
	godot::Ref<PlantFieldSpecies> find_emitter() const;

private:
	godot::Object *node;
	PlacementOptions &options;
	godot::TypedArray<PlantFieldSpecies> listed;
	FollowedEntries followed;
};

} // namespace undergrowth
