#pragma once

#include "mesh/form_plan.hpp"

#include <vector>

namespace undergrowth {

inline constexpr float HALF_SPHERE = 1.75f; // rad: domes above this are drawn as whole spheres.

/// Fractions of the parts that are drawn; the last draws none.
inline constexpr float KEPT[] = { 1.0f, 0.8f, 0.65f, 0.5f, 0.42f, 0.34f, 0.25f, 0.18f, 0.12f, 0.07f, 0.04f, 0.02f,
	0.01f, 0.005f, 0.001f, 0.0002f, 0.0f };
inline constexpr size_t KEPT_COUNT = sizeof(KEPT) / sizeof(KEPT[0]);
inline constexpr BodyDetail BODIES[] = { { 0, 0 }, { 8, 2 }, { 6, 2 }, { 5, 2 }, { 4, 2 }, { 5, 1 }, { 4, 1 },
	{ 3, 1 } };
inline constexpr size_t BODY_COUNT = sizeof(BODIES) / sizeof(BODIES[0]);

inline constexpr float FLAT_STEM = 0.1f; ///< Error of a stem as a ribbon, which is thinner from some sides.

/// Reduces a form's full detail step by step (plan_form).
class PlanSteps {
public:
	/// `is_close`: starts from the details of a plant that fills the picture.
	PlanSteps(const PlantForm &form, const FormMeasure &measure, bool is_close = false);

	int vertices() const { return total; }
	/// Takes the step with the least harm for each vertex that it saves, counting only vertices over the budget. For
	/// plants of many groups, which scripts grow part by part, it takes all steps of nearly that price. Returns false
	/// if there is no step.
	bool take_best(int budget);
	/// Undoes the step that still fits and improves the picture most. Returns false if there is none.
	bool give_back(int budget);
	FormPlan finish();
	/// Number of parts and groups examined: the cost of planning.
	int64_t work() const { return looked_at; }

private:
	/// Level of detail of a group.
	struct Drawn {
		size_t detail = 0;
		size_t kept = 0; ///< Index in KEPT.
		size_t body = 0; ///< Index in BODIES; 0: no body.
	};
	/// Current state of a group.
	struct State : Drawn {
		std::vector<PartDetail> details;
		std::vector<int> costs; ///< Vertices of a part at each detail.
		std::vector<float> errors; ///< As a fraction of its area, at each detail.
		int parts = 0; ///< Number drawn as parts.
		int bodies = 0;
		float area = 0.0f; ///< m² that all its parts show.
		bool is_stem = false; ///< True if it is on the ground and carries other parts.
		std::vector<int> left; ///< Number of parts for each entry of KEPT.
		float contrast = 0.0f; ///< Squared distance of its colour from the nearest other part's.
		float worth = 1.0f; ///< Weight of its area: larger for colours that stand out, as those of flowers.
		float cover = 1.0f; ///< Fraction of a body's silhouette that its parts fill.
		size_t kept_end = KEPT_COUNT; ///< From this index on nothing of the plant would be visible.
		int bodies_left = 0; ///< Number of times that a few parts replaced its bodies.
		std::vector<size_t> carried; ///< Groups that only this group carries.
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
		int drawn = 0; ///< Number of groups of which something is drawn.
		float dropped_area = 0.0f; ///< m² of all other groups.
	};

	const PlantForm &form;
	const FormMeasure &measure;
	std::vector<State> states;
	std::vector<Twins> twins;
	std::vector<FormPlan::Fate> fates;
	std::vector<int> bodies;
	int body_count = 0;
	int total = 0;
	int64_t looked_at = 0;

	bool step_back(State &state) const;
	void draw(size_t group, const Drawn &drawn) { static_cast<Drawn &>(states[group]) = drawn; }
	void recount();
	void count_left(size_t group);
	void find_relatives();
	void find_contrasts();
	void find_worths();
	float dropped_area(const State &state) const;
	void add_up_branches();
	float own_error(const State &state) const;
	float thin_error(const State &state, size_t kept) const;
	bool has_twin(int group) const;
	void pass_on(std::vector<float> &shown) const;
	int own_vertices(size_t group) const;
	Step find_best(int group, int excess) const;
	void take(const Step &step);
	void take_many(std::vector<Step> &steps, const Step &best, int excess);
	int count_drawn(size_t group, float share) const;
	bool could_fit(size_t group, const Drawn &next, int room) const;
	void offer(Step &best, int group, size_t detail, size_t kept, size_t body, float saved, float harm) const;
	void offer_details(Step &best, int group, int excess) const;
	void offer_thinning(Step &best, int group, int excess) const;
	void offer_few(Step &best, int group, size_t kept, int excess) const;
	void offer_body(Step &best, int group, int excess) const;
};

} // namespace undergrowth
