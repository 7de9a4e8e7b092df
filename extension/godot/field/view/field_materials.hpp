#pragma once

#include "field/motion/field_motion.hpp"
#include "field/view/cameras.hpp"
#include "field/view/field_render_setup.hpp"
#include "field/view/motion_vectors.hpp"

#include <godot_cpp/classes/geometry_instance3d.hpp>

namespace undergrowth {

/// The materials of a field's plants: one for each species and level, because textures cannot differ between instances.
/// Creates them from the users' materials and sets their shader parameters in each frame. Main thread.
class FieldMaterials {
public:
	explicit FieldMaterials(const godot::GeometryInstance3D *field) : node(field) {}

	/// Creates missing materials in about `usec`, at least one. Returns true if none is missing. Reports a shader that
	/// does not bend, once for each style.
	bool make(FieldRenderSetup &setup, double usec) const;
	/// Stops the drawing of all instances with these materials, until bind().
	void hide(const FieldRenderSetup &setup) const;
	/// Creates missing materials and sets levels and textures in all materials.
	void bind(FieldRenderSetup &setup, const FieldMotion &motion);
	/// The same for the last style only, if all other styles are up to date.
	void bind_last(FieldRenderSetup &setup, const FieldMotion &motion);
	/// Moves all materials to `old`; instances can use them while `old` exists.
	void release(FieldRenderSetup &setup, std::vector<std::vector<godot::Ref<godot::ShaderMaterial>>> &old);
	/// Sets the field's axes in the world.
	void send_axes(const FieldRenderSetup &setup) const;
	/// Copies the users' changes to the materials of one species per call, in turns.
	void follow(const FieldRenderSetup &setup);
	/// Sets the swing clock of this frame in the levels that are drawn at these distances. The remaining levels get it
	/// when they are drawn.
	void send_swing_clock(const FieldMotion &motion, const SeenDistances &seen);
	/// True if leaves of any level swing. Without them send_swing_clock() is not needed.
	bool has_swinging(const FieldRenderSetup &setup);
	/// Sets the mean leans of species whose mean has changed visibly.
	void send_leans(const FieldRenderSetup &setup, const FieldMotion &motion);
	/// Sets the water and snow that plants show.
	void send_precipitation(const FieldRenderSetup &setup, const Precipitation &precipitation);
	/// Sets the bending shapes of stems.
	void send_stems(const FieldRenderSetup &setup);
	/// Sets what instances of prototypes show in this frame.
	void send_followers(const FieldRenderSetup &setup, const FieldMotion &motion, const godot::Transform3D &axes);

	/// Sets what the previous frame showed. `step`: length of a step (s).
	void send_before(const FieldRenderSetup &setup, const MotionVectors::Sent &before, float step);

private:
	const godot::GeometryInstance3D *node;
	size_t followed_style = 0;
	FieldMotion::Delays sent; ///< Last values sent to the current materials.
	bool has_sent = false;
	SeenDistances sent_seen;
	float sent_clock = -1.0f; ///< The same; -1: none.
	/// A material whose leaves swing. The list is compact, because each frame reads it.
	struct Swinging {
		godot::RID material;
		float nearest, farthest; ///< m: distances at which leaves swing.
		int species;
		float whole, end; ///< m: they swing fully up to one distance and not at all beyond the other.
	};
	std::vector<Swinging> swinging;
	float swings_to = 0.0f; ///< m: largest `end` in it.
	bool is_listed = false; ///< `swinging` is up to date.
	std::vector<float> sent_leans; ///< By species; empty: none.
	int frames_since_leans = 0;
	MotionVectors::Sent sent_before; ///< To the current materials.
	Precipitation sent_precipitation; ///< The same.

	void forget_sent();
	void bind_style(const SpeciesStyle &style, const FieldMotion &motion) const;
	void follow_models(const SpeciesStyle &style) const;
	void list_swinging(const FieldRenderSetup &setup);
	void send_stem(const SpeciesStyle &style) const;
	godot::Ref<godot::ShaderMaterial> make_one(const SpeciesStyle &style, size_t level) const;
};

} // namespace undergrowth
