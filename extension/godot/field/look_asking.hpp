#pragma once

#include "field/field_recipe.hpp"

#include <cstdint>
#include <vector>

namespace undergrowth {

/// Asks scripts what plants of a field look like, on the main thread. Those that take long are asked over some frames.
class LookAsking {
public:
	/// `fills`: plants are placed once it is known.
	explicit LookAsking(bool fills) : places(fills) {}

	const bool places;
	/// What is known by now: all of it once go_on() is done. Without meshes.
	FieldStyle style;

	/// Lists what is to be asked: species that are listed, and others, whose plants code added. `range`: how far
	/// the node is seen, and how finely. Tells what is wrong and what to do about it, or nothing; so does go_on(),
	/// which takes about `usec`.
	godot::String begin(const FieldProperties &properties, const SightRange &range, std::vector<FieldLook> &&others);
	/// Whether nothing was asked in this frame yet.
	bool is_due() const;
	godot::String go_on(double usec, bool &is_done);
	/// Whether these others are those that it began with.
	bool knows(const std::vector<FieldLook> &others) const;

private:
	uint64_t frame = 0; ///< In which some were asked.
};

} // namespace undergrowth
