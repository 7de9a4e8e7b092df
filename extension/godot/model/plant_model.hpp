#pragma once

#include "mesh/level_error.hpp"
#include "model/model_file.hpp"
#include "model/model_motion.hpp"

#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <memory>
#include <mutex>

namespace undergrowth {

/// What a user sets for a model.
struct ModelOptions {
	ModelFrameOptions frame;
	ModelColors colors;
	godot::PackedInt32Array foliage; ///< Surfaces that are leaves, through all meshes of the file. Empty: found.
};

struct MeshArrays;
struct SampledPlant;

/// A user's mesh as a plant: its surfaces in the plant's axes with the attributes of mesh/vertex_format.hpp, for all
/// levels of detail. Immutable.
class PlantModel {
public:
	/// Analyses a file. Returns null and sets `problem`, what is wrong and what to do, if it cannot become a plant.
	static std::shared_ptr<const PlantModel> make(
			const FileModel &file, const ModelOptions &options, godot::String &problem);

	/// Height of the plant (m).
	float height() const { return frame.height; }
	const FormBones &bones() const { return motions.front().bones; }
	const ModelMotion &found() const { return motions.front(); }
	const ModelFrame &found_frame() const { return frame; }
	int level_count() const { return int(levels.size()); }
	/// Returns the level for a number of segments along a plant: 12 or more show all triangles.
	int level_of(int segments) const;
	/// Returns the number of triangles for a number of segments.
	int triangles(int segments) const;
	/// Returns the error of the outline of such a level (m). Measured at the first call. Any thread.
	float error(int segments) const;
	/// Appends the materials of the surfaces that such a level draws, in the order of build().
	void list_materials(int segments, std::vector<godot::Ref<godot::Material>> &into) const;
	/// Builds the arrays of a sample of this model, one for each surface. Any thread.
	MeshArrays build(const SampledPlant &sampled) const;

private:
	/// Vertices of one surface of one file level.
	struct Vertices {
		godot::Array arrays; ///< Without bones, indices and the customs that follow.
		godot::PackedVector3Array positions;
		godot::PackedFloat32Array customs[4];
		godot::PackedFloat32Array stem_places;
		std::vector<int> leaves; ///< ModelVertices::leaves.
		godot::PackedInt32Array bones;
		godot::PackedFloat32Array weights; ///< Of root, tip and parts, without joints.
		godot::Ref<godot::Material> material;
	};
	struct Drawn {
		int vertices = 0; ///< Index in `all`.
		godot::PackedInt32Array indices;
	};

	ModelFrame frame;
	std::vector<ModelMotion> motions; ///< By level of the file. Vertices are in `all`.
	std::vector<Vertices> all;
	std::vector<std::vector<Drawn>> levels; ///< Finest first.
	mutable std::mutex measuring;
	mutable std::vector<float> errors; ///< m, by level; empty until they are measured.

	void add_level(const std::vector<FileSurface> &surfaces, ModelMotion &&motion);
	void add_lods(const std::vector<FileSurface> &surfaces);
	/// Returns a surface with a share of its leaves, which are wider.
	Drawn thinned(const Drawn &whole, float share);
	void measure() const;
};

} // namespace undergrowth
