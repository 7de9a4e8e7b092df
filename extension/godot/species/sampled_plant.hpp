#pragma once

#include "mesh/cross_section.hpp"
#include "mesh/plant_mesh.hpp"
#include "plant/part_motion.hpp"
#include "stem/stem_constants.hpp"

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/material.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <memory>
#include <vector>

namespace undergrowth {

class FormBones;
class GrownPlant;
class PlantModel;
class SharedCards;

/// Returns the format of a custom attribute, 0 to 3, as bits of MeshArrays::format.
constexpr int64_t custom_format(int custom, godot::Mesh::ArrayCustomFormat format) {
	constexpr int BITS = godot::Mesh::ARRAY_FORMAT_CUSTOM1_SHIFT - godot::Mesh::ARRAY_FORMAT_CUSTOM0_SHIFT;
	return int64_t(format) << (int64_t(godot::Mesh::ARRAY_FORMAT_CUSTOM0_SHIFT) + BITS * custom);
}

/// All data of a plant's mesh in the engine.
struct MeshArrays {
	godot::Array arrays;
	int64_t format = 0; ///< Of the custom arrays.
	godot::Ref<godot::Material> material; ///< Null: the add-on's material.
	bool has_parts = false;
	bool has_cards = false;
	/// Solid shapes in place of several parts. Without cards, only those in place of parts that are not close together.
	bool has_bodies = false;
	float facets = 0.0f; ///< m: see facets_of(). 0 for plants without parts.
	bool is_model = false; ///< Of a PlantModel. Null is then no material.
	std::vector<MeshArrays> others = {}; ///< Further surfaces of a model, without surfaces of their own.
	/// Packed inner swings (PackedSwing) of a plant with branched branches, from the outermost; else empty.
	godot::PackedFloat32Array inner[MAX_INNER_SWINGS] = {};

	/// Largest distance from the axis (m), deviations included.
	float width() const;
	/// Creates the mesh on any thread. With the dummy renderer of a headless engine: on the main thread only.
	godot::Ref<godot::ArrayMesh> make() const;
};

/// A plant function, sampled at one height and level of detail. It is a copy of all input of the mesh, so that a worker
/// thread may build it while the function changes.
struct SampledPlant {
	CrossSection cross_section;
	std::vector<float> widths; ///< lod + 1.
	std::vector<glm::vec4> colors; ///< lod + 1.
	float height = 0.0f; ///< m.
	int lod = 0;
	MeshOptions options; ///< With the seed.
	godot::Ref<godot::Material> material; ///< Null: the add-on's material.
	bool has_part_bones = false; ///< It is for a skeleton with bones of its parts, besides root and tip.
	bool is_packed = false; ///< A plant of parts of a field whose material reads packed vertices.
	std::shared_ptr<const StemConstants> stem; ///< Of a stem with bones along its length; null for a straight one.
	/// Rest bend of a plant of parts on a skeleton, in its own axes (motion/bend_encoding.hpp).
	glm::vec2 rest = { 0.0f, 0.0f };
	std::shared_ptr<const GrownPlant> grown; ///< For a plant of parts; cross-section, widths and colors are empty then.

	std::shared_ptr<const PlantModel>
			model; ///< For a plant of a user's mesh; cross-section, widths and colors are empty then.

	/// Cards replace the small parts of a plant of parts, if they are not null and its level has room for them.
	std::shared_ptr<SharedCards> cards;

	/// The largest distance of a side point from the plant's axis (m).
	float widest() const;
	/// True if its vertices have the attributes of parts (mesh/vertex_format.hpp).
	bool has_parts() const { return grown || model; }
	/// Bones of its parts for the height of bones_height(); null: none.
	const FormBones *part_bones() const;
	/// Height (m) of the plant with part_bones().
	float bones_height() const;
	/// Builds the arrays on any thread. For a plant of parts, also sets `from_above`, unless it is null, to two areas
	/// as seen from above. These are the area of the plant (x) and of this mesh (y), relative to the area as seen from
	/// the side.
	MeshArrays build_arrays(godot::Vector2 *from_above = nullptr) const;
	/// Builds the mesh. For threads that may call MeshArrays::make().
	godot::Ref<godot::ArrayMesh> build() const { return build_arrays().make(); }
};

} // namespace undergrowth
