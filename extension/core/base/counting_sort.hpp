#pragma once

#include <cstddef>
#include <vector>

namespace undergrowth {

/// The entries of `order` by key(entry), which is an int in [0, keys). Stable, so that a sort by a lower digit and then
/// by a higher one sorts by both. Its time grows with the entries and the keys.
template <class Key> std::vector<int> counting_sort(const std::vector<int> &order, int keys, Key key) {
	std::vector<int> starts(static_cast<std::size_t>(keys) + 1, 0);
	for (const int entry : order) {
		starts[static_cast<std::size_t>(key(entry)) + 1]++;
	}
	for (std::size_t i = 1; i < starts.size(); i++) {
		starts[i] += starts[i - 1];
	}
	std::vector<int> sorted(order.size());
	for (const int entry : order) {
		sorted[static_cast<std::size_t>(starts[static_cast<std::size_t>(key(entry))]++)] = entry;
	}
	return sorted;
}

} // namespace undergrowth
