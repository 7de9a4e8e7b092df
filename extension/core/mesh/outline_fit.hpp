#pragma once

#include "mesh/form_match.hpp"

namespace undergrowth {

/// Changes the widths of units step by step so that a mesh's outlines become others. Each unit may grow wider and,
/// along the ground, wider one way than across: three numbers a unit, four outlines to meet. Of all ways to meet them
/// it takes the one that changes least (the least norm, weighed by the units' areas).
class OutlineFit {
public:
	OutlineFit(const std::vector<WrittenUnit> &units, const FormBuffers &mesh);

	/// One step: the outlines are `areas` and are to be `wanted`.
	void approach(const Outlines &areas, const Outlines &wanted);
	/// From now on widths may differ more from what was written, but for those of flowers.
	void loosen() { limits = LOOSE; }
	/// Remembers the widths of the last step.
	void keep();
	/// Gives the mesh the widths that were remembered, or those that it began with.
	void finish();

private:
	static constexpr int WAYS = 3; ///< Wider; wider along x than along z; along x = z than across.
	using Ways = std::array<float, WAYS>;
	/// Of widths, in shares of what was written.
	struct Limits {
		float least, most, turned;
		float least_flower, most_flower, turned_flower;
	};
	static constexpr Limits USUAL = { 0.25f, 4.0f, 0.7f, 0.45f, 1.7f, 0.25f };
	static constexpr Limits LOOSE = { 0.2f, 4.5f, 0.85f, 0.45f, 1.7f, 0.25f };

	/// What a unit shows in each outline, were nothing before it, as it was written, and how its widths change that.
	struct Unit {
		Outlines area = {};
		std::array<Ways, OUTLINES> change = {};
		Ways weight = {}; ///< How willingly it changes.
		Ways widths = {}; ///< So far, beyond what was written.
		Ways kept = {};
	};

	const std::vector<WrittenUnit> &written;
	const FormBuffers &mesh;
	std::vector<Unit> units;
	std::vector<glm::vec3> asides; ///< As they were written.
	Limits limits = USUAL;

	void look_at(size_t number);
	void apply(size_t number, const Ways &widths);
};

} // namespace undergrowth
