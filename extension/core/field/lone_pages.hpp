#pragma once

#include "motion/bodies.hpp"

#include <vector>

namespace undergrowth {

/// Pages of single plants (Plant3D), with the page interface of FieldSimulation that TipContact needs. Does not own the
/// pages.
class LonePages {
public:
	void clear() { pages.clear(); }
	/// `axes`: see PageStand::axes. Page and axes must outlive their entry.
	void add(MotionPage &page, const glm::mat3 *axes) { pages.push_back({ &page, { axes, nullptr } }); }

	int page_count() const { return static_cast<int>(pages.size()); }
	const MotionPage &page(int index) const { return *at(index).page; }
	MotionPage &page(int index) { return *at(index).page; }
	const PageStand &stand(int index) const { return at(index).stand; }

private:
	struct Lone {
		MotionPage *page;
		PageStand stand;
	};

	std::vector<Lone> pages;

	const Lone &at(int index) const { return pages[static_cast<std::size_t>(index)]; }
};

} // namespace undergrowth
