#pragma once

#include "placement/area.hpp"
#include "placement/chunks.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace undergrowth {

/// Painted values of one cell for one species. Two densities add up there: a fraction of the species' part in the
/// field's mix, and a number of plants/m² that is independent of the mix.
struct DensityCell {
	static constexpr uint8_t MAX_DENSITY = 255; ///< Means 1; 0 means nothing.
	static constexpr uint8_t USUAL_HEIGHT = 64; ///< Means 1.
	static constexpr uint8_t MIN_HEIGHT = 4; ///< 1/16.

	static constexpr uint16_t MAX_PLANTS = 65535; ///< Means MAX_PLANT_DENSITY.
	static constexpr float MAX_PLANT_DENSITY = 1.0e4f; ///< Plants/m².

	static constexpr uint8_t MAX_JITTER = 255; ///< Means 1.
	static constexpr float MAX_SCALE_JITTER = 0.9f; ///< Every plant remains larger than 0.

	uint8_t density = 0; ///< Fraction of the mix.
	uint8_t height = USUAL_HEIGHT;
	uint16_t plants = 0; ///< Square root of the plants/m², for equal relative precision of sparse and dense values.
	uint8_t scale_jitter = 0; ///< MAX_JITTER means 1.
	uint8_t color_jitter = 0;

	bool operator==(const DensityCell &other) const {
		return density == other.density && height == other.height && plants == other.plants &&
				scale_jitter == other.scale_jitter && color_jitter == other.color_jitter;
	}
	bool operator!=(const DensityCell &other) const { return !(*this == other); }
	/// 0 to 1.
	float share() const { return static_cast<float>(density) / static_cast<float>(MAX_DENSITY); }
	/// 1/16 to 255/64.
	float height_factor() const { return static_cast<float>(height) / static_cast<float>(USUAL_HEIGHT); }
	/// Plants/m², in addition to the mix.
	float plant_density() const {
		const float root = static_cast<float>(plants) / static_cast<float>(MAX_PLANTS);
		return root * root * MAX_PLANT_DENSITY;
	}
	/// 0 to MAX_SCALE_JITTER: scales are multiplied by 1 ± this, in addition to the species' own range.
	float scale_range() const { return static_cast<float>(scale_jitter) / static_cast<float>(MAX_JITTER); }
	/// 0 to 1: strength of random colors.
	float color_range() const { return static_cast<float>(color_jitter) / static_cast<float>(MAX_JITTER); }
};

/// A square of SIDE by SIDE cells: the unit of allocation.
struct DensityBlock {
	static constexpr int SIDE = 32;
	static constexpr std::size_t CELLS = static_cast<std::size_t>(SIDE) * SIDE;

	std::array<uint8_t, CELLS> density; ///< Row by row, by increasing x.
	std::array<uint8_t, CELLS> height; ///< In the same order.
	std::array<uint16_t, CELLS> plants; ///< In the same order.
	std::array<uint8_t, CELLS> scale_jitter; ///< In the same order.
	std::array<uint8_t, CELLS> color_jitter; ///< In the same order.
	/// False: all of `plants` are 0. True: they may be 0, too.
	bool may_have_plants = false;

	DensityBlock();
	/// True if nothing is painted in it.
	bool is_empty() const;
};

/// A range of cells, from the first to the last of both coordinates.
struct CellRange {
	int first_column = 0;
	int first_row = 0;
	int last_column = -1;
	int last_row = -1;

	bool is_empty() const { return last_column < first_column || last_row < first_row; }
	double count() const;
	bool operator==(const CellRange &other) const;
	/// Extends the range to contain `other`.
	void take_in(const CellRange &other);
};

/// The painted density map of a field. For each species it has a layer with that species' name: density, plants/m²,
/// height and jitter of scale and color by position. Cells are squares in the field's axes (x, z), up to
/// FARTHEST_COORDINATE on all sides. Only painted blocks exist. Unpainted cells have a density of 0.
///
/// Only one thread may change a map. The results of share() and cut() have the same cells at low cost. They can be read
/// on any thread and do not change with the map.
class DensityMap {
public:
	static constexpr float MIN_CELL = 0.25f; ///< m.
	static constexpr float MAX_CELL = 2.0f;
	static constexpr float USUAL_CELL = 0.5f;
	static constexpr int MAX_LAYERS = 256;
	static constexpr std::size_t MAX_NAME = 255; ///< Bytes.

	using Blocks = std::map<TileKey, std::shared_ptr<const DensityBlock>>;

	/// Creates an empty map with cells of `cell_size` (m), clamped to MIN_CELL to MAX_CELL.
	explicit DensityMap(float cell_size = USUAL_CELL);
	DensityMap(DensityMap &&) = default;
	DensityMap &operator=(DensityMap &&) = default;

	float cell_size() const { return size; }
	/// Side of a block (m).
	float block_size() const { return size * DensityBlock::SIDE; }
	int layer_count() const { return static_cast<int>(layers.size()); }
	const std::string &layer_name(int layer) const { return at(layer).name; }
	/// Returns -1 if no layer has that name.
	int find_layer(const std::string &name) const;
	/// Returns the layer of that name and creates it if necessary. Returns -1 if the name is empty or longer than
	/// MAX_NAME, or if there are MAX_LAYERS.
	int need_layer(const std::string &name);
	/// Later layers move up.
	void remove_layer(int layer);
	void clear();

	/// The cells that meet a box (m), its sides included, within FARTHEST_COORDINATE.
	CellRange cells_around(const AreaBox &box) const;
	/// m, from the lower side of the first cell to the upper side of the last.
	AreaBox box_of(const CellRange &cells) const;
	/// m.
	glm::vec2 middle_of(int column, int row) const;
	DensityCell cell(int layer, int column, int row) const;
	DensityCell cell_at(int layer, const glm::vec2 &place) const;
	/// For cells that cells_around() can return.
	void set_cell(int layer, int column, int row, const DensityCell &cell);
	/// Sets these cells of all layers to their values in a map with cells of the same size. Layers that it lacks become
	/// empty there. Returns a range that contains the changed cells.
	CellRange take(const DensityMap &from, const CellRange &cells);
	/// Frees empty blocks that meet these cells.
	void tidy(int layer, const CellRange &cells);

	/// Blocks of a layer, by position in units of blocks.
	const Blocks &blocks(int layer) const { return at(layer).blocks; }
	int block_count() const;
	/// False: the layer has no cell with plants/m². True: it may have some.
	bool may_have_plants(int layer) const;
	/// All cells of all blocks; empty if nothing is painted.
	CellRange painted() const;

	DensityMap share() const;
	/// Returns the same layers with the blocks that meet the cells.
	DensityMap cut(const CellRange &cells) const;

private:
	struct Layer {
		std::string name;
		Blocks blocks;
		/// Blocks that no other map shares; they may be written.
		mutable std::map<TileKey, DensityBlock *> own;
	};

	float size;
	std::vector<Layer> layers;

	const Layer &at(int layer) const { return layers[static_cast<std::size_t>(layer)]; }
	DensityBlock &need_block(Layer &layer, const TileKey &key);
};

/// Key of the block that contains a cell.
TileKey density_block_of(int column, int row);

} // namespace undergrowth
