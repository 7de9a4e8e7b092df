#pragma once

#include "motion/motion_page.hpp"
#include "plant_function.hpp"
#include "shared_mesh.hpp"
#include "stand/plants.hpp"
#include "stand/thinning.hpp"

#include <godot_cpp/classes/shader_material.hpp>

#include <optional>
#include <tuple>
#include <vector>

namespace undergrowth {

/// One level of detail of a field.
struct FieldLevel {
	int lod = 12; ///< Vertical segments.
	float begin = 0.0f; ///< m from the camera.
	float end = 0.0f; ///< m; 0: no end.
	float margin = 2.0f; ///< m over which it dissolves, > 0.
	int tile_factor = 1; ///< Its multimeshes are so many tiles wide,
	int tile_cuts = 1; ///< or so many of them lie along a tile's side; one of the two is 1.
	Thinning thinning;
	bool thins_lathes = false; ///< Or only plants of parts.
	bool casts_shadows = true;

	bool operator==(const FieldLevel &other) const {
		return std::tie(lod, begin, end, margin, tile_factor, tile_cuts, thins_lathes, casts_shadows) ==
				std::tie(other.lod, other.begin, other.end, other.margin, other.tile_factor, other.tile_cuts,
						other.thins_lathes, other.casts_shadows) &&
				thinning == other.thinning;
	}
	/// How many meshes it draws for a species of `variants` plants: half as many in each further level.
	static int groups(int level, int variants);
	/// Of plants of parts, or of those without.
	Thinning thinning_of(bool has_parts) const { return has_parts || thins_lathes ? thinning : Thinning(); }
};

/// A plant of which a species has several.
struct FieldVariant {
	int64_t seed = 0; ///< A Plant3D with this seed looks the same.
	float height = 1.0f; ///< m.
};

/// One species of a field: what it shows and how it moves. Sampled on the main thread; from then on nothing here reads
/// the function itself but read_motion() and take_material().
struct FieldLook {
	godot::Ref<PlantFunction> function;
	int variant_count = 4; ///< 1 to 64.
	double detail = 1.0; ///< Times the segments of the levels.
	std::vector<FieldVariant> variants;
	std::vector<std::vector<SampledPlant>> samples; ///< By level and group; let go when the meshes are built.
	std::vector<std::vector<std::shared_ptr<SharedMesh>>> built; ///< By level and group; other fields share them.
	std::vector<SampledPlant> nearest; ///< Of the first level, kept for plants that get a mesh of their own.
	std::vector<std::vector<godot::Ref<godot::ArrayMesh>>> meshes; ///< By level and group; null until they are made.
	std::vector<godot::Ref<godot::ShaderMaterial>> materials; ///< By level.
	MotionSpecies motion;
	bool has_motion = false; ///< It was read.
	bool in_air = false; ///< A wind in m/s blows; stems have their shape by it.
	std::shared_ptr<const StemConstants> stem; ///< As `motion` has it; null of another law.
	std::optional<AskedStem> asked_stem; ///< What the function did not know of it when it was sampled,
	std::shared_ptr<SharedStem> shared_stem; ///< Fields that ask for the same stem solve it once.
	SolvedStem solved_stem; ///< and what that came to when meshes were built.
	float width = 0.0f; ///< m: the farthest that any mesh goes from its axis.
	/// By level: what plants of parts and their meshes show from above, in shares of what they show from the side.
	std::vector<godot::Vector2> from_above;
	godot::Color mean; ///< Of its plants of parts, as they are seen; a: their translucency.

	int64_t seed = 0; ///< Of all variants.
	bool is_absent =
			false; ///< A substitute for an entry of the list without a species that can grow: no plant is of it.

	/// Asks the function for one variant more, at all levels, and at last how they move; main thread only, since
	/// scripts may answer. A stem that the function does not know is left to build(). Tells what is wrong and what to
	/// do, or nothing.
	godot::String sample_next(const std::vector<FieldLevel> &levels);
	/// Vertical segments at a level.
	int segments_at(const FieldLevel &level) const;
	/// Whether all variants are sampled, and how they move.
	bool is_sampled() const { return int(variants.size()) == variant_count && has_motion; }
	/// Of what was sampled, on the main thread: a thread of the pool that loads something works on other tasks
	/// meanwhile, and so could come to wait for itself.
	void load_shader() const;
	/// Solves the stem and builds what meshes of what was sampled are made of; once, on any thread.
	void build();
	/// Makes them, for about `usec`, on a thread that may (renders_on_threads()). False: there are more.
	bool make_meshes(double usec);
	/// For the mesh of one plant alone, with its own height, to be turned and scaled by `scale`, on a skeleton.
	SampledPlant sample_alone(const PlacedPlant &plant) const;
	/// The function's motion as it is now. A stem that it does not know yet is solved at once.
	void read_motion();
	/// Tells the function what building has found of its stem.
	void tell_of_stem();
	/// Its material, for plants that get a mesh of their own.
	void take_material();
	/// The root of a plant, its length and rest direction, for the simulation.
	MotionPlant to_simulate(const PlacedPlant &plant) const;
	/// The same of many, which come after what is there.
	void to_simulate(const FieldPlants &plants, std::vector<MotionPlant> &into) const;
	/// Without its scale (m).
	float height_of(const PlacedPlant &plant) const { return variant_of(plant).height * plant.height; }
	/// As it stands (m).
	float length_of(const PlacedPlant &plant) const { return height_of(plant) * plant.scale; }
	/// Whether its plants are of parts.
	bool has_parts() const { return !nearest.empty() && nearest[0].grown; }
	/// Of its variants (m).
	float mean_height() const;
	/// The farthest that the plant's mesh goes from its root, `widening` times as wide, however it bends (m): linear
	/// blend skinning moves no vertex farther than it is at rest.
	float reach_of(const PlacedPlant &plant, float widening) const;
	const FieldVariant &variant_of(const PlacedPlant &plant) const {
		return variants[size_t(plant.variant) % variants.size()];
	}

private:
	void build_meshes();
	void find_mean();
	/// All of the motion but the stem.
	void read_traits();
	void solve_stem();
	void take_stem(const std::shared_ptr<const StemConstants> &found);
};

} // namespace undergrowth
