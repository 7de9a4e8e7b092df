#pragma once

#include "field/field_motion.hpp"
#include "field/field_simulation.hpp"
#include "field/page_rows.hpp"
#include "field/pose_texture.hpp"

#include <memory>
#include <vector>

namespace undergrowth {

/// The input of CpuMotion for a built field: a simulation, at rest after fill(), and textures with its poses.
class PreparedCpuMotion : public PreparedMotion {
public:
	std::unique_ptr<FieldSimulation> simulation;
	std::unique_ptr<PoseTexture> textures;
	std::vector<PageRows> rows; ///< By block.

	/// Transfers motion from `old` to matched plants, if their blocks have these rows. Null: no motion exists. Any
	/// thread, while no other code changes either simulation.
	void keep_motion(
			const FieldSimulation *old, const std::vector<PageRows> &old_rows, const std::vector<KeptPlant> &kept);

	void fill(const std::vector<PlantBlock> &blocks, const FieldStyle &style) override;
	PoseTexels texels(int block) const override { return textures->texels(rows[size_t(block)]); }
	bool is_too_large() const override { return textures->is_too_large(); }
};

/// A page of one block, at rest.
class PreparedCpuBlock : public PreparedBlock {
public:
	MotionPage page;
	std::vector<MotionPlant> plants; ///< Plants of the page.
	TexelRows texels; ///< Texels reserved for it, if any.

	PreparedCpuBlock(
			int species, const MotionSpecies &kind, std::vector<MotionPlant> &&placed, const FieldSettings &settings);
};

/// Implements FieldMotion::PrepareBlock for CpuMotion.
std::unique_ptr<PreparedBlock> prepare_block_on_cpu(
		const PlantBlock &block, const FieldStyle &style, const FieldSettings &settings);

/// Implements FieldMotion::Prepare for CpuMotion.
std::unique_ptr<PreparedMotion> prepare_on_cpu(const std::vector<PlantBlock> &blocks, const FieldStyle &style,
		const FieldSettings &settings, const FieldWind &wind);

} // namespace undergrowth
