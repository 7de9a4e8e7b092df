#pragma once

#include <cstddef>
#include <vector>

namespace undergrowth {

/// A table of floats, one column after the other, each column at the start of a cache line: the struct-of-arrays that
/// the kernels read. Rows are dense. Growing moves the table and invalidates column pointers.
class Columns {
public:
	explicit Columns(int column_count);

	int size() const { return row_count; }
	/// Reserves room for `rows` rows, rounded up to a cache line.
	void reserve(int rows);
	std::size_t bytes() const { return lines.capacity() * sizeof(CacheLine); }
	/// Appends a row of zeros and returns its index. Allocates when the room is used up.
	int add_row();
	/// Removes row `index` by moving the last one into its place.
	void remove_row(int index);

	float *column(int which) { return lines.data()->values + static_cast<std::size_t>(which) * stride; }
	const float *column(int which) const { return lines.data()->values + static_cast<std::size_t>(which) * stride; }

private:
	static constexpr std::size_t LINE_FLOATS = 16;
	struct alignas(64) CacheLine {
		float values[LINE_FLOATS] = {};
	};

	std::size_t columns;
	std::size_t stride = 0; ///< Floats from one column to the next.
	std::size_t capacity = 0;
	int row_count = 0;
	std::vector<CacheLine> lines;

	void resize_room(std::size_t wanted);
};

} // namespace undergrowth
