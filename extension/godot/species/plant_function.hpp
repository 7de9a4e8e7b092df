#pragma once

#include "base/messages.hpp"
#include "form/plant_growth.hpp"
#include "form/species_growth.hpp"
#include "mesh/plant_mesh.hpp"
#include "motion/joint.hpp"
#include "plant/motion.hpp"
#include "species/plant_stem.hpp"
#include "species/sampled_plant.hpp"
#include "species/stem_table.hpp"

#include <godot_cpp/classes/array_mesh.hpp>
#include <godot_cpp/classes/material.hpp>
#include <godot_cpp/classes/random_number_generator.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/gdvirtual.gen.inc>

#include <optional>

namespace undergrowth {

/// A species: four functions of a plant (thesis, section 2.5) and its motion. A script overrides the methods with an
/// underscore. A native species overrides the four `own_…` methods.
class PlantFunction : public godot::Resource {
	GDCLASS(PlantFunction, godot::Resource)

public:
	enum MotionLaw : int64_t {
		LAW_ELASTICITY = int(Law::elasticity),
		LAW_SPRING = int(Law::spring),
		LAW_STEM = int(Law::stem),
	};
	enum ShadingMode : int64_t {
		SHADING_SMOOTH = int(Shading::smooth),
		SHADING_FLAT = int(Shading::flat),
	};

private:
	Motion motion = new_motion();
	double lean = 0.0; // rad, as the user set it; motion.lean has fewer digits.
	MeshOptions mesh_options;
	bool stays_above_ground = true;
	bool changes_motion_only = false;
	bool changes_material_only = false;
	godot::Ref<godot::Material> material;
	bool has_stem = true;
	godot::Array arrangements; // Of PlantArrangement.
	godot::Ref<PlantStem> stem;
	StemTable stems;
	godot::String reported_stem_fault; // Last reported fault of a stem.
	SpeciesGrowth growth;

	/// Returns the default motion.
	static Motion new_motion();
	void set_motion(float &slot, const char *property, double value, const Range &range);
	void motion_changed();
	void set_mesh_option(float &slot, const char *property, double value);
	/// Calls a script's override. Sets `problem` if the result is not of type `wanted`.
	godot::Variant call_override(const godot::StringName &method, const godot::Variant &argument,
			godot::Variant::Type wanted, godot::String &problem);
	void learn_stem(double height);
	void report_fault(const godot::String &problem) const;

protected:
	static void _bind_methods();
	void _validate_property(godot::PropertyInfo &property) const;

	/// Copies a species' motion, without a signal. For constructors.
	void adopt_motion(const Motion &species_motion);
	/// Reports to users of this function that its meshes changed.
	void shape_changed();

	/// sample() without what all species have in common. Main thread.
	virtual godot::String sample_shape(double height, int segments, int64_t seed, SampledPlant &result);
	virtual godot::PackedVector3Array own_base_shape(int lod) const;
	virtual double own_height(const godot::Ref<godot::RandomNumberGenerator> &rng) const;
	virtual double own_curve_point(double offset) const;
	virtual godot::Color own_color(double offset) const;

	GDVIRTUAL1R(godot::PackedVector3Array, _get_base_shape, int)
	GDVIRTUAL1R(double, _generate_height, godot::Ref<godot::RandomNumberGenerator>)
	GDVIRTUAL1R(double, _calculate_curve_point, double)
	GDVIRTUAL1R(godot::Color, _calculate_color_at_point, double)
	GDVIRTUAL1(_grow, godot::Ref<PlantGrowth>)

public:
	/// True if the plants consist of parts and not of the one lathe of the four functions.
	virtual bool has_parts() const;
	// The four functions, as callers see them. A fault in a script is reported and gives an empty or zero result.
	godot::PackedVector3Array get_base_shape(int lod);
	double generate_height(const godot::Ref<godot::RandomNumberGenerator> &rng);
	double calculate_curve_point(double offset);
	godot::Color calculate_color_at_point(double offset);
	godot::Ref<godot::ArrayMesh> generate_mesh(double height, int segments, int64_t seed = 0);

	/// Returns why generate_mesh() cannot build this plant and what to do; empty if it can. Reports nothing.
	godot::String find_problem(double height, int segments, int64_t seed = 0);

	/// Samples the plant for a mesh. If `height` is 0, the function generates it. Returns what is wrong and what to do,
	/// or an empty string.
	godot::String sample(double height, int segments, int64_t seed, SampledPlant &result);
	/// Returns the cards of a species of parts (form/shared_cards.hpp). Null if its plants cannot grow, and of species
	/// with a script, which would grow one plant more.
	std::shared_ptr<SharedCards> find_cards();
	// The functions for sampling: results of a script, or else of the native species. On a fault they set `problem`
	// (what is wrong and what to do) and return an empty or zero result.
	godot::PackedVector3Array call_base_shape(int lod, godot::String &problem);
	double call_height(const godot::Ref<godot::RandomNumberGenerator> &rng, godot::String &problem);
	double call_curve_point(double offset, godot::String &problem);
	godot::Color call_color(double offset, godot::String &problem);
	/// Grows `plant`. Returns true if a script grows it.
	bool call_grow(const godot::Ref<PlantGrowth> &plant, godot::String &problem);
	/// Returns the joint of a plant with the root axes `frame` (up axis and turn, orthonormal). Its length is not set.
	Joint make_joint(const godot::Basis &frame) const;
	/// Returns the rest bend of a plant along its node, in its own axes (motion/bend_encoding.hpp).
	glm::vec2 resting_bend() const;
	/// Returns the stem of a plant of `height` metres; null under other laws than the stem law. Reports the fault of a
	/// stem once.
	std::shared_ptr<const StemConstants> find_stem(double height, bool in_air);
	/// Returns the recipe if the stem is not solved. To solve it on another thread, pass the result to take_stem()
	/// before the next use of the stem.
	std::optional<UnsolvedStem> describe_stem(double height);
	void take_stem(const UnsolvedStem &unsolved, const SolvedStem &found);
	/// True while `changed` is emitted for a property that does not affect meshes. Setters emit it once for each real
	/// change, never for the present value.
	bool is_motion_change() const;
	/// True while `changed` is emitted for another material, which does not affect meshes either.
	bool is_material_change() const { return changes_material_only; }

	// Called by the engine.
	void on_arrangement_changed();
	void on_own_change();
	void on_grown_change();
	void on_stem_changed();

	void set_has_stem(bool grows);
	bool get_has_stem() const { return has_stem; }
	void set_arrangements(const godot::TypedArray<PlantArrangement> &list);
	godot::TypedArray<PlantArrangement> get_arrangements() const;
	void set_law(MotionLaw law);
	MotionLaw get_law() const;
	void set_elasticity(double value);
	double get_elasticity() const;
	void set_inner_friction(double value);
	double get_inner_friction() const;
	void set_stays_above_ground(bool value);
	bool get_stays_above_ground() const;
	void set_natural_frequency(double hertz);
	double get_natural_frequency() const;
	void set_frequency_height(double metres);
	double get_frequency_height() const;
	void set_frequency_deviation(double deviation);
	double get_frequency_deviation() const;
	void set_damping_ratio(double ratio);
	double get_damping_ratio() const;
	void set_lean(double radians);
	double get_lean() const;
	void set_stem(const godot::Ref<PlantStem> &new_stem);
	godot::Ref<PlantStem> get_stem() const { return stem; }
	void set_mass(double kilograms);
	double get_mass() const;
	void set_wind_weight(double weight);
	double get_wind_weight() const;
	void set_drag_area(double square_metres);
	double get_drag_area() const;
	void set_collision_radius(double metres);
	double get_collision_radius() const;
	void set_trampling(double share);
	double get_trampling() const;
	void set_recovery_time(double seconds);
	double get_recovery_time() const;
	void set_lodging_angle(double radians);
	double get_lodging_angle() const;
	/// For the simulation.
	Trampling make_trampling() const;
	void set_shading(ShadingMode shading);
	ShadingMode get_shading() const;
	void set_shape_deviation(double deviation);
	double get_shape_deviation() const;
	void set_color_deviation(double deviation);
	double get_color_deviation() const;
	void set_material(const godot::Ref<godot::Material> &new_material);
	godot::Ref<godot::Material> get_material() const;
};

} // namespace undergrowth

VARIANT_ENUM_CAST(undergrowth::PlantFunction::MotionLaw);
VARIANT_ENUM_CAST(undergrowth::PlantFunction::ShadingMode);
