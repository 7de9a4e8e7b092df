#pragma once

#include "mesh/form_match.hpp"

namespace undergrowth {

/// Fits the outlines of a mesh to given ones, step by step, by changing the widths of units. Each unit can grow wider,
/// grow more along than across one of two horizontal directions, and turn about its midrib: four numbers per unit for
/// four outlines. Selects the smallest change (the least norm, weighted by the units' areas).
class OutlineFit {
public:
	OutlineFit(const std::vector<WrittenUnit> &units, const FormBuffers &mesh);

	/// One step from outlines `areas` to `wanted`. Assumes that occlusion does not change; does not turn units.
	void approach(const Outlines &areas, const Outlines &wanted);
	/// Permits larger changes of widths, except for flowers.
	void detach() { limits = LOOSE; }
	/// Saves the widths of the last step.
	void keep();
	/// Sets the mesh to the saved widths, or to the initial ones if none were saved.
	void finish();

	/// Measures the effect of each number on the outlines and takes the best direction (Levenberg 1944), round by
	/// round, from the saved widths. Stops when no outline is off by more than `goal` or nothing improves; then does
	/// the same as finish(). `worst`: error of the worst outline, in and out. Measures the mesh 5 to 32 times per round
	/// and 120 to 1200 times in total, by its size.
	void search(const SightBox &box, const Outlines &wanted, float goal, float &worst);

private:
	static constexpr size_t WAYS = 4; ///< Wider; wider along x than z; wider along x = z than across; turned.
	static constexpr size_t STRETCHES = 3; ///< The first three of them.
	static constexpr size_t TURN = 3; ///< Index of the turn: the tangent of half its angle.
	static constexpr size_t MAX_BUNDLES = 8;
	using Ways = std::array<float, WAYS>;
	/// Limits of widths, relative to the written ones.
	struct Limits {
		float min, max, turned;
		float min_flower, max_flower, turned_flower;
		bool by_width; ///< True: turns count relative to the present width.
	};
	static constexpr Limits USUAL = { 0.25f, 4.0f, 0.7f, 0.45f, 1.7f, 0.25f, false };
	static constexpr Limits LOOSE = { 0.2f, 6.0f, 0.85f, 0.45f, 1.7f, 0.25f, true };

	/// Area of a unit in each outline as written, without occlusion, and its change by the unit's widths.
	struct Unit {
		Outlines area = {};
		std::array<std::array<float, STRETCHES>, OUTLINES> change = {};
		Ways weight = {}; ///< Weight of a change: larger changes more.
		Ways widths = {}; ///< Present changes, relative to what was written.
		Ways saved = {};
		size_t bundle = 0; ///< Number of the group of units that a search changes together.
	};

	const std::vector<WrittenUnit> &written;
	const FormBuffers &mesh;
	std::vector<Unit> units;
	std::vector<glm::vec3> asides; ///< Their initial values.
	Limits limits = USUAL;

	void look_at(size_t number);
	void limit(size_t number, Ways &widths) const;
	void apply(size_t number, const Ways &widths);

	struct Sought;
	size_t bundle();
	std::vector<float> bundle_weights(size_t bundles) const;
	Outlines evaluate(Sought &sought) const;
	void probe(Sought &sought, const Outlines &errors);
	bool step(Sought &sought, Outlines &errors);
	void go_on(Sought &sought, float goal, float &worst);
	void turn_normals();
	void place(const Sought &sought, std::vector<float> &changes);
};

/// A rotation about the vertical axis by the tangent of half its angle; needs no sine.
struct HalfTurn {
	float cosine, sine;

	explicit HalfTurn(float half) :
			cosine((1.0f - half * half) / (1.0f + half * half)), sine(2.0f * half / (1.0f + half * half)) {}
	glm::vec3 of(const glm::vec3 &way) const {
		return { cosine * way.x - sine * way.z, way.y, sine * way.x + cosine * way.z };
	}
};

/// Solves a·x = b for a symmetric positive matrix by Cholesky decomposition; x replaces b.
void solve_outlines(float (&a)[OUTLINES][OUTLINES], float (&b)[OUTLINES]);

} // namespace undergrowth
