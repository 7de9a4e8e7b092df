#pragma once

#include "form/plant_form.hpp"

#include <string>
#include <vector>

namespace undergrowth {

/// Grows one plant, part by part: once per seed, not per level of detail. Functions that return a string return the
/// error and its remedy, and then add nothing. An empty string is success.
class Growth {
public:
	/// `height`: m, of the stem that add_stem() grows, > 0.
	Growth(float height, uint64_t seed);

	/// Adds the upright stem of a plant's four functions; at most one per form. `part` says how it moves; sizes and
	/// colours come from the functions.
	std::string add_stem(const Part &part, int &handle);
	/// Registers a kind of part, for any number of arrangements.
	std::string add_kind(const Part &part, int &kind);
	/// Adds parts of a kind on each of the carriers (handles, or ON_GROUND), and their handles to `handles`.
	std::string arrange(
			int kind, const Arrangement &arrangement, const std::vector<int> &carriers, std::vector<int> &handles);

	const PlantForm &form() const { return grown; }
	/// Returns the grown plant. Without a stem its height is that of its highest part.
	PlantForm finish();

private:
	PlantForm grown;
	std::vector<Midrib::Family> families; ///< By kind.
	uint64_t seed;

	std::string find_carrier_fault(const std::vector<int> &carriers) const;
	std::string find_count_fault(const Arrangement &arrangement, const std::vector<int> &carriers, int &depth) const;
	int depth_of(int handle) const;
	int add_group(int kind, const Arrangement &arrangement, const std::vector<int> &carriers, int depth);
	void place_on(int group, const Arrangement &arrangement, int carrier, std::vector<int> &handles);
	void find_rods();
	void place(int group, const Arrangement &arrangement, int carrier, const Seat &seat, uint64_t own_seed);
};

/// An arrangement and what it places, one line of a species without code.
struct RecipeLine {
	int kind = 0; ///< Index in Recipe::kinds.
	Arrangement arrangement;
	int on = ON_GROUND; ///< Earlier line whose parts carry these; ON_GROUND: the stem if there is one, else
						///< the ground.
};

/// A species without code, from its `arrangements`.
struct Recipe {
	std::vector<Part> kinds;
	std::vector<RecipeLine> lines;
};

/// Why a recipe cannot grow with any seed; empty if it can.
std::string find_recipe_fault(const Recipe &recipe, bool has_stem);

/// Grows it. `stem`: a handle, or ON_GROUND.
std::string grow(const Recipe &recipe, int stem, Growth &growth);

} // namespace undergrowth
