#include "stand/density_bytes.hpp"

#include <algorithm>
#include <cstring>

namespace undergrowth {

namespace {

constexpr uint8_t MAGIC[4] = { 'U', 'G', 'D', 'M' };
constexpr uint32_t VERSION = 1;
constexpr std::size_t LENGTH_AT = 6;
constexpr std::size_t HEADER = 16;
constexpr std::size_t CHECKSUM = 4;
constexpr std::size_t MOST_LITERALS = 128;
constexpr std::size_t LEAST_RUN = 3;
constexpr std::size_t MOST_RUN = 130;

using Plane = std::array<uint8_t, DensityBlock::CELLS>;

void put(std::vector<uint8_t> &to, uint32_t value, int bytes) {
	for (int i = 0; i < bytes; i++) {
		to.push_back(static_cast<uint8_t>(value >> (8 * i)));
	}
}

std::size_t run_at(const Plane &plane, std::size_t from) {
	std::size_t end = from;
	while (end < plane.size() && end - from < MOST_RUN && plane[end] == plane[from]) {
		end++;
	}
	return end - from;
}

void put_plane(std::vector<uint8_t> &to, const Plane &plane) {
	for (std::size_t i = 0; i < plane.size();) {
		const std::size_t run = run_at(plane, i);
		if (run >= LEAST_RUN) {
			to.push_back(static_cast<uint8_t>(128 + run - LEAST_RUN));
			to.push_back(plane[i]);
			i += run;
			continue;
		}
		std::size_t end = i;
		while (end < plane.size() && end - i < MOST_LITERALS && run_at(plane, end) < LEAST_RUN) {
			end++;
		}
		to.push_back(static_cast<uint8_t>(end - i - 1));
		to.insert(to.end(), plane.begin() + static_cast<std::ptrdiff_t>(i),
				plane.begin() + static_cast<std::ptrdiff_t>(end));
		i = end;
	}
}

/// Reads numbers one after the other; whatever is missing makes it fail from there on.
class Reader {
public:
	Reader(const uint8_t *from, std::size_t count) : next(from), left(count) {}

	uint32_t number(std::size_t bytes) {
		uint32_t value = 0;
		for (std::size_t i = 0; i < bytes && need(bytes - i); i++) {
			value |= static_cast<uint32_t>(take()) << (8 * i);
		}
		return value;
	}

	std::string text(std::size_t bytes) {
		std::string made;
		for (std::size_t i = 0; i < bytes && need(1); i++) {
			made.push_back(static_cast<char>(take()));
		}
		return made;
	}

	void plane(Plane &to) {
		std::size_t done = 0;
		while (has_all && done < to.size()) {
			const std::size_t code = number(1);
			const std::size_t length = code < 128 ? code + 1 : code - 128 + LEAST_RUN;
			if (!has_all || length > to.size() - done || !need(code < 128 ? length : 1)) {
				has_all = false;
				return;
			}
			for (std::size_t i = 0; i < length; i++) {
				to[done++] = code < 128 ? take() : *next;
			}
			if (code >= 128) {
				take();
			}
		}
	}

	bool is_sound() const { return has_all; }
	std::size_t rest() const { return left; }

private:
	const uint8_t *next;
	std::size_t left;
	bool has_all = true;

	bool need(std::size_t bytes) {
		has_all = has_all && left >= bytes;
		return has_all;
	}
	uint8_t take() {
		left--;
		return *next++;
	}
};

float read_float(uint32_t bits) {
	float value = 0.0f;
	std::memcpy(&value, &bits, sizeof(value));
	return value;
}

bool is_near(const DensityMap &map, const TileKey &key) {
	const CellRange all = map.cells_around(
			{ { -FARTHEST_COORDINATE, -FARTHEST_COORDINATE }, { FARTHEST_COORDINATE, FARTHEST_COORDINATE } });
	const TileKey first = density_block_of(all.first_column, all.first_row);
	const TileKey last = density_block_of(all.last_column, all.last_row);
	return key.column >= first.column && key.column <= last.column && key.row >= first.row && key.row <= last.row;
}

bool read_block(Reader &from, int layer, DensityMap &map) {
	const auto column = static_cast<int32_t>(from.number(4));
	const auto row = static_cast<int32_t>(from.number(4));
	DensityBlock block;
	from.plane(block.density);
	from.plane(block.height);
	if (!from.is_sound() || !is_near(map, { column, row })) {
		return false;
	}
	for (std::size_t i = 0; i < DensityBlock::CELLS; i++) {
		const auto x = static_cast<int>(i % DensityBlock::SIDE);
		const auto z = static_cast<int>(i / DensityBlock::SIDE);
		map.set_cell(layer, column * DensityBlock::SIDE + x, row * DensityBlock::SIDE + z,
				{ block.density[i], block.height[i] });
	}
	return true;
}

bool read_layer(Reader &from, DensityMap &map) {
	const std::size_t length = from.number(1);
	const std::string name = from.text(length);
	const uint32_t blocks = from.number(4);
	const int layer = from.is_sound() && map.find_layer(name) < 0 ? map.need_layer(name) : -1;
	for (uint32_t i = 0; layer >= 0 && i < blocks; i++) {
		if (!read_block(from, layer, map)) {
			return false;
		}
	}
	return layer >= 0;
}

DensityFault find_header_fault(const uint8_t *bytes, std::size_t count) {
	if (count < sizeof(MAGIC) || std::memcmp(bytes, MAGIC, sizeof(MAGIC)) != 0) {
		return DensityFault::not_a_map;
	}
	Reader header(bytes + sizeof(MAGIC), count - sizeof(MAGIC));
	const uint32_t version = header.number(2);
	const uint32_t length = header.number(4);
	if (header.is_sound() && version > VERSION) {
		return DensityFault::later_version;
	}
	const bool is_whole = header.is_sound() && version == VERSION && length == count && count >= HEADER + CHECKSUM;
	if (!is_whole) {
		return DensityFault::torn;
	}
	const uint32_t told = Reader(bytes + count - CHECKSUM, CHECKSUM).number(CHECKSUM);
	return told == density_checksum(bytes, count - CHECKSUM) ? DensityFault::none : DensityFault::torn;
}

} // namespace

const char *describe(DensityFault fault) {
	switch (fault) {
		case DensityFault::none:
			return "The map is sound.";
		case DensityFault::not_a_map:
			return "Its data are not those of a map: restore the file.";
		case DensityFault::later_version:
			return "It was saved by a later release of Undergrowth: update the add-on.";
		case DensityFault::torn:
			return "Its data are cut off or damaged: restore the file.";
	}
	return "";
}

uint32_t density_checksum(const uint8_t *bytes, std::size_t count) {
	uint32_t hash = 0x811c9dc5u;
	for (std::size_t i = 0; i < count; i++) {
		hash = (hash ^ bytes[i]) * 0x01000193u;
	}
	return hash;
}

std::vector<uint8_t> write_density(const DensityMap &map) {
	std::vector<uint8_t> bytes(MAGIC, MAGIC + sizeof(MAGIC));
	put(bytes, VERSION, 2);
	put(bytes, 0, 4); // The length, once it is known.
	uint32_t cell = 0;
	const float size = map.cell_size();
	std::memcpy(&cell, &size, sizeof(cell));
	put(bytes, cell, 4);
	put(bytes, static_cast<uint32_t>(map.layer_count()), 2);
	for (int layer = 0; layer < map.layer_count(); layer++) {
		const std::string &name = map.layer_name(layer);
		put(bytes, static_cast<uint32_t>(name.size()), 1);
		bytes.insert(bytes.end(), name.begin(), name.end());
		put(bytes, static_cast<uint32_t>(map.blocks(layer).size()), 4);
		for (const auto &[key, block] : map.blocks(layer)) {
			put(bytes, static_cast<uint32_t>(key.column), 4);
			put(bytes, static_cast<uint32_t>(key.row), 4);
			put_plane(bytes, block->density);
			put_plane(bytes, block->height);
		}
	}
	const auto length = static_cast<uint32_t>(bytes.size() + CHECKSUM);
	for (std::size_t i = 0; i < 4; i++) {
		bytes[LENGTH_AT + i] = static_cast<uint8_t>(length >> (8 * i));
	}
	put(bytes, density_checksum(bytes.data(), bytes.size()), 4);
	return bytes;
}

DensityFault read_density(const uint8_t *bytes, std::size_t count, DensityMap &map) {
	if (count == 0) {
		map.clear();
		return DensityFault::none;
	}
	const DensityFault fault = find_header_fault(bytes, count);
	if (fault != DensityFault::none) {
		return fault;
	}
	Reader from(bytes + LENGTH_AT + 4, count - LENGTH_AT - 4 - CHECKSUM);
	const float size = read_float(from.number(4));
	DensityMap made(size);
	if (made.cell_size() != size) {
		return DensityFault::torn;
	}
	const uint32_t layers = from.number(2);
	for (uint32_t i = 0; i < layers; i++) {
		if (!read_layer(from, made)) {
			return DensityFault::torn;
		}
	}
	if (from.rest() != 0) {
		return DensityFault::torn;
	}
	map = std::move(made);
	return DensityFault::none;
}

} // namespace undergrowth
