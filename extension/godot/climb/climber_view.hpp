#pragma once

#include "climb/climber_build.hpp"
#include "motion/motion_species.hpp"

#include <godot_cpp/classes/material.hpp>
#include <godot_cpp/classes/shader_material.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <vector>

namespace undergrowth {

/// The instances that draw a climber: for each chunk a multimesh of leaves per level, and meshes of stems. Main thread.
class ClimberView {
public:
	ClimberView() = default;
	~ClimberView() { clear(); }
	ClimberView(const ClimberView &) = delete;
	ClimberView &operator=(const ClimberView &) = delete;

	/// Shows another plant. `own`: the material of the leaf's species, or null.
	void show(ClimberBuild &build, const godot::Ref<godot::Material> &own, const MotionSpecies &species);
	void clear();
	/// From the axes of growth to the world's, by body.
	void place(const std::vector<godot::Transform3D> &of_bodies);
	void set_world(const godot::RID &scenario);
	void set_visible(bool on);
	void set_layers(uint32_t mask);
	void set_casts_shadows(bool on);
	/// The object that a click in the editor selects.
	void set_owner(uint64_t object);
	/// Replaces the material of the stems; null: the default.
	void set_stem_material(const godot::Ref<godot::Material> &material);
	const godot::Ref<godot::ShaderMaterial> &leaf_material() const { return material; }
	/// Box around everything, in the axes of growth.
	const godot::AABB &box() const { return whole; }
	int instance_count() const { return int(instances.size()); }

private:
	struct Instance {
		godot::RID instance, multimesh; ///< Without a multimesh: a stem.
		int body = 0;
		bool casts_shadows = true;
	};

	std::vector<Instance> instances;
	std::vector<godot::Ref<godot::ArrayMesh>> meshes; ///< Keeps them.
	std::vector<godot::Transform3D> places;
	godot::Ref<godot::ShaderMaterial> material;
	godot::Ref<godot::Material> stem_material;
	godot::AABB whole;
	godot::RID world;
	uint64_t owner = 0;
	uint32_t layers = 1;
	bool is_visible = true;
	bool casts_shadows = true;

	void make_material(const godot::Ref<godot::Material> &own, const MotionSpecies &species);
	void add_leaves(const ClimberBuild &build, const ClimberChunk &chunk, int level);
	void add_stems(const ClimberChunk &chunk, int level);
	void add(const godot::RID &base, const godot::RID &multimesh, const ClimberChunk &chunk, float begin, float end,
			bool casts);
	void apply(const Instance &one) const;
};

} // namespace undergrowth
