#pragma once

#include "base/shared_until_written.hpp"
#include "stand/area.hpp"
#include "stand/blocks.hpp"
#include "stand/plant_id.hpp"

#include <map>
#include <vector>

namespace undergrowth {

/// A plant that was mown and grows back.
struct MownPlant {
	PlantId id = NO_PLANT;
	/// How high it is, as a share of its own height, less StandChanges::grown_back().
	double base = 0.0;

	bool operator<(const MownPlant &other) const { return id < other.id; }
};

/// What was done to the plants that a field was filled with, so that it stays done when they are placed anew: who is
/// gone, and who is mown. Plants are known by their cells: at another density, whoever has its root in the cell of one
/// that is gone is gone, too. Kept in squares that copies share until one of them writes: copying costs by squares.
/// Copies may go to other threads; one object is for one thread at a time.
class StandChanges {
public:
	static constexpr float SQUARE = 8.0f; ///< m.
	/// Of a plant's own height: nobody is mown lower.
	static constexpr float LEAST_SHARE = 0.02f;

	struct Square {
		std::vector<PlantId> gone; ///< Ascending, as `mown`. Nobody is in both.
		std::vector<MownPlant> mown;
	};
	using Squares = std::map<TileKey, SharedUntilWritten<Square>>;

	bool is_empty() const { return filled.empty() && added.empty(); }

	/// Plants that were filled at `spacing` (m) are gone.
	void remove(const std::vector<PlantId> &ids, double spacing);
	/// Plants, filled ones at `spacing` (m), are so high, as a share of their own height: at least LEAST_SHARE, and of
	/// 1 and more they are as if they had never been mown.
	void mow(const std::vector<PlantId> &ids, const std::vector<float> &shares, double spacing);
	/// Nobody knows of a plant that was added any more.
	void forget_added(PlantId id) { added.erase(id); }

	/// All that is mown grows by this share of its own height.
	void grow_back(double share) { grown += share; }
	double grown_back() const { return grown; }
	/// How high a plant whose base is that is now, as a share of its own height, at most 1.
	float share_of(double base) const;

	/// Whether a plant that is filled with this root (m) is gone.
	bool is_gone(float x, float z) const;
	/// How high a plant of this name and root (m) is, as a share of its own height.
	float share_of(PlantId id, float x, float z) const;
	/// Whether any that was filled is mown in a box.
	bool has_mown(const AreaBox &box) const;
	/// The base of a plant that is mown, or null.
	const double *find_mown(PlantId id, float x, float z) const;

	/// Takes those who are gone out of plants that were placed.
	void take_out(FieldPlants &plants) const;
	/// What matters in a box.
	StandChanges cut(const AreaBox &box) const;
	/// Boxes around the cells of whom is gone here and not in `other`.
	std::vector<AreaBox> gone_beside(const StandChanges &other) const;

	/// By the spacing (m) that plants were filled at.
	const std::map<double, Squares> &of_filled() const { return filled; }
	/// Of plants that were added: their bases.
	const std::map<PlantId, double> &of_added() const { return added; }
	/// Heap, of what no copy shares.
	int plant_count() const;

private:
	std::map<double, Squares> filled;
	std::map<PlantId, double> added;
	double grown = 0.0;
};

} // namespace undergrowth
