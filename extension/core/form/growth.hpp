#pragma once

#include "form/plant_form.hpp"

#include <string>
#include <vector>

namespace undergrowth {

/// Grows one plant, part by part. Once per seed, never per level of detail. Every answer that begins with a String
/// tells what is wrong and what to do; then nothing has grown. Empty: it has grown.
class Growth {
public:
	/// `height`: m, of the stem that add_stem() grows, > 0.
	Growth(float height, uint64_t seed);

	/// The upright stem of a plant's four functions; of a form at most one. `kind` says how it moves; its own sizes and
	/// colours are those of the functions.
	std::string add_stem(const Part &part, int &handle);
	/// Makes a kind of part known; any number of arrangements may use it.
	std::string add_kind(const Part &part, int &kind);
	/// Parts of a kind on each of the carriers, which are handles or ON_GROUND; adds their handles to `handles`.
	std::string arrange(
			int kind, const Arrangement &arrangement, const std::vector<int> &carriers, std::vector<int> &handles);

	const PlantForm &form() const { return grown; }
	/// The grown plant: the height of one without a stem is that of its highest part.
	PlantForm finish();

private:
	PlantForm grown;
	uint64_t seed;

	std::string find_carrier_fault(const std::vector<int> &carriers) const;
	std::string find_count_fault(const Arrangement &arrangement, const std::vector<int> &carriers, int &depth) const;
	int depth_of(int handle) const;
	int add_group(int kind, const Arrangement &arrangement, const std::vector<int> &carriers, int depth);
	void place_on(int group, const Arrangement &arrangement, int carrier, std::vector<int> &handles);
	void place(int group, const Arrangement &arrangement, int carrier, const Seat &seat, uint64_t own_seed);
};

/// An arrangement and what it places, one line of a species without code.
struct RecipeLine {
	int kind = 0; ///< Index in Recipe::kinds.
	Arrangement arrangement;
	int on = ON_GROUND; ///< The line whose parts carry these, before this line; ON_GROUND: the stem, if there is one,
						///< or the ground.
};

/// A species without code: what its `arrangements` say.
struct Recipe {
	std::vector<Part> kinds;
	std::vector<RecipeLine> lines;
};

/// What keeps a recipe from growing on any seed, found beforehand; empty where it grows.
std::string find_recipe_fault(const Recipe &recipe, bool has_stem);

/// Grows it. `stem`: a handle, or ON_GROUND.
std::string grow(const Recipe &recipe, int stem, Growth &growth);

} // namespace undergrowth
