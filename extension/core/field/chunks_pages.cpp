#include "field/chunks.hpp"

#include <algorithm>

namespace undergrowth {

namespace {

/// The index of the plant's run among the sorted runs.
std::size_t run_of(const PagePlan &plan, int plant) {
	const auto is_after = [&](int which, int run) { return which < plan.runs[static_cast<std::size_t>(run)].begin; };
	const auto after = std::upper_bound(plan.runs_by_plant.begin(), plan.runs_by_plant.end(), plant, is_after);
	return static_cast<std::size_t>(*(after - 1));
}

/// Appends plants [begin, end) of a species to the last page as long as there is room, then to new ones.
void add_run(PagePlan &plan, int species, int begin, int end, int most) {
	while (begin < end) {
		if (plan.pages.empty() || plan.pages.back().species != species || plan.pages.back().count == most) {
			const int run = static_cast<int>(plan.runs.size());
			plan.pages.push_back({ species, 0, run, run });
		}
		PagePlants &page = plan.pages.back();
		const int taken = std::min(end - begin, most - page.count);
		plan.runs.push_back({ begin, begin + taken, static_cast<int>(plan.pages.size()) - 1, page.count });
		page.count += taken;
		page.last_run++;
		begin += taken;
	}
}

} // namespace

PagePlan plan_pages(const FieldChunks &chunks, int most) {
	std::vector<ChunkRange> ranges = chunks.ranges;
	const auto is_before = [](const ChunkRange &a, const ChunkRange &b) { return a.species < b.species; };
	std::stable_sort(ranges.begin(), ranges.end(), is_before);
	PagePlan plan;
	for (std::size_t i = 0; i < ranges.size();) {
		const int species = ranges[i].species;
		const int begin = ranges[i].begin;
		int end = begin;
		for (; i < ranges.size() && ranges[i].species == species && ranges[i].begin == end; i++) {
			end = ranges[i].end;
		}
		add_run(plan, species, begin, end, std::max(most, 1));
	}
	for (std::size_t i = 0; i < plan.runs.size(); i++) {
		plan.runs_by_plant.push_back(static_cast<int>(i));
	}
	std::sort(plan.runs_by_plant.begin(), plan.runs_by_plant.end(), [&](int a, int b) {
		return plan.runs[static_cast<std::size_t>(a)].begin < plan.runs[static_cast<std::size_t>(b)].begin;
	});
	return plan;
}

PagePlace PagePlan::find(int plant) const {
	const PageRun &run = runs[run_of(*this, plant)];
	return { run.page, run.first + plant - run.begin };
}

std::vector<int> PagePlan::plants(int page) const {
	const PagePlants &wanted = pages[static_cast<std::size_t>(page)];
	std::vector<int> found;
	found.reserve(static_cast<std::size_t>(wanted.count));
	for (int i = wanted.first_run; i < wanted.last_run; i++) {
		const PageRun &run = runs[static_cast<std::size_t>(i)];
		for (int plant = run.begin; plant < run.end; plant++) {
			found.push_back(plant);
		}
	}
	return found;
}

} // namespace undergrowth
