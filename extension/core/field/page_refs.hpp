#pragma once

#include "motion/bodies.hpp"

#include <vector>

namespace undergrowth {

/// Pages of single plants (Plant3D), with the page interface of FieldSimulation that TipContact needs. Does not own the
/// pages.
class PageRefs {
public:
	void clear() { pages.clear(); }
	/// `axes`: see PageFrame::axes. Page and axes must outlive their entry.
	void add(MotionPage &page, const glm::mat3 *axes) { pages.push_back({ &page, { axes, nullptr } }); }

	int page_count() const { return static_cast<int>(pages.size()); }
	const MotionPage &page(int index) const { return *at(index).page; }
	MotionPage &page(int index) { return *at(index).page; }
	const PageFrame &frame(int index) const { return at(index).frame; }

private:
	struct Entry {
		MotionPage *page;
		PageFrame frame;
	};

	std::vector<Entry> pages;

	const Entry &at(int index) const { return pages[static_cast<std::size_t>(index)]; }
};

} // namespace undergrowth
