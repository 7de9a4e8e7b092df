#pragma once

#include "field/motion/field_motion.hpp"
#include "field/resources/field_options.hpp"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

namespace undergrowth {

/// The faults of a field. Reports each one once in the log, with the node's name, and lists present ones as
/// configuration warnings of the node. Main thread.
class FieldProblems {
public:
	FieldProblems(godot::Node *of, const FieldProperties &set_by_users) : node(of), properties(set_by_users) {}

	/// Sets why it cannot be built; empty: no fault.
	void report(const godot::String &what);
	bool has_fault() const { return !fault.is_empty(); }
	/// Sets what to check if no plant found ground; empty: some did.
	void advise(const godot::String &what);
	/// Reports contact and bodies that do not work as configured.
	void report_motion(FieldMotion &motion);
	/// Returns all present faults, including those of properties.
	godot::PackedStringArray warnings() const;

private:
	godot::Node *node;
	const FieldProperties &properties;
	godot::String fault;
	godot::String no_ground;
	bool has_reported_crowd = false;
};

} // namespace undergrowth
