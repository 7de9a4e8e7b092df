#pragma once

#include "mesh/form_plan.hpp"

#include <vector>

namespace undergrowth {

inline constexpr float HALF_SPHERE = 1.75f; // rad: domes above this are drawn as whole spheres.

/// Fractions of the parts that remain; the last is none.
inline constexpr float DENSITIES[] = { 1.0f, 0.8f, 0.65f, 0.5f, 0.42f, 0.34f, 0.25f, 0.18f, 0.12f, 0.07f, 0.04f, 0.02f,
	0.01f, 0.005f, 0.001f, 0.0002f, 0.0f };
inline constexpr size_t DENSITY_COUNT = sizeof(DENSITIES) / sizeof(DENSITIES[0]);
inline constexpr BodyDetail BODIES[] = { { 0, 0 }, { 8, 2 }, { 6, 2 }, { 5, 2 }, { 4, 2 }, { 5, 1 }, { 4, 1 },
	{ 3, 1 } };
inline constexpr size_t BODY_COUNT = sizeof(BODIES) / sizeof(BODIES[0]);

inline constexpr float FLAT_STEM = 0.1f; ///< A ribbon as a stem is thinner from some sides.

/// Returns the factor of the area of parts by which they count: parts of a rare colour, as flowers, count more. `mean`:
/// of the plant.
float worth_of(const glm::vec3 &color, const glm::vec3 &mean);

/// Reduces a form from full detail step by step (plan_form).
class PlanSteps {
public:
	/// Large budgets start with close-up details.
	PlanSteps(const PlantForm &form, const FormMeasure &measure, int budget = vertex_budget(FINEST_USUAL_LOD),
			const CarriedCards &cards = {});

	int vertices() const { return total; }
	/// Takes the step with the lowest cost per saved vertex; vertices below the budget do not count as saved. For
	/// plants with many groups, as from scripts that add part by part, takes all steps of similar cost. Returns false
	/// if there is none.
	bool take_best(int budget);
	/// Undoes the one step that fits the budget and improves most. Returns false if there is none.
	bool give_back(int budget);
	FormPlan finish();
	/// Number of visited parts and groups, which is the cost of planning.
	int64_t work() const { return evaluated; }

private:
	/// Detail of a group.
	struct Drawn {
		size_t detail = 0;
		size_t density = 0; ///< Index in DENSITIES.
		size_t body = 0; ///< Index in BODIES; 0: no body.
	};
	/// Present detail of a group.
	struct State : Drawn {
		std::vector<PartDetail> details;
		std::vector<int> costs; ///< Vertices of a part at each detail.
		std::vector<float> errors; ///< As fractions of its area, at each detail.
		int parts = 0; ///< Number of drawn parts.
		int bodies = 0;
		int card_vertices = 0; ///< Of the cards on drawn parts.
		float card_area = 0.0f; ///< Of the cards on all its parts (m²).
		bool carries_cards = false; ///< Itself, or its parts do.
		float area = 0.0f; ///< Shown area of all its parts (m²).
		bool is_stem = false; ///< True if it grows from the ground and carries parts.
		std::vector<int> left; ///< Remaining parts for each entry of DENSITIES.
		float contrast = 0.0f; ///< Squared distance of its colour to the nearest colour of another part.
		float worth = 1.0f; ///< Weight of its area: larger for a conspicuous colour, as of flowers.
		float cover = 1.0f; ///< Fraction of a body's silhouette that its parts cover.
		size_t density_end = DENSITY_COUNT; ///< From this index on, nothing of the plant would be visible.
		int bodies_left = 0; ///< Number of times a few parts replaced its bodies.
		std::vector<size_t> carried; ///< Groups carried by this group only.
		size_t twins = 0; ///< Index in `twins`.
		// Including everything that its parts carry:
		int branch_vertices = 0;
		float branch_area = 0.0f;
		float branch_error = 0.0f;
	};
	struct Step {
		int group = -1;
		Drawn next;
		float price = 0.0f;
		float saved = 0.0f; ///< Vertices.
	};

	/// Groups of one kind on the same carriers.
	struct Twins {
		int drawn = 0; ///< Groups that are not dropped.
		float dropped_area = 0.0f; ///< m² of dropped groups.
	};

	const PlantForm &form;
	const FormMeasure &measure;
	const CarriedCards cards;
	std::vector<State> states;
	std::vector<Twins> twins;
	std::vector<FormPlan::Fate> fates;
	std::vector<int> bodies;
	int body_count = 0;
	int total = 0;
	int64_t evaluated = 0;

	bool step_back(State &state) const;
	void draw(size_t group, const Drawn &drawn) { static_cast<Drawn &>(states[group]) = drawn; }
	void recount();
	void count_left(size_t group);
	void find_cards();
	void find_relatives();
	void find_contrasts();
	void find_worths();
	float dropped_area(const State &state) const;
	void add_up_branches();
	float own_error(const State &state) const;
	float thin_error(const State &state, size_t density) const;
	bool has_twin(int group) const;
	void pass_on(std::vector<float> &shown) const;
	BodyDetail body_of(size_t group, size_t body) const;
	int own_vertices(size_t group) const;
	Step find_best(int group, int excess) const;
	void take(const Step &step);
	void take_many(std::vector<Step> &steps, const Step &best, int excess);
	int count_drawn(size_t group, float density) const;
	bool could_fit(size_t group, const Drawn &next, int room) const;
	void offer(Step &best, int group, size_t detail, size_t density, size_t body, float saved, float harm) const;
	void offer_details(Step &best, int group, int excess) const;
	void offer_thinning(Step &best, int group, int excess) const;
	void offer_few(Step &best, int group, size_t density, int excess) const;
	void offer_body(Step &best, int group, int excess) const;
};

} // namespace undergrowth
