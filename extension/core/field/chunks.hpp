#pragma once

#include "field/plants.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace undergrowth {

/// Plants [begin, end) of one species and variant in one chunk.
struct ChunkRange {
	int begin = 0;
	int end = 0;
	uint8_t species = 0;
	uint8_t variant = 0;
};

/// A square of the ground with plants on it: x from column·size to (column + 1)·size, z by `row` alike.
struct FieldChunk {
	int column = 0;
	int row = 0;
	int begin = 0; ///< Its plants are [begin, end).
	int end = 0;
	int first_range = 0; ///< Its ranges are [first_range, last_range).
	int last_range = 0;
	/// The box (m) that holds every place that a plant of the chunk can reach.
	glm::vec3 low = { 0.0f, 0.0f, 0.0f };
	glm::vec3 high = { 0.0f, 0.0f, 0.0f };
};

struct FieldChunks {
	float size = 16.0f; ///< m.
	std::vector<FieldChunk> chunks; ///< Those with plants, along Hilbert's curve: next ones are neighbours.
	std::vector<ChunkRange> ranges; ///< By chunk, species and variant; they cover all plants once.
};

/// Sorts plants by (chunk, species, variant), equal ones stay in their order, and tells the chunks.
/// `size` (m) > 0; another acts as 16. `reach[s]` (m): how far from its root a plant of species s at scale and height 1
/// reaches when it bends as far as it can; `species_count` entries, plants of other species reach 0.
FieldChunks sort_into_chunks(FieldPlants &plants, float size, const float *reach, int species_count);

/// Where a plant is in the pages.
struct PagePlace {
	int page = 0;
	int index = 0;
};

/// Plants [begin, end) that are the page's plants [first, first + end - begin).
struct PageRun {
	int begin = 0;
	int end = 0;
	int page = 0;
	int first = 0;
};

/// Up to `most` plants of one species.
struct PagePlants {
	int species = 0;
	int count = 0;
	int first_run = 0; ///< Its runs are [first_run, last_run).
	int last_run = 0;
};

struct PagePlan {
	std::vector<PagePlants> pages; ///< By species; within one, by chunks.
	std::vector<PageRun> runs; ///< By page.
	std::vector<int> runs_by_plant; ///< Indices of runs, by their first plants.

	/// Of a plant that is in a page. O(log runs).
	PagePlace find(int plant) const;
	/// Indices of a page's plants, in the page's order.
	std::vector<int> plants(int page) const;
};

/// Divides sorted plants into pages of at most `most` (>= 1) plants, of one species and neighbouring chunks each: as
/// few pages for a species as can be.
PagePlan plan_pages(const FieldChunks &chunks, int most = 4096);

/// Indices, ascending, of plants whose roots are at most `radius` (m) from `centre`. Looks into chunks that the sphere
/// meets only. `plants` are as sort_into_chunks() left them.
std::vector<int> find_in_sphere(
		const FieldPlants &plants, const FieldChunks &chunks, const glm::vec3 &centre, float radius);

} // namespace undergrowth
