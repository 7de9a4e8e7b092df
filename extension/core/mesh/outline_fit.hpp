#pragma once

#include "mesh/form_match.hpp"

namespace undergrowth {

/// Changes the widths of units step by step until a mesh's outlines match given areas. Each unit can grow wider, grow
/// wider along the ground in one direction than across it, and turn about its midrib: four numbers per unit for four
/// outlines. Of all solutions it uses the one with the least change (the least norm, weighted by the units' areas).
class OutlineFit {
public:
	OutlineFit(const std::vector<WrittenUnit> &units, const FormBuffers &mesh);

	/// Runs one step from outlines of `areas` towards those of `wanted`. It assumes that the hidden part of each unit
	/// stays hidden. Nothing turns.
	void approach(const Outlines &areas, const Outlines &wanted);
	/// Allows larger changes of widths from now on, except for flowers.
	void loosen() { limits = LOOSE; }
	/// Stores the widths of the last step.
	void keep();
	/// Restores the stored widths, or the initial ones, in the mesh.
	void finish();

	/// Measures the effect of each number on the outlines and steps in the best direction (Levenberg 1944), round by
	/// round. It starts from the stored widths and stops when no outline is off by more than `goal` or nothing
	/// improves. It ends like finish(). `worst`: error of the worst outline, in and out. It measures the mesh 5 to 32
	/// times per round and, by the size of the mesh, 120 to 1200 times in total.
	void search(const SightBox &box, const Outlines &wanted, float goal, float &worst);

private:
	static constexpr size_t WAYS = 4; ///< Wider; wider along x than along z; wider along x = z than across; turned.
	static constexpr size_t STRETCHES = 3; ///< The first three.
	static constexpr size_t TURN = 3; ///< Tangent of half the angle.
	static constexpr size_t MOST_BUNDLES = 8;
	using Ways = std::array<float, WAYS>;
	/// Limits of widths, as fractions of the written width.
	struct Limits {
		float least, most, turned;
		float least_flower, most_flower, turned_flower;
		bool by_width; ///< True: the limit of a turn is a fraction of the current width.
	};
	static constexpr Limits USUAL = { 0.25f, 4.0f, 0.7f, 0.45f, 1.7f, 0.25f, false };
	static constexpr Limits LOOSE = { 0.2f, 6.0f, 0.85f, 0.45f, 1.7f, 0.25f, true };

	/// Area that a unit shows in each outline as written, as if nothing hid it, and the change of this area with its
	/// widths.
	struct Unit {
		Outlines area = {};
		std::array<std::array<float, STRETCHES>, OUTLINES> change = {};
		Ways weight = {}; ///< Larger: changes more readily.
		Ways widths = {}; ///< Current changes of the written widths.
		Ways kept = {};
		size_t bundle = 0; ///< Bundle of units that a search changes together.
	};

	const std::vector<WrittenUnit> &written;
	const FormBuffers &mesh;
	std::vector<Unit> units;
	std::vector<glm::vec3> asides; ///< As written.
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

/// A turn about the upright axis by the tangent of half its angle; it needs no sine.
struct HalfTurn {
	float cosine, sine;

	explicit HalfTurn(float half) :
			cosine((1.0f - half * half) / (1.0f + half * half)), sine(2.0f * half / (1.0f + half * half)) {}
	glm::vec3 of(const glm::vec3 &way) const {
		return { cosine * way.x - sine * way.z, way.y, sine * way.x + cosine * way.z };
	}
};

/// Solves a·x = b for a symmetric positive matrix by Cholesky decomposition; b becomes x.
void solve_outlines(float (&a)[OUTLINES][OUTLINES], float (&b)[OUTLINES]);

} // namespace undergrowth
