#pragma once

#include "mesh/form_match.hpp"

namespace undergrowth {

/// Changes the widths of units step by step so that a mesh's outlines become others. Each unit may grow wider, along
/// the ground wider one way than across, and turn about its midrib: four numbers a unit, four outlines to meet. Of all
/// ways to meet them it takes the one that changes least (the least norm, weighed by the units' areas).
class OutlineFit {
public:
	OutlineFit(const std::vector<WrittenUnit> &units, const FormBuffers &mesh);

	/// One step: the outlines are `areas` and are to be `wanted`. As if what hides behind other units went on hiding
	/// behind them; nothing turns.
	void approach(const Outlines &areas, const Outlines &wanted);
	/// From now on widths may differ more from what was written, but for those of flowers.
	void loosen() { limits = LOOSE; }
	/// Remembers the widths of the last step.
	void keep();
	/// Gives the mesh the widths that were remembered, or those that it began with.
	void finish();

	/// Looks at what each number does to the outlines and goes the best way (Levenberg 1944), round by round, from the
	/// widths that were remembered, until no outline is off by more than `goal` or nothing mends more; ends as finish()
	/// does. `worst`: how far the worst outline is off, in and out. Looks at the mesh 5 to 32 times a round and as
	/// often as its size allows, 120 to 1200 times.
	void search(const SightBox &box, const Outlines &wanted, float goal, float &worst);

private:
	static constexpr size_t WAYS = 4; ///< Wider; wider along x than along z; along x = z than across; turned.
	static constexpr size_t STRETCHES = 3; ///< Of these.
	static constexpr size_t TURN = 3; ///< The tangent of half the angle.
	static constexpr size_t MOST_BUNDLES = 8;
	using Ways = std::array<float, WAYS>;
	/// Of widths, in shares of what was written.
	struct Limits {
		float least, most, turned;
		float least_flower, most_flower, turned_flower;
		bool by_width; ///< What is turned counts in shares of the width that it has come to.
	};
	static constexpr Limits USUAL = { 0.25f, 4.0f, 0.7f, 0.45f, 1.7f, 0.25f, false };
	static constexpr Limits LOOSE = { 0.2f, 6.0f, 0.85f, 0.45f, 1.7f, 0.25f, true };

	/// What a unit shows in each outline, were nothing before it, as it was written, and how its widths change that.
	struct Unit {
		Outlines area = {};
		std::array<std::array<float, STRETCHES>, OUTLINES> change = {};
		Ways weight = {}; ///< How willingly it changes.
		Ways widths = {}; ///< So far, beyond what was written.
		Ways kept = {};
		size_t bundle = 0; ///< Units that a search changes together.
	};

	const std::vector<WrittenUnit> &written;
	const FormBuffers &mesh;
	std::vector<Unit> units;
	std::vector<glm::vec3> asides; ///< As they were written.
	Limits limits = USUAL;

	void look_at(size_t number);
	void limit(size_t number, Ways &widths) const;
	void apply(size_t number, const Ways &widths);

	struct Sought;
	size_t bundle();
	std::vector<float> bundle_weights(size_t bundles) const;
	Outlines look(Sought &sought) const;
	void probe(Sought &sought, const Outlines &errors);
	bool step(Sought &sought, Outlines &errors);
	void go_on(Sought &sought, float goal, float &worst);
	void turn_normals();
	void place(const Sought &sought, std::vector<float> &changes);
};

/// A turn about the upright axis by the tangent of half its angle, which takes no sine.
struct HalfTurn {
	float cosine, sine;

	explicit HalfTurn(float half) :
			cosine((1.0f - half * half) / (1.0f + half * half)), sine(2.0f * half / (1.0f + half * half)) {}
	glm::vec3 of(const glm::vec3 &way) const {
		return { cosine * way.x - sine * way.z, way.y, sine * way.x + cosine * way.z };
	}
};

/// Solves a·x = b for a symmetric positive matrix, by Cholesky's parts; x is left in b.
void solve_outlines(float (&a)[OUTLINES][OUTLINES], float (&b)[OUTLINES]);

} // namespace undergrowth
