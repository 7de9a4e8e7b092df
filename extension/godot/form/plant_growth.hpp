#pragma once

#include "form/growth.hpp"
#include "form/plant_arrangement.hpp"

#include <godot_cpp/classes/random_number_generator.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace undergrowth {

class PlantFunction;

/// One plant during its growth: a script's `_grow` adds its parts. Calls after the end of the growth are errors. The
/// first error ends the growth; all further calls have no effect.
class PlantGrowth : public godot::RefCounted {
	GDCLASS(PlantGrowth, godot::RefCounted)

	PlantFunction *species = nullptr; // Null after the growth.
	std::unique_ptr<Growth> growth;
	double height = 1.0; // m.
	godot::Ref<godot::RandomNumberGenerator> rng;
	std::vector<std::pair<uint64_t, int>> kinds; // By the instance ids of PlantParts.
	int stem = ON_GROUND;
	godot::String problem;

	bool may_grow();
	bool find_kind(const godot::Ref<PlantPart> &part, int &kind);
	godot::PackedInt32Array place(const godot::Ref<PlantPart> &part, Arrangement arrangement,
			const godot::PackedInt32Array &on, const godot::Dictionary &options);

protected:
	static void _bind_methods();

public:
	/// Begins a plant of `function`. For C++.
	void begin(PlantFunction *function, double metres, uint64_t seed);
	/// Ends the growth. Returns the plant, or sets `what` to the problem.
	PlantForm finish(godot::String &what);

	double get_height() const { return height; }
	godot::Ref<godot::RandomNumberGenerator> get_rng() const { return rng; }
	godot::PackedInt32Array get_ground() const;
	godot::PackedInt32Array add_stem();
	godot::PackedInt32Array add(
			const godot::Ref<PlantPart> &part, const godot::PackedInt32Array &on, const godot::Dictionary &options);
	godot::PackedInt32Array along(const godot::Ref<PlantPart> &part, const godot::PackedInt32Array &on, int count,
			const godot::Dictionary &options);
	godot::PackedInt32Array whorl(const godot::Ref<PlantPart> &part, const godot::PackedInt32Array &on, int count,
			const godot::Dictionary &options);
	godot::PackedInt32Array disc(const godot::Ref<PlantPart> &part, const godot::PackedInt32Array &on, int count,
			const godot::Dictionary &options);
	godot::PackedInt32Array scatter(const godot::Ref<PlantPart> &part, int count, const godot::Dictionary &options);
	/// Grows a list of arrangements: those with the layout `ground` on the ground, all other ones on the stem.
	void arrange(const godot::TypedArray<PlantArrangement> &arrangements);
};

} // namespace undergrowth
