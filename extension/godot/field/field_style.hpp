#pragma once

#include "field/field_looks.hpp"

#include <vector>

namespace undergrowth {

/// How all plants of a field are drawn.
struct FieldStyle {
	std::vector<FieldLook> looks; ///< By species.
	std::vector<FieldLevel> levels; ///< At least one, nearest first.
	float tile_size = 16.0f; ///< m, of the stand's blocks.
	bool is_of_tiles = false; ///< No multimesh is wider than a tile, which comes and goes alone.
	bool needs_colors = false; ///< Compatibility takes custom data for colours where instances have no colours.
	int listed_count =
			0; ///< So many looks are of the field's list of species; the others came with plants that were added.
	godot::String left_out; ///< What is wrong with entries of the list that do not grow; empty: nothing.

	/// Whether plants of an entry of the list can grow.
	bool is_absent(int listed) const {
		return listed < listed_count && size_t(listed) < looks.size() && looks[size_t(listed)].is_absent;
	}
};

/// What an instance of the field wears beside its mesh: the engine's own properties of the node.
struct FieldWear {
	uint32_t layers = 1;
	bool casts_shadows = true;
	float transparency = 0.0f;

	bool operator==(const FieldWear &other) const {
		return layers == other.layers && casts_shadows == other.casts_shadows && transparency == other.transparency;
	}
};

} // namespace undergrowth
