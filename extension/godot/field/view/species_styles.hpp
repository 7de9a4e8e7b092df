#pragma once

#include "field/view/field_level.hpp"
#include "field/view/field_material.hpp"
#include "motion/motion_page.hpp"
#include "placement/plants.hpp"
#include "species/plant_function.hpp"
#include "species/shared_mesh.hpp"

#include <godot_cpp/classes/shader_material.hpp>

#include <array>
#include <optional>
#include <tuple>
#include <vector>

namespace undergrowth {

/// One of several plants of a species.
struct FieldVariant {
	int64_t seed = 0; ///< A Plant3D with this seed looks the same.
	float height = 1.0f; ///< m.
};

/// Casts the shadows of the plants of parts around the cameras, in the mesh of a coarse level.
struct ShadowCaster {
	int level = -1; ///< -1: none.
	float begin = 0.0f; ///< Distance from the camera (m).
	float end = 0.0f; ///< m.
	LodDensity lod_density;

	bool operator==(const ShadowCaster &other) const {
		return std::tie(level, begin, end) == std::tie(other.level, other.begin, other.end) &&
				lod_density == other.lod_density;
	}
};

/// One species of a field: its meshes, materials and motion. Sampled on the main thread. After that, only read_motion()
/// and take_material() read the function.
struct SpeciesStyle {
	godot::Ref<PlantFunction> function;
	int variant_count = 4; ///< 1 to 64.
	/// Factor of the segments of levels that users set, or of the distances of levels by error.
	double detail = 1.0;
	float density = 0.0f; ///< Plants/m² where all species grow; 0: added plants.
	float mean_scale = 1.0f; ///< Of its plants.
	std::vector<FieldLevel> levels; ///< Those of the field, at the distances of this species.
	/// For the nearest plants, and for those beyond. None if its levels are not chosen by error: they cast shadows
	/// themselves.
	std::array<ShadowCaster, 2> casters;
	/// Cards of the species; null if its material cannot draw them or its levels are not chosen by error.
	std::shared_ptr<SharedCards> cards;
	bool takes_cards = false; ///< True if its material can draw cards.
	bool is_packed = false; ///< True if its meshes have packed vertices.
	bool has_orders = false; ///< True if a variant has a swing of each order of branches.
	godot::Ref<godot::Material> sampled_material; ///< The material for which it was sampled.
	std::vector<bool> are_carded; ///< By level: drawn with cards. Empty: none.
	std::vector<bool> have_bodies; ///< By level: solid, with bodies in place of open parts. Empty: none.
	std::vector<float> errors; ///< m, by level, of the outline; empty if its levels are not chosen by error.
	float texel = 0.0f; ///< Size of the largest texel of its cards (m).
	int closest = 0; ///< Segments of the first level in place of those of the field; 0: the same.
	float usual_triangles = 0.0f; ///< Of the first level with the segments of the field, if `closest` is set.
	std::vector<float> triangles; ///< By level, of a mesh; empty as `errors`, and for models.
	std::vector<FieldVariant> variants;
	std::vector<std::vector<SampledPlant>> samples; ///< By level and group; freed when the meshes are built.
	std::vector<std::vector<std::shared_ptr<SharedMesh>>> built; ///< By level and group, shared with other fields.
	std::vector<SampledPlant> nearest; ///< Samples of the first level, for plants that get a mesh of their own.
	std::vector<std::vector<godot::Ref<godot::ArrayMesh>>> meshes; ///< By level and group; null until created.
	/// By level, and by caster. Those of a model's further sources follow in the same order.
	std::vector<godot::Ref<godot::ShaderMaterial>> materials;
	std::vector<godot::Ref<godot::Material>> sources; ///< Of a model: the materials of its files; empty for others.
	/// Of a model, by level, group and surface of the mesh: index in `sources`.
	std::vector<std::vector<std::vector<size_t>>> surface_sources;
	MotionSpecies motion;
	bool has_motion = false; ///< True if `motion` was read.
	bool in_air = false; ///< True if the wind is given in m/s; stems use the constants for it.
	std::shared_ptr<const StemConstants> stem; ///< Equal to `motion.stem`; null under another law.
	std::optional<UnsolvedStem> unsolved_stem; ///< A stem that the function had not solved when it was sampled.
	std::shared_ptr<SharedStem> shared_stem; ///< Shared by all fields that need this stem, which is solved once.
	SolvedStem solved_stem; ///< Its solution, from build().
	std::vector<std::shared_ptr<SharedMesh>> measured; ///< Meshes of measure(), until build().
	bool is_by_error = false; ///< True: its levels are chosen by error.
	float width = 0.0f; ///< Largest distance of a mesh from its axis (m).
	/// By level, for plants of parts: area from above relative to the area from the side, of the plant (x) and of its
	/// mesh (y).
	std::vector<godot::Vector2> from_above;
	godot::Color mean; ///< Mean visible colour of its plants of parts; a: their translucency.

	int64_t seed = 0; ///< Seed of all variants.
	/// True if it substitutes a list entry that has no usable species. No plants have this style.
	bool is_absent = false;

	/// Samples one more variant of the function at all levels, and after the last one its motion. Main thread, since
	/// scripts may run. build() solves stems that the function has not solved. Returns a fault with its remedy; empty:
	/// none.
	/// `material_override`: the node's, or null.
	godot::String sample_next(const std::vector<FieldLevel> &levels, bool is_by_error,
			const godot::Ref<godot::Material> &material_override);
	/// Returns the node's material override, or the function's material if that is null.
	godot::Ref<godot::Material> drawn_material(const godot::Ref<godot::Material> &material_override) const;
	/// True if `material` cannot draw its meshes as they are: it draws cards or reads packed vertices, and the one for
	/// which they were made does not, or the other way round.
	bool needs_other_meshes(const godot::Ref<godot::Material> &material) const;
	/// Returns drawn_material(), or the material for which its meshes were made while the former needs other meshes.
	godot::Ref<godot::Material> present_material(const godot::Ref<godot::Material> &material_override) const;
	/// Measures the errors of all levels if they are chosen by error. This takes tenths of a second unless
	/// is_measured(). Any thread.
	void measure();
	/// True if measure() only reads what an earlier one found. Never waits.
	bool is_measured() const;
	/// Returns the vertical segments at a level.
	int segments_at(const FieldLevel &level) const;
	/// True if all variants and the motion are sampled.
	bool is_sampled() const { return int(variants.size()) == variant_count && has_motion; }
	/// Loads one of the shaders of the sampled plants, on the main thread. A pool thread that loads a resource runs
	/// other tasks meanwhile and could wait for itself. False if all are loaded. Drafts have no cards.
	bool load_next_shader(bool is_draft) const;
	/// Solves the stem and builds the mesh arrays of all samples, once. Any thread.
	void build();
	/// Creates meshes for about `usec` µs, on a thread that may create them (renders_on_threads()). Returns false if
	/// some are still missing.
	bool make_meshes(double usec);
	/// Returns a sample for the mesh of one plant on a skeleton: with the plant's own height, not yet turned or scaled
	/// by `scale`.
	SampledPlant sample_alone(const PlacedPlant &plant) const;
	/// Reads the function's present motion. Solves a stem that is not solved yet at once.
	void read_motion();
	/// Passes the stem that build() solved to the function.
	void send_stem();
	/// Reads the function's material, for plants that get a mesh of their own.
	void take_material();
	/// Returns root, length and rest direction of a plant, for the simulation.
	MotionPlant to_simulate(const PlacedPlant &plant) const;
	/// Appends the same for many plants.
	void to_simulate(const FieldPlants &plants, std::vector<MotionPlant> &into) const;
	/// Height without the plant's scale (m).
	float height_of(const PlacedPlant &plant) const { return variant_of(plant).height * plant.height; }
	/// Height with its scale (m).
	float length_of(const PlacedPlant &plant) const { return height_of(plant) * plant.scale; }
	/// Returns the level whose meshes a material draws.
	size_t level_of(size_t material) const;
	/// True if a material draws cards.
	bool is_carded(size_t material) const;
	/// Returns what a material draws.
	DrawnParts drawn_parts(size_t material) const;
	/// True if its vertices have the attributes of parts.
	bool has_parts() const { return !nearest.empty() && nearest[0].has_parts(); }
	/// The user's mesh of its first variant; null for other species.
	const PlantModel *model() const;
	/// True if all variants that are drawn show the same model.
	bool has_one_model() const;
	/// Number of materials for one source.
	size_t slots() const { return levels.size() + casters.size(); }
	/// Returns the material of a model's source: that of the node, of the function, or of the file.
	godot::Ref<godot::Material> source_material(
			size_t source, const godot::Ref<godot::Material> &material_override) const;
	/// Returns the material for all surfaces of a level's meshes; of a model none, because each surface has its own.
	godot::RID override_for(size_t material) const;
	/// Sets the materials of a model's surfaces.
	void set_surface_materials() const;
	/// True if a level is solid and a finer one has cards.
	bool has_cards_before(size_t level) const;
	/// Triangles of a plant at a level.
	float triangles_at(size_t level) const;
	/// Heights of its variants (m).
	std::vector<float> variant_heights() const;
	/// Mean of its variants (m).
	float mean_height() const;
	/// Returns the largest distance of the plant's mesh from its root in any pose (m), if it is `widening` times as
	/// wide. Linear blend skinning moves no vertex farther than at rest.
	float reach_of(const PlacedPlant &plant, float widening) const;
	const FieldVariant &variant_of(const PlacedPlant &plant) const {
		return variants[size_t(plant.variant) % variants.size()];
	}

private:
	void take_needs(SampledPlant &sampled, const godot::Ref<godot::Material> &material);
	void build_meshes();
	void measure_models();
	void find_sources();
	void measure_forms(size_t level, bool has_cards, std::vector<std::optional<LevelError>> &outlines);
	void measure_closest(float solid_triangles, std::vector<std::optional<LevelError>> &outlines);
	LevelLooks measure_level(size_t level, bool has_cards, std::vector<std::optional<LevelError>> &outlines);
	void measure_cards(size_t level, std::vector<std::optional<LevelError>> &outlines, bool has_bodies);
	void leave_unused();
	void find_mean();
	/// Reads all of the motion except the stem.
	void read_traits();
	void solve_stem();
	void take_stem(const std::shared_ptr<const StemConstants> &found);
};

} // namespace undergrowth
