#pragma once

#include "base/shared_until_written.hpp"
#include "placement/area.hpp"
#include "placement/chunks.hpp"
#include "placement/plant_id.hpp"

#include <map>
#include <vector>

namespace undergrowth {

/// A plant that was mown and grows back.
struct MownPlant {
	PlantId id = NO_PLANT;
	/// Its height as a fraction of its own, minus EditLog::grown_back().
	double base = 0.0;

	bool operator<(const MownPlant &other) const { return id < other.id; }
};

/// Removed and mown plants of a field, for every later placement. Generated plants are identified by their cells: at
/// another density a plant with its root in the cell of a removed one is removed, too. Stored in squares with
/// copy-on-write: a copy costs by the number of squares. Copies may go to other threads; one object belongs to one
/// thread at a time.
class EditLog {
public:
	static constexpr float SQUARE = 8.0f; ///< m.
	/// Minimum mown height, as a fraction of a plant's own.
	static constexpr float MIN_SHARE = 0.02f;

	struct Square {
		std::vector<PlantId> gone; ///< Ascending, like `mown`. The two lists are disjoint.
		std::vector<MownPlant> mown;
	};
	using Squares = std::map<TileKey, SharedUntilWritten<Square>>;

	bool is_empty() const { return generated.empty() && added.empty(); }

	/// Records plants placed at `spacing` (m) as removed.
	void remove(const std::vector<PlantId> &ids, double spacing);
	/// Records the heights of plants (generated ones placed at `spacing`, m) as fractions of their own height: at least
	/// MIN_SHARE; 1 and more removes the record.
	void mow(const std::vector<PlantId> &ids, const std::vector<float> &shares, double spacing);
	/// Drops the record of an added plant.
	void forget_added(PlantId id) { added.erase(id); }

	/// Grows all mown plants by this fraction of their own height.
	void grow_back(double share) { grown += share; }
	double grown_back() const { return grown; }
	/// Present height for a base, as a fraction of the plant's own height, at most 1.
	float share_of(double base) const;

	/// True if a generated plant with this root (m) is removed.
	bool is_gone(float x, float z) const;
	/// Present height of a plant with this id and root (m), as a fraction of its own height.
	float share_of(PlantId id, float x, float z) const;
	/// True if a generated plant is mown in the box.
	bool has_mown(const AreaBox &box) const;
	/// The base of a mown plant, or null.
	const double *find_mown(PlantId id, float x, float z) const;

	/// Removes recorded plants from a placement.
	void take_out(FieldPlants &plants) const;
	/// A copy of the records within a box.
	EditLog cut(const AreaBox &box) const;
	/// Boxes of the cells of plants that are removed here and not in `other`.
	std::vector<AreaBox> gone_beside(const EditLog &other) const;

	/// Records of generated plants by the spacing (m) of their placement.
	const std::map<double, Squares> &of_generated() const { return generated; }
	/// Bases of added plants.
	const std::map<PlantId, double> &of_added() const { return added; }
	/// Heap, of what no copy shares.
	int plant_count() const;

private:
	std::map<double, Squares> generated;
	std::map<PlantId, double> added;
	double grown = 0.0;
};

} // namespace undergrowth
