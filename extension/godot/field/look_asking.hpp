#pragma once

#include "field/field_recipe.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace undergrowth {

/// Asks scripts what plants of a field look like, on the main thread. Those that take long are asked over some frames.
class LookAsking {
public:
	/// `fills`: plants are placed once it is known. `with_plants`: species that must not become absent by a fault.
	LookAsking(bool fills, std::vector<godot::Ref<PlantFunction>> &&with_plants) :
			places(fills), standing(std::move(with_plants)) {}

	const bool places;
	/// What is known by now: all of it once go_on() is done. Without meshes.
	FieldStyle style;

	/// Lists what is to be asked: species that are listed, and others, whose plants code added. `range`: how far
	/// the node is seen, and how finely. Tells what is wrong and what to do about it, or nothing; so does go_on(),
	/// which takes about `usec`.
	godot::String begin(const godot::Node *field, const FieldProperties &properties, const SightRange &range,
			std::vector<FieldLook> &&others);
	/// Whether nothing was asked in this frame yet.
	bool is_due() const;
	godot::String go_on(double usec, bool &is_done);
	/// Whether these others are those that it began with.
	bool knows(const std::vector<FieldLook> &others) const;

private:
	std::vector<godot::Ref<PlantFunction>> standing;
	uint64_t frame = 0; ///< In which some were asked.
};

} // namespace undergrowth
