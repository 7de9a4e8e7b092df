#include "motion/columns.hpp"

#include <algorithm>
#include <cstddef>

namespace undergrowth {

namespace {

constexpr std::size_t PAGE_FLOATS = 1024;
/// Columns a whole number of memory pages apart share a few sets of the first-level cache and evict each other. At
/// slightly less than that, the processor confuses a write to one column with a read of the next. Five lines more than
/// whole pages spread the columns.
constexpr std::size_t SPREAD_FLOATS = 80;
constexpr std::size_t MAX_SPREAD_FLOATS = PAGE_FLOATS - 112;

std::size_t round_up(std::size_t value, std::size_t unit) {
	return (value + unit - 1) / unit * unit;
}

std::size_t spread(std::size_t floats) {
	const std::size_t beyond = floats % PAGE_FLOATS;
	if (floats < PAGE_FLOATS || (beyond >= SPREAD_FLOATS && beyond <= MAX_SPREAD_FLOATS)) {
		return floats;
	}
	return floats - beyond + SPREAD_FLOATS + (beyond > MAX_SPREAD_FLOATS ? PAGE_FLOATS : 0);
}

} // namespace

Columns::Columns(int column_count) : columns(static_cast<std::size_t>(column_count)), lines(1) {}

int Columns::add_row() {
	if (static_cast<std::size_t>(row_count) == capacity) {
		resize_room(std::max(LINE_FLOATS, capacity * 2));
	}
	for (int i = 0; i < static_cast<int>(columns); i++) {
		column(i)[row_count] = 0.0f;
	}
	return row_count++;
}

void Columns::remove_row(int index) {
	row_count--;
	for (int i = 0; i < static_cast<int>(columns); i++) {
		column(i)[index] = column(i)[row_count];
	}
}

void Columns::reserve(int rows) {
	const std::size_t wanted = round_up(static_cast<std::size_t>(std::max(rows, 0)), LINE_FLOATS);
	if (wanted > capacity) {
		resize_room(wanted);
	}
}

void Columns::resize_room(std::size_t wanted) {
	const std::size_t new_stride = spread(wanted);
	std::vector<CacheLine> grown(columns * new_stride / LINE_FLOATS);
	for (std::size_t i = 0; i < columns; i++) {
		const float *from = column(static_cast<int>(i));
		std::copy(from, from + row_count, grown.data()->values + i * new_stride);
	}
	lines.swap(grown);
	stride = new_stride;
	capacity = wanted;
}

} // namespace undergrowth
