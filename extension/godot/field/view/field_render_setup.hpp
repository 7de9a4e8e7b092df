#pragma once

#include "field/view/species_styles.hpp"

#include <vector>

namespace undergrowth {

/// Inputs for the distances of levels that are chosen by the error of each species.
struct LevelRule {
	bool is_by_error = false; ///< False: all species have the field's levels.
	float pixel_error = 2.0f; ///< Pixels, of a picture with 1080 lines.
	float lod_bias = 1.0f;
	float fade_ratio = 0.25f; ///< Length of a transition over its distance.
	float range_end = 0.0f; ///< m; 0: no end.
	float shadow_distance = 30.0f; ///< m.
	bool has_near_shadows = true; ///< The nearest plants may cast shadows of a finer level than the others.
	float area = 0.0f; ///< m², of the field; 0: unknown.
	bool is_wider = true; ///< Squares may be wider than a tile.
};

/// Styles and levels of detail of all plants of a field.
struct FieldRenderSetup {
	std::vector<SpeciesStyle> styles; ///< By species.
	std::vector<FieldLevel> levels; ///< At least one, nearest first. Each style has the same, at its own distances.
	LevelRule rule;
	godot::Ref<godot::Material> material_override; ///< Of the node; null: none.
	float tile_size = 16.0f; ///< m, of the tiles of chunks.
	bool is_of_tiles = false; ///< No multimesh is wider than a tile, because tiles come and go alone.
	/// True if its species have one coarse level each, until their errors are measured.
	bool is_draft = false;
	/// True in the Compatibility renderer: it reads custom data as colours if instances have no colours.
	bool needs_colors = false;
	int listed_count = 0; ///< Styles of the field's list of species. The remaining ones belong to added plants.
	godot::String left_out; ///< Faults of list entries without plants; empty: none.

	static constexpr int FLOATS = 16; ///< Of an instance: its transform and custom data.
	static constexpr int FLOATS_WITH_COLORS = 20;
	/// Floats of an instance in a multimesh.
	int instance_floats() const { return needs_colors ? FLOATS_WITH_COLORS : FLOATS; }
	/// True if no plant of an entry of the list can be built.
	bool is_absent(int listed) const {
		return listed < listed_count && size_t(listed) < styles.size() && styles[size_t(listed)].is_absent;
	}
};

/// Copies the parts of a setup that fit_levels(), plans and prepared chunks need.
FieldRenderSetup outline_of(const FieldRenderSetup &setup);

/// Properties of an instance besides its mesh: the engine's own properties of the node.
struct InstanceRenderFlags {
	uint32_t layers = 1;
	bool casts_shadows = true;
	float transparency = 0.0f;
	int gi_mode = 0; ///< A GeometryInstance3D::GIMode.

	bool operator==(const InstanceRenderFlags &other) const {
		return layers == other.layers && casts_shadows == other.casts_shadows && transparency == other.transparency &&
				gi_mode == other.gi_mode;
	}
	/// Sets the global illumination of an instance. New instances of the engine are static.
	void set_gi(const godot::RID &instance) const;
};

} // namespace undergrowth
