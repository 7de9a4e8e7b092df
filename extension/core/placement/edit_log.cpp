#include "placement/edit_log.hpp"

#include "placement/edit_finder.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace undergrowth {

namespace {

TileKey square_of(PlantId id, double spacing) {
	float x = 0.0f;
	float z = 0.0f;
	generated_plant_position(id, spacing, x, z);
	return tile_at(x, z, EditLog::SQUARE);
}

const EditLog::Square *find_square(const EditLog::Squares &squares, PlantId id, double spacing) {
	const auto found = squares.find(square_of(id, spacing));
	return found == squares.end() ? nullptr : &*found->second;
}

bool holds(const std::vector<PlantId> &ascending, PlantId id) {
	return std::binary_search(ascending.begin(), ascending.end(), id);
}

const double *find_base(const std::vector<MownPlant> &ascending, PlantId id) {
	const auto found = std::lower_bound(ascending.begin(), ascending.end(), MownPlant{ id, 0.0 });
	return found != ascending.end() && found->id == id ? &found->base : nullptr;
}

/// Sorts `entries` and calls visit(square's key, first, end) for each run of them in one square.
template <class Entry, class Visit>
void for_each_square(std::vector<std::pair<TileKey, Entry>> &entries, const Visit &visit) {
	std::sort(entries.begin(), entries.end());
	for (auto first = entries.begin(); first != entries.end();) {
		const auto end =
				std::find_if(first, entries.end(), [&](const auto &entry) { return !(entry.first == first->first); });
		visit(first->first, first, end);
		first = end;
	}
}

/// Extends the box of a cell's square by the possible distance of a plant of the cell.
AreaBox wider(const AreaBox &box, double spacing) {
	const auto reach = static_cast<float>(spacing);
	return { box.low - reach, box.high + reach };
}

} // namespace

void EditLog::remove(const std::vector<PlantId> &ids, double spacing) {
	std::vector<std::pair<TileKey, PlantId>> entries;
	entries.reserve(ids.size());
	for (const PlantId id : ids) {
		if (!is_added(id)) {
			entries.emplace_back(square_of(id, spacing), id);
		}
	}
	for_each_square(entries, [&](const TileKey &key, auto first, auto end) {
		Square &square = generated[spacing][key].own();
		const auto before = static_cast<std::ptrdiff_t>(square.gone.size());
		std::transform(first, end, std::back_inserter(square.gone), [](const auto &entry) { return entry.second; });
		std::inplace_merge(square.gone.begin(), square.gone.begin() + before, square.gone.end());
		square.gone.erase(std::unique(square.gone.begin(), square.gone.end()), square.gone.end());
		const auto is_gone_now = [&](const MownPlant &plant) { return holds(square.gone, plant.id); };
		square.mown.erase(std::remove_if(square.mown.begin(), square.mown.end(), is_gone_now), square.mown.end());
	});
}

void EditLog::mow(const std::vector<PlantId> &ids, const std::vector<float> &shares, double spacing) {
	std::vector<std::pair<TileKey, MownPlant>> entries;
	for (std::size_t i = 0; i < ids.size(); i++) {
		const double base = static_cast<double>(std::max(shares[i], MIN_SHARE)) - grown;
		if (!is_added(ids[i])) {
			entries.emplace_back(square_of(ids[i], spacing), MownPlant{ ids[i], base });
		} else if (shares[i] < 1.0f) {
			added[ids[i]] = base;
		} else {
			added.erase(ids[i]);
		}
	}
	for_each_square(entries, [&](const TileKey &key, auto first, auto end) {
		Square &square = generated[spacing][key].own();
		std::vector<MownPlant> mown; // Newly mown plants come first, so that they override old records.
		std::transform(first, end, std::back_inserter(mown), [](const auto &entry) { return entry.second; });
		mown.insert(mown.end(), square.mown.begin(), square.mown.end());
		std::stable_sort(mown.begin(), mown.end());
		const auto are_one = [](const MownPlant &a, const MownPlant &b) { return a.id == b.id; };
		mown.erase(std::unique(mown.begin(), mown.end(), are_one), mown.end());
		const auto is_whole = [this](const MownPlant &plant) { return plant.base + grown >= 1.0; };
		mown.erase(std::remove_if(mown.begin(), mown.end(), is_whole), mown.end());
		square.mown = std::move(mown);
	});
}

float EditLog::share_of(double base) const {
	return static_cast<float>(std::clamp(base + grown, 0.0, 1.0));
}

bool EditLog::is_gone(float x, float z) const {
	return std::any_of(generated.begin(), generated.end(), [&](const auto &of_spacing) {
		const PlantId id = generated_plant_id(x, z, of_spacing.first);
		const Square *square = find_square(of_spacing.second, id, of_spacing.first);
		return square != nullptr && holds(square->gone, id);
	});
}

const double *EditLog::find_mown(PlantId id, float x, float z) const {
	if (is_added(id)) {
		const auto found = added.find(id);
		return found == added.end() ? nullptr : &found->second;
	}
	for (const auto &[spacing, squares] : generated) {
		const PlantId cell = generated_plant_id(x, z, spacing);
		const Square *square = find_square(squares, cell, spacing);
		const double *base = square != nullptr ? find_base(square->mown, cell) : nullptr;
		if (base != nullptr) {
			return base;
		}
	}
	return nullptr;
}

float EditLog::share_of(PlantId id, float x, float z) const {
	const double *base = find_mown(id, x, z);
	return base != nullptr ? share_of(*base) : 1.0f;
}

bool EditLog::has_mown(const AreaBox &box) const {
	const EditLog near = cut(box);
	return std::any_of(near.generated.begin(), near.generated.end(), [](const auto &of_spacing) {
		const auto is_mown = [](const auto &entry) { return !entry.second->mown.empty(); };
		return std::any_of(of_spacing.second.begin(), of_spacing.second.end(), is_mown);
	});
}

void EditLog::take_out(FieldPlants &plants) const {
	std::vector<int> gone;
	EditFinder finder(*this);
	for (int i = 0; i < plants.size() && !generated.empty(); i++) {
		if (finder.is_gone(plants.x[static_cast<std::size_t>(i)], plants.z[static_cast<std::size_t>(i)])) {
			gone.push_back(i);
		}
	}
	if (!gone.empty()) {
		plants.remove(gone);
	}
}

EditLog EditLog::cut(const AreaBox &box) const {
	EditLog made;
	made.grown = grown;
	for (const auto &[spacing, squares] : generated) {
		const AreaBox around = wider(box, spacing);
		const TileKey first = tile_at(around.low.x, around.low.y, SQUARE);
		const TileKey last = tile_at(around.high.x, around.high.y, SQUARE);
		auto square = squares.lower_bound(first);
		while (square != squares.end() && square->first.column <= last.column) {
			if (square->first.row < first.row) {
				square = squares.lower_bound({ square->first.column, first.row });
			} else if (square->first.row > last.row) {
				square = squares.lower_bound({ square->first.column + 1, first.row });
			} else {
				made.generated[spacing].insert(*square++);
			}
		}
	}
	return made;
}

std::vector<AreaBox> EditLog::gone_beside(const EditLog &other) const {
	std::vector<AreaBox> boxes;
	for (const auto &[spacing, squares] : generated) {
		for (const auto &entry : squares) {
			for (const PlantId id : entry.second->gone) {
				float x = 0.0f;
				float z = 0.0f;
				generated_plant_position(id, spacing, x, z);
				const auto known = other.generated.find(spacing);
				const Square *square =
						known == other.generated.end() ? nullptr : find_square(known->second, id, spacing);
				if (square == nullptr || !holds(square->gone, id)) {
					boxes.push_back(wider({ { x, z }, { x, z } }, spacing));
				}
			}
		}
	}
	return boxes;
}

int EditLog::plant_count() const {
	std::size_t count = added.size();
	for (const auto &of_spacing : generated) {
		for (const auto &square : of_spacing.second) {
			count += square.second->gone.size() + square.second->mown.size();
		}
	}
	return static_cast<int>(count);
}

} // namespace undergrowth
