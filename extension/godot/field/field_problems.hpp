#pragma once

#include "field/motion/field_motion.hpp"
#include "field/resources/field_options.hpp"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

namespace undergrowth {

/// Owns the errors and warnings of a field. Prints each one once to the log, with the node's name, and lists the
/// present ones as configuration warnings of the node. Main thread.
class FieldProblems {
public:
	FieldProblems(godot::Node *of, const FieldProperties &set_by_users) : node(of), properties(set_by_users) {}

	/// Sets the reason why the field cannot be built, with its remedy, and prints it as an error if it is new. Empty:
	/// the field can be built.
	void report(const godot::String &what);
	bool has_fault() const { return !fault.is_empty(); }
	/// Sets advice for a field whose plants found no ground, as a configuration warning. Empty: some plants found
	/// ground.
	void advise(const godot::String &what);
	/// Sets advice of the editor's plugin on the field's place, as a configuration warning. Empty: none.
	void advise_on_place(const godot::String &what);
	/// Prints warnings about contact and bodies: once if contacts are skipped because too many tips are close together,
	/// and once for each body that cannot push.
	void report_motion(FieldMotion &motion);
	/// Returns the present errors and advice, and warnings about combinations of properties.
	godot::PackedStringArray warnings() const;

private:
	godot::Node *node;
	const FieldProperties &properties;
	godot::String fault;
	godot::String no_ground;
	godot::String off_ground;
	bool has_reported_crowd = false;
};

} // namespace undergrowth
