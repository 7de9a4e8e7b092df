#include "placement/density_bytes.hpp"

#include "base/byte_codec.hpp"

#include <algorithm>

namespace undergrowth {

namespace {

constexpr char LETTERS[] = "UGDM";
constexpr uint32_t WITHOUT_PLANTS = 1;
constexpr uint32_t WITH_PLANTS = 2;
constexpr uint32_t WITH_JITTER = 3;
constexpr int BYTE = 8;
constexpr std::size_t MAX_LITERALS = 128;
constexpr std::size_t MIN_RUN = 3;
constexpr std::size_t MAX_RUN = 130;

using Plane = std::array<uint8_t, DensityBlock::CELLS>;

std::size_t run_at(const Plane &plane, std::size_t from) {
	std::size_t end = from;
	while (end < plane.size() && end - from < MAX_RUN && plane[end] == plane[from]) {
		end++;
	}
	return end - from;
}

void put_plane(std::vector<uint8_t> &to, const Plane &plane) {
	for (std::size_t i = 0; i < plane.size();) {
		const std::size_t run = run_at(plane, i);
		if (run >= MIN_RUN) {
			to.push_back(static_cast<uint8_t>(128 + run - MIN_RUN));
			to.push_back(plane[i]);
			i += run;
			continue;
		}
		std::size_t end = i;
		while (end < plane.size() && end - i < MAX_LITERALS && run_at(plane, end) < MIN_RUN) {
			end++;
		}
		to.push_back(static_cast<uint8_t>(end - i - 1));
		to.insert(to.end(), plane.begin() + static_cast<std::ptrdiff_t>(i),
				plane.begin() + static_cast<std::ptrdiff_t>(end));
		i = end;
	}
}

/// Impossible runs make the reader fail.
void read_plane(ByteReader &from, Plane &to) {
	std::size_t done = 0;
	while (from.is_sound() && done < to.size()) {
		const auto code = static_cast<std::size_t>(from.number(1));
		const std::size_t length = code < 128 ? code + 1 : code - 128 + MIN_RUN;
		if (length > to.size() - done) {
			from.fail();
			return;
		}
		const auto repeated = static_cast<uint8_t>(code < 128 ? 0 : from.number(1));
		for (std::size_t i = 0; i < length; i++) {
			to[done++] = code < 128 ? static_cast<uint8_t>(from.number(1)) : repeated;
		}
	}
}

bool is_near(const DensityMap &map, const TileKey &key) {
	const CellRange all = map.cells_around(
			{ { -FARTHEST_COORDINATE, -FARTHEST_COORDINATE }, { FARTHEST_COORDINATE, FARTHEST_COORDINATE } });
	const TileKey first = density_block_of(all.first_column, all.first_row);
	const TileKey last = density_block_of(all.last_column, all.last_row);
	return key.column >= first.column && key.column <= last.column && key.row >= first.row && key.row <= last.row;
}

uint32_t version_of(const DensityBlock &block) {
	const auto is_some = [](int code) { return code != 0; };
	const auto has_any = [&](const auto &plane) { return std::any_of(plane.begin(), plane.end(), is_some); };
	if (has_any(block.scale_jitter) || has_any(block.color_jitter)) {
		return WITH_JITTER;
	}
	return has_any(block.plants) ? WITH_PLANTS : WITHOUT_PLANTS;
}

uint32_t version_of(const DensityMap &map) {
	uint32_t version = WITHOUT_PLANTS;
	for (int layer = 0; layer < map.layer_count(); layer++) {
		for (const auto &[key, block] : map.blocks(layer)) {
			version = std::max(version, version_of(*block));
		}
	}
	return version;
}

void put_plants(std::vector<uint8_t> &to, const DensityBlock &block) {
	for (const int shift : { 0, BYTE }) {
		Plane plane;
		std::transform(block.plants.begin(), block.plants.end(), plane.begin(),
				[shift](uint16_t code) { return static_cast<uint8_t>(code >> shift); });
		put_plane(to, plane);
	}
}

void read_plants(ByteReader &from, DensityBlock &block) {
	Plane low = {};
	Plane high = {};
	read_plane(from, low);
	read_plane(from, high);
	for (std::size_t i = 0; i < DensityBlock::CELLS; i++) {
		block.plants[i] = static_cast<uint16_t>(low[i] | (high[i] << BYTE));
	}
}

bool read_block(ByteReader &from, uint32_t version, int layer, DensityMap &map) {
	const auto column = static_cast<int32_t>(from.number(4));
	const auto row = static_cast<int32_t>(from.number(4));
	DensityBlock block;
	read_plane(from, block.density);
	read_plane(from, block.height);
	if (version >= WITH_PLANTS) {
		read_plants(from, block);
	}
	if (version >= WITH_JITTER) {
		read_plane(from, block.scale_jitter);
		read_plane(from, block.color_jitter);
	}
	if (!from.is_sound() || !is_near(map, { column, row })) {
		return false;
	}
	for (std::size_t i = 0; i < DensityBlock::CELLS; i++) {
		const auto x = static_cast<int>(i % DensityBlock::SIDE);
		const auto z = static_cast<int>(i / DensityBlock::SIDE);
		map.set_cell(layer, column * DensityBlock::SIDE + x, row * DensityBlock::SIDE + z,
				{ block.density[i], block.height[i], block.plants[i], block.scale_jitter[i], block.color_jitter[i] });
	}
	return true;
}

bool read_layer(ByteReader &from, uint32_t version, DensityMap &map) {
	const std::string name = from.text();
	const auto blocks = static_cast<uint32_t>(from.number(4));
	const int layer = from.is_sound() && map.find_layer(name) < 0 ? map.need_layer(name) : -1;
	for (uint32_t i = 0; layer >= 0 && i < blocks; i++) {
		if (!read_block(from, version, layer, map)) {
			return false;
		}
	}
	return layer >= 0;
}

} // namespace

const char *describe(DensityFault fault) {
	switch (fault) {
		case DensityFault::none:
			return "The map is sound.";
		case DensityFault::not_a_map:
			return "Its data are no map: restore the file.";
		case DensityFault::later_version:
			return "It was saved by a later release of Undergrowth: update the add-on.";
		case DensityFault::torn:
			return "Its data are incomplete or damaged: restore the file.";
	}
	return "";
}

std::vector<uint8_t> write_density(const DensityMap &map) {
	const uint32_t version = version_of(map);
	std::vector<uint8_t> bytes = ByteFrame::begin(LETTERS, version);
	put_float(bytes, map.cell_size());
	put_number(bytes, static_cast<uint64_t>(map.layer_count()), 2);
	for (int layer = 0; layer < map.layer_count(); layer++) {
		put_text(bytes, map.layer_name(layer));
		put_number(bytes, map.blocks(layer).size(), 4);
		for (const auto &[key, block] : map.blocks(layer)) {
			put_number(bytes, static_cast<uint32_t>(key.column), 4);
			put_number(bytes, static_cast<uint32_t>(key.row), 4);
			put_plane(bytes, block->density);
			put_plane(bytes, block->height);
			if (version >= WITH_PLANTS) {
				put_plants(bytes, *block);
			}
			if (version >= WITH_JITTER) {
				put_plane(bytes, block->scale_jitter);
				put_plane(bytes, block->color_jitter);
			}
		}
	}
	ByteFrame::seal(bytes);
	return bytes;
}

DensityFault read_density(const uint8_t *bytes, std::size_t count, DensityMap &map) {
	if (count == 0) {
		map.clear();
		return DensityFault::none;
	}
	uint32_t version = WITHOUT_PLANTS;
	BytesFault fault = ByteFrame::check(LETTERS, version, bytes, count);
	while (fault == BytesFault::later_version && version < WITH_JITTER) {
		version++;
		fault = ByteFrame::check(LETTERS, version, bytes, count);
	}
	if (fault != BytesFault::none) {
		return static_cast<DensityFault>(fault);
	}
	ByteReader from = ByteFrame::inside(bytes, count);
	const float size = from.real();
	DensityMap made(size);
	if (made.cell_size() != size) {
		return DensityFault::torn;
	}
	const auto layers = static_cast<uint32_t>(from.number(2));
	for (uint32_t i = 0; i < layers; i++) {
		if (!read_layer(from, version, made)) {
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
