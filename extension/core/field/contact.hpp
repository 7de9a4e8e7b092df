#pragma once

#include "field/field_simulation.hpp"
#include "field/page_refs.hpp"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace undergrowth {

/// Contact of tips (thesis, requirement 2.2.4): each tip is a sphere with the collision radius of its species, and
/// touching spheres push each other apart. Owns a grid over the ground with the tips of all pages.
///
/// Method: contacts are inelastic. Two touching tips lose their approach speed, divided by their masses, and move
/// apart. A pair is weighted by one over the larger contact count of the two, so the motion of a plant is a weighted
/// mean over its contacts, and energy never grows. Two tips that overlap in calm air touch only when they come nearer
/// than that.
///
/// Cost: in each cell a tip checks NEIGHBOURS tips before its own position in the cell's list, and the same number
/// after it. This bounds the cost of a tip for any radius. The relation is symmetric, so energy does not grow either.
///
/// Use: after each step call gather() for all pages, then sort() on one thread, then count() and separate() for all
/// pages. Threads may share gather(), count() and separate() by ranges of page numbers, but the functions must not
/// overlap in time. The result has the same bits for any division. Only fit() allocates. Plants that follow a prototype
/// have no contacts.
///
/// Pages: a FieldSimulation, or PageRefs with positions in one world.
class TipContact {
public:
	static constexpr int NEIGHBOURS = 13;
	static constexpr int CELLS_IN_REACH = 9;
	static constexpr int MAX_CONTACTS = CELLS_IN_REACH * (2 * NEIGHBOURS + 1);

	/// Allocates memory for these pages. Call it after plants were added or removed.
	template <class Pages> void fit(const Pages &field);
	/// Reads collision radii that changed since fit(). Call it before gather(), on one thread.
	template <class Pages> void follow_radii(const Pages &field);
	template <class Pages> void gather(const Pages &field, int begin, int end);
	void sort();
	template <class Pages> void count(const Pages &field, int begin, int end);
	template <class Pages> void separate(Pages &field, int begin, int end);
	/// Runs all functions above on one thread.
	template <class Pages> void resolve(Pages &field);

	/// True if most pairs of some cell were not checked, because it had too many tips at the last sort().
	bool is_crowded() const { return max_in_bucket > 4u * static_cast<uint32_t>(NEIGHBOURS); }
	/// Number of pairs that count() and separate() check after the last sort(), each twice.
	std::size_t candidate_count() const;
	/// Contacts of a plant in the last count(), at most MAX_CONTACTS.
	int contacts(int page, int index) const { return touching[first(page) + static_cast<std::size_t>(index)]; }
	std::size_t bytes() const;

private:
	struct SortedTip {
		glm::vec3 place; ///< m.
		uint32_t tip;
	};

	uint32_t max_in_bucket = 0;
	float cell_size = 1.0f; ///< m, maximum distance of two touching tips.
	float cells_per_metre = 1.0f;
	std::vector<uint32_t> page_firsts; ///< First tip of each page; the last entry is the number of all tips.
	/// By tip: its position (m) from gather() to sort(), its velocity (m/s) from count() to separate() if it has
	/// contacts.
	std::vector<glm::vec3> vectors;
	std::vector<uint32_t> buckets; ///< By tip.
	std::vector<uint32_t> pages; ///< Page of each tip.
	std::vector<uint8_t> touching;
	std::vector<uint32_t> bucket_ends; ///< Size: a power of two, plus one.
	std::vector<SortedTip> sorted; ///< By bucket, in rising order of tips within one.

	std::size_t first(int page) const { return page_firsts[static_cast<std::size_t>(page)]; }
	std::ptrdiff_t page_begin(int page) const { return static_cast<std::ptrdiff_t>(first(page)); }
	int page_of(uint32_t tip) const { return static_cast<int>(pages[tip]); }
	int index_of(uint32_t tip) const { return static_cast<int>(tip - page_firsts[pages[tip]]); }
	/// True if some pairs within a cell are not checked.
	bool leaves_out() const { return max_in_bucket > static_cast<uint32_t>(NEIGHBOURS) + 1u; }
	uint32_t bucket(int cell_x, int cell_z) const;
	int cell(float place) const;
	/// Calls visit(begin, end, row) for each run of `sorted` in a row of cells that `own` checks.
	template <class Visit> void for_each_run(const SortedTip &own, Visit &&visit) const;
	template <class Visit> void for_each_run_near(uint32_t rank, uint32_t start, int row, Visit &&visit) const;
	/// Calls visit(other tip, offset, distance, wanted distance) for each tip that touches `own`.
	template <class Pages, class Visit>
	void for_each_contact(const Pages &field, const SortedTip &own, Visit &&visit) const;
	template <class Pages> void separate_one(Pages &field, const SortedTip &own);
};

} // namespace undergrowth
