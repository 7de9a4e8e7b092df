#pragma once

#include "field/field_simulation.hpp"
#include "field/motion/pose_texture.hpp"
#include "field/page_rows.hpp"
#include "field/view/field_render_setup.hpp"
#include "placement/plant_matches.hpp"
#include "wind/field_wind.hpp"

#include <memory>
#include <vector>

namespace undergrowth {

/// The data of FieldMotion for a field that is being built on a worker thread: a simulation and textures with its
/// poses. FieldMotion::adopt() uses it.
class PreparedMotion {
public:
	std::unique_ptr<FieldSimulation> simulation;
	std::unique_ptr<PoseTexture> textures;
	std::vector<PageRows> rows; ///< By chunk.

	/// Allocates the data for chunks of a setup, under a wind at its start. On any thread.
	PreparedMotion(const std::vector<PlantChunk> &chunks, const FieldRenderSetup &setup, const FieldSettings &settings,
			const FieldWind &wind);
	/// Adds all plants of these chunks, at rest. Call it once, on any thread. Another thread may make the setup's
	/// materials and meshes at the same time.
	void build(const std::vector<PlantChunk> &chunks, const FieldRenderSetup &setup);
	/// Transfers motion from `old` to matched plants, if their chunks have these rows. Null: no motion exists. Any
	/// thread, while no other code changes either simulation.
	void transfer_motion(
			const FieldSimulation *old, const std::vector<PageRows> &old_rows, const std::vector<PlantMatch> &matches);
	/// Texels of chunk i of the list that it was prepared for.
	PoseTexels texels(int chunk) const { return textures->texels(rows[size_t(chunk)]); }
	/// True if it needs more texture layers than graphics cards have.
	bool is_too_large() const { return textures->is_too_large(); }

private:
	void add_pages(const std::vector<PlantChunk> &chunks, const FieldRenderSetup &setup);
};

/// A page of a new chunk of an existing field, at rest. Made on any thread; FieldMotion::apply() uses it.
class PreparedChunk {
public:
	MotionPage page;
	std::vector<MotionPlant> plants; ///< Plants of the page.
	TexelRows texels; ///< Texels reserved for it, if any.

	PreparedChunk(const PlantChunk &chunk, const FieldRenderSetup &setup, const FieldSettings &settings);

private:
	PreparedChunk(
			int species, const MotionSpecies &kind, std::vector<MotionPlant> &&placed, const FieldSettings &settings);
};

/// New chunks of an existing field.
struct ArrivingChunks {
	std::vector<std::unique_ptr<PreparedChunk>> prepared; ///< In the order of StoreEdit::arriving.
	/// Plants that continue their motion, from chunks that the same edit drops.
	std::vector<PlantMatch> matches;
	/// Multimeshes of dropped plants remain. Their texels then draw nothing and are not reused.
	bool leaves_texels = false;
};

} // namespace undergrowth
