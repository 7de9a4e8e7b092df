#pragma once

#include "field/field_motion.hpp"
#include "field/field_simulation.hpp"
#include "field/page_rows.hpp"
#include "field/pose_texture.hpp"

#include <memory>
#include <vector>

namespace undergrowth {

/// What CpuMotion takes over of a field that is grown: a simulation, at rest once it is filled, and textures that hold
/// its poses.
class PreparedCpuMotion : public PreparedMotion {
public:
	std::unique_ptr<FieldSimulation> simulation;
	std::unique_ptr<PoseTexture> textures;
	std::vector<PageRows> rows; ///< By block.

	/// Whoever is kept goes on with the motion that it has in `old`, where its block has these rows. Null: nobody has
	/// any. On any thread, while nobody changes either simulation.
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
	std::vector<MotionPlant> plants; ///< Of the page.
	TexelRows texels; ///< That are reserved for it, if any.

	PreparedCpuBlock(
			int species, const MotionSpecies &kind, std::vector<MotionPlant> &&placed, const FieldSettings &settings);
};

/// CpuMotion's FieldMotion::PrepareBlock.
std::unique_ptr<PreparedBlock> prepare_block_on_cpu(
		const PlantBlock &block, const FieldStyle &style, const FieldSettings &settings);

/// CpuMotion's FieldMotion::Prepare.
std::unique_ptr<PreparedMotion> prepare_on_cpu(const std::vector<PlantBlock> &blocks, const FieldStyle &style,
		const FieldSettings &settings, const FieldWind &wind);

} // namespace undergrowth
