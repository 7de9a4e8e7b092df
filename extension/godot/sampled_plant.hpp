#pragma once

#include "mesh/cross_section.hpp"
#include "mesh/plant_mesh.hpp"
#include "stem/stem_constants.hpp"

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/material.hpp>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <memory>
#include <vector>

namespace undergrowth {

class GrownPlant;

/// All that the engine's mesh of a plant is made of.
struct MeshArrays {
	godot::Array arrays;
	int64_t format = 0; ///< Of the custom ones.
	godot::Ref<godot::Material> material; ///< Null: the add-on's own.
	bool has_parts = false;

	/// How far it goes from its axis (m), deviations included.
	float width() const;
	/// On any thread, but for the headless engine's stand-in for a renderer: the main one.
	godot::Ref<godot::ArrayMesh> make() const;
};

/// A plant function, asked at one height and level of detail: all that its mesh needs, copied, so that a worker thread
/// may build it while the function changes.
struct SampledPlant {
	CrossSection cross_section;
	std::vector<float> widths; ///< lod + 1.
	std::vector<glm::vec4> colors; ///< lod + 1.
	float height = 0.0f; ///< m.
	int lod = 0;
	MeshOptions options; ///< With the seed.
	godot::Ref<godot::Material> material; ///< Null: the add-on's own.
	bool has_part_bones = false; ///< It is for a skeleton that has the bones of its parts, beside root and tip.
	std::shared_ptr<const StemConstants> stem; ///< Of one that bends along its length, on a skeleton; else null.
	/// Of a plant of parts on a skeleton: its bend in calm air, in its own axes (motion/bend_encoding.hpp).
	glm::vec2 rest = { 0.0f, 0.0f };
	std::shared_ptr<const GrownPlant> grown; ///< A plant of parts: then cross-section, widths and colours are empty.

	/// The largest distance of a side point from the plant's axis (m).
	float widest() const;
	/// On any thread. Of plants of parts it also tells what the plant (x) and this mesh of it (y) show from straight
	/// above, in shares of what they show from the side, where that is wanted.
	MeshArrays build_arrays(godot::Vector2 *from_above = nullptr) const;
	/// The mesh of these, on a thread that may make it.
	godot::Ref<godot::ArrayMesh> build() const { return build_arrays().make(); }
};

} // namespace undergrowth
