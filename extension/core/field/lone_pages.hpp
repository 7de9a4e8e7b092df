#pragma once

#include "motion/bodies.hpp"

#include <vector>

namespace undergrowth {

/// Pages of plants that stand on nodes of their own, for TipContact, which knows them by the names that a
/// FieldSimulation has for its pages. It owns none of them.
class LonePages {
public:
	void clear() { pages.clear(); }
	/// `axes` as PageStand::axes. Both must outlive their stay here.
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
