#pragma once

#include "stand/area.hpp"
#include "stand/blocks.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace undergrowth {

/// What is painted in one cell for one species. The species grows there as the sum of two: a share of what the field's
/// mix gives it, and a number of plants/m² that no mix changes.
struct DensityCell {
	static constexpr uint8_t MOST_DENSITY = 255; ///< Stands for 1; 0 for nothing.
	static constexpr uint8_t USUAL_HEIGHT = 64; ///< Stands for 1.
	static constexpr uint8_t LEAST_HEIGHT = 4; ///< 1/16.

	static constexpr uint16_t MAX_PLANTS = 65535; ///< Stands for MAX_PLANT_DENSITY.
	static constexpr float MAX_PLANT_DENSITY = 1.0e4f; ///< Plants/m².

	uint8_t density = 0; ///< The share of the mix.
	uint8_t height = USUAL_HEIGHT;
	uint16_t plants = 0; ///< The square root of the plants/m², so that sparse and dense ones are equally exact.

	bool operator==(const DensityCell &other) const {
		return density == other.density && height == other.height && plants == other.plants;
	}
	bool operator!=(const DensityCell &other) const { return !(*this == other); }
	/// 0 to 1.
	float share() const { return static_cast<float>(density) / static_cast<float>(MOST_DENSITY); }
	/// 1/16 to 255/64.
	float height_factor() const { return static_cast<float>(height) / static_cast<float>(USUAL_HEIGHT); }
	/// Plants/m², beside the share.
	float plant_density() const {
		const float root = static_cast<float>(plants) / static_cast<float>(MAX_PLANTS);
		return root * root * MAX_PLANT_DENSITY;
	}
};

/// A square of SIDE by SIDE cells: what is allocated at once.
struct DensityBlock {
	static constexpr int SIDE = 32;
	static constexpr std::size_t CELLS = static_cast<std::size_t>(SIDE) * SIDE;

	std::array<uint8_t, CELLS> density; ///< Row by row, by increasing x.
	std::array<uint8_t, CELLS> height; ///< Alike.
	std::array<uint16_t, CELLS> plants; ///< Alike.
	/// False: all of `plants` are 0. They may be 0 where it is true.
	bool may_have_plants = false;

	DensityBlock();
	/// Whether nothing is painted in it.
	bool is_empty() const;
};

/// Cells, from the first to the last of both coordinates.
struct CellRange {
	int first_column = 0;
	int first_row = 0;
	int last_column = -1;
	int last_row = -1;

	bool is_empty() const { return last_column < first_column || last_row < first_row; }
	double count() const;
	bool operator==(const CellRange &other) const;
	/// Widens it, so that it holds the other, too.
	void take_in(const CellRange &other);
};

/// What users painted into a field: for each species, named by its layer, how much of it grows where and how high.
/// Square cells in the field's axes (x, z), up to FARTHEST_COORDINATE on all sides; blocks of them are there where
/// something is painted. What is not painted has a density of 0.
///
/// A map is changed on one thread. What share() and cut() give has the same cells, costs little, may be read on any
/// thread, and stays as it is while the map is changed.
class DensityMap {
public:
	static constexpr float LEAST_CELL = 0.25f; ///< m.
	static constexpr float MOST_CELL = 2.0f;
	static constexpr float USUAL_CELL = 0.5f;
	static constexpr int MOST_LAYERS = 256;
	static constexpr std::size_t MOST_NAME = 255; ///< Bytes.

	using Blocks = std::map<TileKey, std::shared_ptr<const DensityBlock>>;

	/// Cells of `cell_size` (m), brought into the range from LEAST_CELL to MOST_CELL.
	explicit DensityMap(float cell_size = USUAL_CELL);
	DensityMap(DensityMap &&) = default;
	DensityMap &operator=(DensityMap &&) = default;

	float cell_size() const { return size; }
	/// The side of a block (m).
	float block_size() const { return size * DensityBlock::SIDE; }
	int layer_count() const { return static_cast<int>(layers.size()); }
	const std::string &layer_name(int layer) const { return at(layer).name; }
	/// -1 where there is none of that name.
	int find_layer(const std::string &name) const;
	/// The layer of that name, which is made where there is none; -1 where the name is empty or longer than MOST_NAME,
	/// or there are MOST_LAYERS.
	int need_layer(const std::string &name);
	/// Those after it move up.
	void remove_layer(int layer);
	void clear();

	/// The cells around a box (m), its sides included; what is beyond FARTHEST_COORDINATE is left out.
	CellRange cells_around(const AreaBox &box) const;
	/// m, from the first cell's lower side to the last one's upper side.
	AreaBox box_of(const CellRange &cells) const;
	/// m.
	glm::vec2 middle_of(int column, int row) const;
	DensityCell cell(int layer, int column, int row) const;
	DensityCell cell_at(int layer, const glm::vec2 &place) const;
	/// For cells that cells_around() can give.
	void set_cell(int layer, int column, int row, const DensityCell &cell);
	/// Sets these cells of all layers as they are in a map of cells of the same size; layers that it lacks are empty
	/// there. Tells which cells changed.
	CellRange take(const DensityMap &from, const CellRange &cells);
	/// Frees the blocks that meet these cells and hold nothing any more.
	void tidy(int layer, const CellRange &cells);

	/// Those of a layer, by their place among blocks.
	const Blocks &blocks(int layer) const { return at(layer).blocks; }
	int block_count() const;
	/// False: the layer has no cell with plants/m². True says nothing.
	bool may_have_plants(int layer) const;
	/// All cells of all blocks; empty where nothing is painted.
	CellRange painted() const;

	DensityMap share() const;
	/// The same layers, with what of them meets the cells.
	DensityMap cut(const CellRange &cells) const;

private:
	struct Layer {
		std::string name;
		Blocks blocks;
		/// The blocks that nobody else has, to be written to.
		mutable std::map<TileKey, DensityBlock *> own;
	};

	float size;
	std::vector<Layer> layers;

	const Layer &at(int layer) const { return layers[static_cast<std::size_t>(layer)]; }
	DensityBlock &need_block(Layer &layer, const TileKey &key);
};

/// The block that holds a cell.
TileKey density_block_of(int column, int row);

} // namespace undergrowth
