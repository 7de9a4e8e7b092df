#pragma once

#include "field/field_motion.hpp"
#include "field/field_options.hpp"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

namespace undergrowth {

/// What is amiss with a field, as its users hear of it: once in the log, with its node's name, and as long as it is so
/// among the node's configuration warnings. Main thread.
class FieldProblems {
public:
	FieldProblems(godot::Node *of, const FieldProperties &set_by_users) : node(of), properties(set_by_users) {}

	/// Why it cannot grow; empty: it can.
	void report(const godot::String &what);
	bool has_fault() const { return !fault.is_empty(); }
	/// What to check where nobody found any ground; empty: somebody has.
	void advise(const godot::String &what);
	/// What cannot push or touch as it is meant to.
	void tell_of(FieldMotion &motion);
	/// All that is amiss now, in what users set, too.
	godot::PackedStringArray warnings() const;

private:
	godot::Node *node;
	const FieldProperties &properties;
	godot::String fault;
	godot::String no_ground;
	bool has_told_of_crowd = false;
};

} // namespace undergrowth
