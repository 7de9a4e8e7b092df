#pragma once

#include "field/eyes.hpp"
#include "field/field_motion.hpp"
#include "field/field_style.hpp"

#include <godot_cpp/classes/geometry_instance3d.hpp>

namespace undergrowth {

/// The materials that a field's plants wear: one for each species and level, since textures cannot differ by instance,
/// made from what users set, and what the shaders are told in each frame. Main thread.
class FieldDress {
public:
	explicit FieldDress(const godot::GeometryInstance3D *field) : node(field) {}

	/// Makes the materials that are missing. A shader that does not bend is told of, once for each look.
	void make(FieldStyle &style) const;
	/// What wears its materials is not drawn, until put_on().
	void take_away(const FieldStyle &style) const;
	/// Makes the materials that are missing, and tells all of levels and textures.
	void put_on(FieldStyle &style, const FieldMotion &motion);
	/// The same of the last look only: the others are up to date.
	void put_on_last(FieldStyle &style, const FieldMotion &motion);
	/// Forgets the materials; what was worn goes on with whoever holds `old`.
	void take_off(FieldStyle &style, std::vector<std::vector<godot::Ref<godot::ShaderMaterial>>> &old) const;
	/// Which way the field's axes point in the world.
	void tell_of_axes(const FieldStyle &style) const;
	/// One species' materials follow what their user changed in them, in turns.
	void follow(const FieldStyle &style);
	/// The clock that parts swing by, in this frame, where plants are seen from these distances. Levels that are not
	/// drawn there get it when they are.
	void tell_of_swings(const FieldStyle &style, const FieldMotion &motion, const SeenDistances &seen);
	/// How stems bend along their length.
	void tell_of_stems(const FieldStyle &style) const;
	/// Where followers of prototypes find what they show in this frame.
	void tell_of_followers(const FieldStyle &style, const FieldMotion &motion, const godot::Transform3D &axes);

private:
	const godot::GeometryInstance3D *node;
	size_t followed_look = 0;
	FieldMotion::Delays sent; ///< To the materials that are worn, if any.
	bool has_sent = false;
	SeenDistances sent_seen;
	float sent_clock = -1.0f; ///< To the same; -1: none.

	void put_on_look(const FieldStyle &style, const FieldLook &look, const FieldMotion &motion) const;
	void tell_of_stem(const FieldLook &look) const;
	godot::Ref<godot::Material> worn(const FieldLook &look) const;
};

} // namespace undergrowth
