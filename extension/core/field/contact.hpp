#pragma once

#include "field/field_simulation.hpp"
#include "field/lone_pages.hpp"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace undergrowth {

/// Contact of tips (thesis, requirement 2.2.4): spheres of the collision radius that push each other apart.
///
/// Inelastic: of two tips that touch, what they approach each other by is taken away, shared by their masses, and they
/// are moved apart along their spheres. A pair counts by one over the larger number of contacts of the two, so that
/// every plant's motion is a weighted mean of motions that single contacts would give, and energy never grows. Two tips
/// that overlap in calm air touch only where they come nearer than that, so that no contact is a motor.
///
/// A tip's cost is bounded whatever the radius: of each cell of the ground it looks at NEIGHBOURS tips before its own
/// place in its cell, and as many after it. What one tip looks at looks at it, so that energy still never grows.
///
/// Once after each step: gather() of all pages, sort() on one thread, count() of all pages, separate() of all pages.
/// Each of the three may be split over threads by ranges of page numbers, one after the other; the bits are the same.
/// count() and separate() divide the tips by where they are on the ground, so neighbours are neighbours in memory:
/// a range of so many pages means so many tips, of any page. Plants that follow a prototype take no part.
///
/// Pages: FieldSimulation, or LonePages, whose places are those of one world.
class TipContact {
public:
	static constexpr int NEIGHBOURS = 13;
	static constexpr int CELLS_IN_REACH = 9;
	static constexpr int MOST_CONTACTS = CELLS_IN_REACH * (2 * NEIGHBOURS + 1);

	/// Takes the memory that these pages need; to be called when plants came or went. Nothing allocates after it.
	template <class Pages> void fit(const Pages &field);
	/// Takes over the collision radii of species that changed since fit(). Before gather(), on one thread, at the cost
	/// of a look at each page.
	template <class Pages> void follow_radii(const Pages &field);
	template <class Pages> void gather(const Pages &field, int begin, int end);
	void sort();
	template <class Pages> void count(const Pages &field, int begin, int end);
	template <class Pages> void separate(Pages &field, int begin, int end);
	/// All of them, on one thread.
	template <class Pages> void resolve(Pages &field);

	/// Whether so many tips were in one cell at the last sort() that most of its pairs do not look at each other.
	bool is_crowded() const { return most_in_bucket > 4u * static_cast<uint32_t>(NEIGHBOURS); }
	/// Pairs that the last sort() leaves to count() and separate() to look at, each twice.
	std::size_t candidate_count() const;
	/// Of the last count(): contacts of a plant, MOST_CONTACTS at most.
	int contacts(int page, int index) const { return touching[first(page) + static_cast<std::size_t>(index)]; }
	std::size_t bytes() const;

private:
	struct SortedTip {
		glm::vec3 place; ///< m.
		uint32_t tip;
	};

	uint32_t most_in_bucket = 0;
	float cell_size = 1.0f; ///< m, the largest distance of two tips that touch.
	float cells_per_metre = 1.0f;
	std::vector<uint32_t> page_firsts; ///< Of each page, and the number of all plants at the end.
	/// By tip: from gather() to sort() its place (m), from count() to separate() its velocity (m/s) if it touches one.
	std::vector<glm::vec3> vectors;
	std::vector<uint32_t> buckets; ///< By tip.
	std::vector<uint32_t> pages; ///< Whose a tip is.
	std::vector<uint8_t> touching;
	std::vector<uint32_t> bucket_ends; ///< A power of two of them, and one more.
	std::vector<SortedTip> sorted; ///< By bucket, in rising order of tips within one.

	std::size_t first(int page) const { return page_firsts[static_cast<std::size_t>(page)]; }
	std::ptrdiff_t page_begin(int page) const { return static_cast<std::ptrdiff_t>(first(page)); }
	int page_of(uint32_t tip) const { return static_cast<int>(pages[tip]); }
	int index_of(uint32_t tip) const { return static_cast<int>(tip - page_firsts[pages[tip]]); }
	/// Whether there are tips in one cell that do not look at each other.
	bool leaves_out() const { return most_in_bucket > static_cast<uint32_t>(NEIGHBOURS) + 1u; }
	uint32_t bucket(int cell_x, int cell_z) const;
	int cell(float place) const;
	/// Calls visit(begin, end, row) for each run of `sorted` whose tips in that row of cells `own` looks at.
	template <class Visit> void for_each_run(const SortedTip &own, Visit &&visit) const;
	template <class Visit> void for_each_run_near(uint32_t rank, uint32_t start, int row, Visit &&visit) const;
	/// Calls visit(other tip, offset, distance, wanted distance) for each tip that touches `own`.
	template <class Pages, class Visit>
	void for_each_contact(const Pages &field, const SortedTip &own, Visit &&visit) const;
	template <class Pages> void separate_one(Pages &field, const SortedTip &own);
};

} // namespace undergrowth
