#include "placement/density_map.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr int SIDE = DensityBlock::SIDE;

int floor_div(int value, int by) {
	return value / by - static_cast<int>(value % by < 0);
}

std::size_t index_of(int column, int row, const TileKey &block) {
	return static_cast<std::size_t>(row - block.row * SIDE) * SIDE +
			static_cast<std::size_t>(column - block.column * SIDE);
}

int cell_of(double place, double size) {
	const double max = static_cast<double>(FARTHEST_COORDINATE);
	return static_cast<int>(std::floor(std::clamp(place, -max, max) / size));
}

} // namespace

DensityBlock::DensityBlock() {
	density.fill(0);
	height.fill(DensityCell::USUAL_HEIGHT);
	plants.fill(0);
	scale_jitter.fill(0);
	color_jitter.fill(0);
}

bool DensityBlock::is_empty() const {
	const auto is_usual = [](uint8_t code) { return code == DensityCell::USUAL_HEIGHT; };
	const auto is_zero = [](int code) { return code == 0; };
	return std::all_of(density.begin(), density.end(), is_zero) && std::all_of(plants.begin(), plants.end(), is_zero) &&
			std::all_of(height.begin(), height.end(), is_usual) &&
			std::all_of(scale_jitter.begin(), scale_jitter.end(), is_zero) &&
			std::all_of(color_jitter.begin(), color_jitter.end(), is_zero);
}

double CellRange::count() const {
	return is_empty() ? 0.0 : (last_column - first_column + 1.0) * (last_row - first_row + 1.0);
}

bool CellRange::operator==(const CellRange &other) const {
	return first_column == other.first_column && first_row == other.first_row && last_column == other.last_column &&
			last_row == other.last_row;
}

void CellRange::take_in(const CellRange &other) {
	if (is_empty()) {
		*this = other;
	} else if (!other.is_empty()) {
		first_column = std::min(first_column, other.first_column);
		first_row = std::min(first_row, other.first_row);
		last_column = std::max(last_column, other.last_column);
		last_row = std::max(last_row, other.last_row);
	}
}

TileKey density_block_of(int column, int row) {
	return { floor_div(column, SIDE), floor_div(row, SIDE) };
}

DensityMap::DensityMap(float cell_size) :
		size(std::isfinite(cell_size) ? std::clamp(cell_size, MIN_CELL, MAX_CELL) : USUAL_CELL) {}

int DensityMap::find_layer(const std::string &name) const {
	for (int i = 0; i < layer_count(); i++) {
		if (layer_name(i) == name) {
			return i;
		}
	}
	return -1;
}

int DensityMap::need_layer(const std::string &name) {
	const int found = find_layer(name);
	if (found >= 0 || name.empty() || name.size() > MAX_NAME || layer_count() == MAX_LAYERS) {
		return found;
	}
	layers.push_back({ name, {}, {} });
	return layer_count() - 1;
}

void DensityMap::remove_layer(int layer) {
	layers.erase(layers.begin() + layer);
}

void DensityMap::clear() {
	layers.clear();
}

CellRange DensityMap::cells_around(const AreaBox &box) const {
	const double side = size;
	const double max = static_cast<double>(FARTHEST_COORDINATE);
	const bool is_anywhere = box.low.x <= box.high.x && box.low.y <= box.high.y &&
			static_cast<double>(box.low.x) <= max && static_cast<double>(box.low.y) <= max &&
			static_cast<double>(box.high.x) >= -max && static_cast<double>(box.high.y) >= -max;
	if (!is_anywhere) {
		return {};
	}
	return { cell_of(box.low.x, side), cell_of(box.low.y, side), cell_of(box.high.x, side), cell_of(box.high.y, side) };
}

AreaBox DensityMap::box_of(const CellRange &cells) const {
	if (cells.is_empty()) {
		return {};
	}
	return { { static_cast<float>(cells.first_column) * size, static_cast<float>(cells.first_row) * size },
		{ static_cast<float>(cells.last_column + 1) * size, static_cast<float>(cells.last_row + 1) * size } };
}

glm::vec2 DensityMap::middle_of(int column, int row) const {
	return { (static_cast<float>(column) + 0.5f) * size, (static_cast<float>(row) + 0.5f) * size };
}

DensityCell DensityMap::cell(int layer, int column, int row) const {
	const TileKey key = density_block_of(column, row);
	const auto found = at(layer).blocks.find(key);
	if (found == at(layer).blocks.end()) {
		return {};
	}
	const std::size_t i = index_of(column, row, key);
	const DensityBlock &block = *found->second;
	return { block.density[i], block.height[i], block.plants[i], block.scale_jitter[i], block.color_jitter[i] };
}

DensityCell DensityMap::cell_at(int layer, const glm::vec2 &place) const {
	return cell(layer, cell_of(place.x, size), cell_of(place.y, size));
}

/// Returns a block for writing that only this map owns; copies it first if it is shared.
DensityBlock &DensityMap::need_block(Layer &layer, const TileKey &key) {
	const auto own = layer.own.find(key);
	if (own != layer.own.end()) {
		return *own->second;
	}
	std::shared_ptr<const DensityBlock> &there = layer.blocks[key];
	auto made = there ? std::make_shared<DensityBlock>(*there) : std::make_shared<DensityBlock>();
	DensityBlock &block = *made;
	there = std::move(made);
	layer.own[key] = &block;
	return block;
}

void DensityMap::set_cell(int layer, int column, int row, const DensityCell &wanted) {
	if (cell(layer, column, row) == wanted) {
		return;
	}
	const TileKey key = density_block_of(column, row);
	DensityBlock &block = need_block(layers[static_cast<std::size_t>(layer)], key);
	const std::size_t i = index_of(column, row, key);
	block.density[i] = wanted.density;
	block.height[i] = std::max(wanted.height, DensityCell::MIN_HEIGHT);
	block.plants[i] = wanted.plants;
	block.scale_jitter[i] = wanted.scale_jitter;
	block.color_jitter[i] = wanted.color_jitter;
	block.may_have_plants = block.may_have_plants || wanted.plants > 0;
}

CellRange DensityMap::take(const DensityMap &from, const CellRange &cells) {
	CellRange changed;
	for (int other = 0; other < from.layer_count(); other++) {
		need_layer(from.layer_name(other));
	}
	for (int layer = 0; layer < layer_count(); layer++) {
		const int other = from.find_layer(layer_name(layer));
		for (int row = cells.first_row; row <= cells.last_row; row++) {
			for (int column = cells.first_column; column <= cells.last_column; column++) {
				const DensityCell wanted = other < 0 ? DensityCell() : from.cell(other, column, row);
				if (wanted != cell(layer, column, row)) {
					set_cell(layer, column, row, wanted);
					changed.take_in({ column, row, column, row });
				}
			}
		}
		tidy(layer, cells);
	}
	return changed;
}

void DensityMap::tidy(int layer, const CellRange &cells) {
	Layer &there = layers[static_cast<std::size_t>(layer)];
	const TileKey first = density_block_of(cells.first_column, cells.first_row);
	const TileKey last = density_block_of(cells.last_column, cells.last_row);
	for (auto block = there.blocks.lower_bound(first);
			block != there.blocks.end() && block->first.column <= last.column && !cells.is_empty();) {
		const bool is_near = block->first.row >= first.row && block->first.row <= last.row;
		if (is_near && block->second->is_empty()) {
			there.own.erase(block->first);
			block = there.blocks.erase(block);
		} else {
			++block;
		}
	}
}

int DensityMap::block_count() const {
	std::size_t count = 0;
	for (const Layer &layer : layers) {
		count += layer.blocks.size();
	}
	return static_cast<int>(count);
}

bool DensityMap::may_have_plants(int layer) const {
	const Blocks &there = at(layer).blocks;
	return std::any_of(there.begin(), there.end(), [](const auto &entry) { return entry.second->may_have_plants; });
}

CellRange DensityMap::painted() const {
	CellRange all;
	for (const Layer &layer : layers) {
		for (const auto &[key, block] : layer.blocks) {
			all.take_in({ key.column * SIDE, key.row * SIDE, key.column * SIDE + SIDE - 1, key.row * SIDE + SIDE - 1 });
		}
	}
	return all;
}

DensityMap DensityMap::share() const {
	DensityMap shared(size);
	for (const Layer &layer : layers) {
		layer.own.clear();
		shared.layers.push_back({ layer.name, layer.blocks, {} });
	}
	return shared;
}

DensityMap DensityMap::cut(const CellRange &cells) const {
	DensityMap part(size);
	const TileKey first = density_block_of(cells.first_column, cells.first_row);
	const TileKey last = density_block_of(cells.last_column, cells.last_row);
	for (const Layer &layer : layers) {
		part.layers.push_back({ layer.name, {}, {} });
		for (auto block = layer.blocks.lower_bound(first);
				block != layer.blocks.end() && block->first.column <= last.column && !cells.is_empty(); ++block) {
			if (block->first.row >= first.row && block->first.row <= last.row) {
				layer.own.erase(block->first);
				part.layers.back().blocks.insert(*block);
			}
		}
	}
	return part;
}

} // namespace undergrowth
