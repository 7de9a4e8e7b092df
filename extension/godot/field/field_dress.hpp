#pragma once

#include "field/eyes.hpp"
#include "field/field_motion.hpp"
#include "field/field_style.hpp"

#include <godot_cpp/classes/geometry_instance3d.hpp>

namespace undergrowth {

/// The materials of a field's plants: one for each species and level, because textures cannot differ between instances.
/// Creates them from the users' materials and sets their shader parameters in each frame. Main thread.
class FieldDress {
public:
	explicit FieldDress(const godot::GeometryInstance3D *field) : node(field) {}

	/// Creates missing materials. Reports a shader that does not bend, once for each look.
	void make(FieldStyle &style) const;
	/// Stops the drawing of all instances with these materials, until put_on().
	void take_away(const FieldStyle &style) const;
	/// Creates missing materials and sets levels and textures in all materials.
	void put_on(FieldStyle &style, const FieldMotion &motion);
	/// The same for the last look only, if all other looks are up to date.
	void put_on_last(FieldStyle &style, const FieldMotion &motion);
	/// Moves all materials to `old`; instances can use them while `old` exists.
	void take_off(FieldStyle &style, std::vector<std::vector<godot::Ref<godot::ShaderMaterial>>> &old) const;
	/// Sets the orientation of the field's axes in the world.
	void tell_of_axes(const FieldStyle &style) const;
	/// Copies the users' changes to the materials of one species per call, in turns.
	void follow(const FieldStyle &style);
	/// Sets the swing clock of this frame in the levels that are drawn at these distances. The remaining levels get it
	/// when they are drawn.
	void tell_of_swings(const FieldStyle &style, const FieldMotion &motion, const SeenDistances &seen);
	/// Sets the bending shapes of stems.
	void tell_of_stems(const FieldStyle &style) const;
	/// Sets what instances of prototypes show in this frame.
	void tell_of_followers(const FieldStyle &style, const FieldMotion &motion, const godot::Transform3D &axes);

private:
	const godot::GeometryInstance3D *node;
	size_t followed_look = 0;
	FieldMotion::Delays sent; ///< Last values sent to the current materials.
	bool has_sent = false;
	SeenDistances sent_seen;
	float sent_clock = -1.0f; ///< The same; -1: none.

	void put_on_look(const FieldLook &look, const FieldMotion &motion) const;
	void tell_of_stem(const FieldLook &look) const;
	godot::Ref<godot::Material> worn(const FieldLook &look) const;
};

} // namespace undergrowth
