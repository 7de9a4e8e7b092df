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

private:
	static constexpr int WAYS = 3; ///< Wider; wider along x than along z; along x = z than across.

	/// What a unit shows in each outline, were nothing before it, and how that changes.
	struct Unit {
		Outlines area = {};
		float change[OUTLINES][WAYS] = {};
		float weight[WAYS] = {};
	};

	const std::vector<WrittenUnit> &written;
	const FormBuffers &mesh;
	std::vector<Unit> units;
	struct Factor {
		float width = 1.0f;
		float aside = 0.0f;
		float aslant = 0.0f;
	};
	std::vector<Factor> factors; ///< So far.
	std::vector<glm::vec3> asides; ///< As they were written.

	void look_at(size_t number);
	void apply(size_t number, const float (&change)[WAYS]);
};

} // namespace undergrowth
