#pragma once

#include "field/species_styles.hpp"

#include <vector>

namespace undergrowth {

/// Styles and levels of detail of all plants of a field.
struct FieldRenderSetup {
	std::vector<SpeciesStyle> styles; ///< By species.
	std::vector<FieldLevel> levels; ///< At least one, nearest first.
	float tile_size = 16.0f; ///< m, of the tiles of chunks.
	bool is_of_tiles = false; ///< No multimesh is wider than a tile, because tiles come and go alone.
	/// True in the Compatibility renderer: it reads custom data as colours if instances have no colours.
	bool needs_colors = false;
	int listed_count = 0; ///< Styles of the field's list of species. The remaining ones belong to added plants.
	godot::String left_out; ///< Faults of list entries without plants; empty: none.

	/// True if no plant of an entry of the list can be built.
	bool is_absent(int listed) const {
		return listed < listed_count && size_t(listed) < styles.size() && styles[size_t(listed)].is_absent;
	}
};

/// Properties of an instance besides its mesh: the engine's own properties of the node.
struct InstanceRenderFlags {
	uint32_t layers = 1;
	bool casts_shadows = true;
	float transparency = 0.0f;

	bool operator==(const InstanceRenderFlags &other) const {
		return layers == other.layers && casts_shadows == other.casts_shadows && transparency == other.transparency;
	}
};

} // namespace undergrowth
