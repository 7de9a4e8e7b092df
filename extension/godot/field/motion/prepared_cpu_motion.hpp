#pragma once

#include "field/field_simulation.hpp"
#include "field/motion/field_motion.hpp"
#include "field/motion/pose_texture.hpp"
#include "field/page_rows.hpp"

#include <memory>
#include <vector>

namespace undergrowth {

/// The input of CpuMotion for a built field: a simulation, at rest after build(), and textures with its poses.
class PreparedCpuMotion : public PreparedMotion {
public:
	std::unique_ptr<FieldSimulation> simulation;
	std::unique_ptr<PoseTexture> textures;
	std::vector<PageRows> rows; ///< By chunk.

	/// Transfers motion from `old` to matched plants, if their chunks have these rows. Null: no motion exists. Any
	/// thread, while no other code changes either simulation.
	void transfer_motion(
			const FieldSimulation *old, const std::vector<PageRows> &old_rows, const std::vector<PlantMatch> &matches);

	void build(const std::vector<PlantChunk> &chunks, const FieldRenderSetup &setup) override;
	PoseTexels texels(int chunk) const override { return textures->texels(rows[size_t(chunk)]); }
	bool is_too_large() const override { return textures->is_too_large(); }
};

/// A page of one chunk, at rest.
class PreparedCpuChunk : public PreparedChunk {
public:
	MotionPage page;
	std::vector<MotionPlant> plants; ///< Plants of the page.
	TexelRows texels; ///< Texels reserved for it, if any.

	PreparedCpuChunk(
			int species, const MotionSpecies &kind, std::vector<MotionPlant> &&placed, const FieldSettings &settings);
};

/// Implements FieldMotion::PrepareChunk for CpuMotion.
std::unique_ptr<PreparedChunk> prepare_chunk_on_cpu(
		const PlantChunk &chunk, const FieldRenderSetup &setup, const FieldSettings &settings);

/// Implements FieldMotion::Prepare for CpuMotion.
std::unique_ptr<PreparedMotion> prepare_on_cpu(const std::vector<PlantChunk> &chunks, const FieldRenderSetup &setup,
		const FieldSettings &settings, const FieldWind &wind);

} // namespace undergrowth
