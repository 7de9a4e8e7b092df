#include "placement/plant_store.hpp"

#include "placement/curve_key.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

namespace undergrowth {

ChangeSet PlantStore::apply(StoreEdit &&edit) {
	ChangeSet changes;
	cell_size = edit.spacing > 0.0 ? edit.spacing : cell_size;
	if (edit.replaces_all) {
		drop_generated(changes);
		rename_species(edit.species_numbers);
		const bool is_recut = edit.tile_size != size;
		size = edit.tile_size;
		for (PlantChunk &chunk : edit.generated) {
			insert(std::move(chunk), changes);
		}
		if (is_recut) {
			recut_added(changes);
		}
	}
	for (std::size_t i = 0; i < edit.grown.size(); i++) {
		const PlantRef ref = grow(edit.grown[i], changes);
		if (edit.grown_from[i].chunk >= 0) {
			changes.moved.push_back({ edit.grown_from[i], ref });
		}
	}
	for (const ChangeSet::Moved &plant : changes.moved) {
		remove(plant.from, changes);
	}
	for (const PlantRef &ref : edit.removed) {
		remove(ref, changes);
	}
	// If an edit removes the last plant of a chunk, the chunk is reported and its earlier removals are not.
	const auto is_empty = [this](const PlantRef &ref) { return chunk(ref.chunk).size() == 0; };
	changes.gone.erase(std::remove_if(changes.gone.begin(), changes.gone.end(), is_empty), changes.gone.end());
	for (const TileKey &tile : edit.left_tiles) {
		leave(tile, changes);
	}
	for (PlantChunk &chunk : edit.arriving) {
		insert(std::move(chunk), changes);
	}
	for (std::size_t i = 0; i < edit.added.size(); i++) {
		const PlantId id = i < edit.added_ids.size() ? edit.added_ids[i] : added_plant_id(next_added);
		next_added = std::max(next_added, added_plant_number(id) + 1);
		changes.added.push_back(id);
		add(edit.added[i], id, changes);
	}
	return changes;
}

std::shared_ptr<const PlantChunk> PlantStore::share(int number) const {
	shared_chunks.insert(number);
	return chunks[static_cast<std::size_t>(number)];
}

// A mark, because a reference count of 1 does not order the reads of another thread before the change.
PlantChunk &PlantStore::own(int number) {
	std::shared_ptr<PlantChunk> &chunk = chunks[static_cast<std::size_t>(number)];
	if (shared_chunks.erase(number) > 0 || chunk.use_count() > 1) {
		chunk = std::make_shared<PlantChunk>(*chunk);
	}
	return *chunk;
}

int PlantStore::take_number() {
	if (free_numbers.empty()) {
		chunks.push_back(std::make_shared<PlantChunk>());
		return chunk_count() - 1;
	}
	const int number = free_numbers.back();
	free_numbers.pop_back();
	return number;
}

void PlantStore::insert(PlantChunk &&chunk, ChangeSet &changes) {
	const int number = take_number();
	plant_total += chunk.live_count();
	chunk.spacing = cell_size;
	spacings[cell_size]++;
	tiles[chunk.tile].push_back(number);
	chunks[static_cast<std::size_t>(number)] = std::make_shared<PlantChunk>(std::move(chunk));
	changes.grown.push_back({ number, 0 });
}

void PlantStore::drop(int number, ChangeSet &changes) {
	std::shared_ptr<PlantChunk> &there = chunks[static_cast<std::size_t>(number)];
	const PlantChunk &chunk = *there;
	const auto tile = tiles.find(chunk.tile);
	std::vector<int> &members = tile->second;
	members.erase(std::find(members.begin(), members.end(), number));
	if (members.empty()) {
		tiles.erase(tile);
	}
	for (const PlantId id : chunk.ids) {
		added_refs.erase(id);
	}
	plant_total -= chunk.live_count();
	const auto same = spacings.find(chunk.spacing);
	if (same != spacings.end() && --same->second == 0) {
		spacings.erase(same);
	}
	shared_chunks.erase(number);
	changes.left.push_back(std::exchange(there, std::make_shared<PlantChunk>()));
	free_numbers.push_back(number);
	changes.dropped.push_back(number);
}

void PlantStore::drop_generated(ChangeSet &changes) {
	// From the last, so that take_number() returns the lowest first and an equal rebuild has equal numbers.
	for (int number = chunk_count() - 1; number >= 0; number--) {
		if (chunk(number).size() > 0 && !chunk(number).is_added) {
			drop(number, changes);
		}
	}
}

void PlantStore::leave(const TileKey &tile, ChangeSet &changes) {
	const std::vector<int> members = chunks_of(tile);
	for (const int number : members) {
		if (!chunk(number).is_added) {
			drop(number, changes);
		}
	}
}

void PlantStore::rename_species(const std::vector<int> &numbers) {
	for (int number = 0; number < chunk_count(); number++) {
		if (!this->chunk(number).is_added || numbers.empty()) {
			continue;
		}
		PlantChunk &chunk = own(number);
		chunk.species = numbers[static_cast<std::size_t>(chunk.species)];
		std::fill(chunk.plants.species.begin(), chunk.plants.species.end(), static_cast<uint8_t>(chunk.species));
	}
}

/// Moves added plants to their new tiles. Ids do not change.
void PlantStore::recut_added(ChangeSet &changes) {
	std::vector<std::pair<PlantId, PlacedPlant>> kept;
	for (int number = 0; number < chunk_count(); number++) {
		const PlantChunk &old = chunk(number);
		if (!old.is_added) {
			continue;
		}
		for (int slot = 0; slot < old.size(); slot++) {
			if (!old.is_gone(slot)) {
				kept.emplace_back(old.ids[static_cast<std::size_t>(slot)], old.plants.plant(slot));
			}
		}
		drop(number, changes);
	}
	for (const auto &[id, plant] : kept) {
		add(plant, id, changes);
	}
}

void PlantStore::remove(const PlantRef &ref, ChangeSet &changes) {
	const PlantChunk &chunk = this->chunk(ref.chunk);
	if (chunk.size() == 0 || chunk.is_gone(ref.slot)) {
		return;
	}
	if (chunk.is_added) {
		added_refs.erase(chunk.ids[static_cast<std::size_t>(ref.slot)]);
	}
	if ((chunk.is_added || chunk.is_new) && chunk.live_count() == 1) {
		drop(ref.chunk, changes);
		return;
	}
	PlantChunk &changed = own(ref.chunk);
	changed.plants.scale[static_cast<std::size_t>(ref.slot)] = 0.0f;
	changed.gone++;
	plant_total--;
	changes.gone.push_back(ref);
}

/// Chunk of added plants, or of new ones, of a species in a tile that has room, or -1.
int PlantStore::open_chunk(const TileKey &tile, int species, bool is_added) const {
	for (const int number : chunks_of(tile)) {
		const PlantChunk &there = chunk(number);
		const bool is_such = is_added ? there.is_added : there.is_new && there.spacing == cell_size;
		if (is_such && there.species == species && there.size() < there.room()) {
			return number;
		}
	}
	return -1;
}

/// Chunk to append a plant to.
int PlantStore::need_chunk(const PlacedPlant &plant, bool is_added, ChangeSet &changes) {
	const TileKey tile = tile_at(plant.root.x, plant.root.z, size);
	int number = open_chunk(tile, plant.species, is_added);
	if (number < 0) {
		number = take_number();
		PlantChunk &fresh = own(number);
		fresh.tile = tile;
		fresh.species = plant.species;
		fresh.is_added = is_added;
		fresh.is_new = !is_added;
		if (!is_added) {
			fresh.spacing = cell_size;
			spacings[cell_size]++;
		}
		tiles[tile].push_back(number);
	}
	const auto is_known = [number](const ChangeSet::Grown &grown) { return grown.chunk == number; };
	if (std::none_of(changes.grown.rbegin(), changes.grown.rend(), is_known)) {
		changes.grown.push_back({ number, chunk(number).size() });
	}
	return number;
}

void PlantStore::add(const PlacedPlant &plant, PlantId id, ChangeSet &changes) {
	const int number = need_chunk(plant, true, changes);
	PlantChunk &into = own(number);
	into.add(plant);
	into.ids.push_back(id);
	added_refs[id] = { number, into.size() - 1 };
	plant_total++;
}

PlantRef PlantStore::grow(const PlacedPlant &plant, ChangeSet &changes) {
	const int number = need_chunk(plant, false, changes);
	PlantChunk &into = own(number);
	into.add(plant);
	plant_total++;
	return { number, into.size() - 1 };
}

namespace {

/// Relative margin of search boxes, of their size and position.
constexpr float ROUNDED_UP = 1.0f + 1.0e-5f;
constexpr float ROUNDING = 1.0e-6f;
constexpr float ANY_HEIGHT = std::numeric_limits<float>::max();

bool is_in(const glm::vec3 &point, const glm::vec3 &low, const glm::vec3 &high) {
	return point.x >= low.x && point.x <= high.x && point.y >= low.y && point.y <= high.y && point.z >= low.z &&
			point.z <= high.z;
}

bool meet(const PlantChunk &chunk, const glm::vec3 &low, const glm::vec3 &high) {
	return chunk.low.x <= high.x && chunk.high.x >= low.x && chunk.low.y <= high.y && chunk.high.y >= low.y &&
			chunk.low.z <= high.z && chunk.high.z >= low.z;
}

bool is_near(const PlantChunk &chunk, const glm::vec3 &place, float reach) {
	return chunk.low.x <= place.x + reach && chunk.high.x >= place.x - reach && chunk.low.z <= place.z + reach &&
			chunk.high.z >= place.z - reach;
}

} // namespace

const std::vector<int> &PlantStore::chunks_of(const TileKey &tile) const {
	static const std::vector<int> none;
	const auto found = tiles.find(tile);
	return found == tiles.end() ? none : found->second;
}

template <class Visit>
void PlantStore::for_each_tile(const glm::vec3 &low, const glm::vec3 &high, const Visit &visit) const {
	const TileKey first = tile_at(low.x, low.z, size);
	const TileKey last = tile_at(high.x, high.z, size);
	for (auto tile = tiles.lower_bound(first); tile != tiles.end() && tile->first.column <= last.column; ++tile) {
		if (tile->first.row >= first.row && tile->first.row <= last.row) {
			visit(tile->second);
		}
	}
}

template <class Holds>
void PlantStore::find_in(
		const glm::vec3 &low, const glm::vec3 &high, const Holds &holds, std::vector<PlantRef> &found) const {
	for_each_tile(low, high, [&](const std::vector<int> &members) {
		for (const int number : members) {
			const PlantChunk &there = chunk(number);
			const int count = meet(there, low, high) ? there.size() : 0;
			for (int slot = 0; slot < count; slot++) {
				// Most plants are outside the box, and the exact test is slower.
				const glm::vec3 root = there.root(slot);
				if (is_in(root, low, high) && !there.is_gone(slot) && holds(root)) {
					found.push_back({ number, slot });
				}
			}
		}
	});
}

void PlantStore::find_in_sphere(const glm::vec3 &centre, float radius, std::vector<PlantRef> &found) const {
	if (!(radius >= 0.0f)) {
		return;
	}
	const double max = static_cast<double>(radius) * static_cast<double>(radius);
	const auto holds = [&](const glm::vec3 &root) {
		const glm::dvec3 way = glm::dvec3(root) - glm::dvec3(centre);
		return way.x * way.x + way.y * way.y + way.z * way.z <= max;
	};
	const glm::vec3 reach(ROUNDED_UP * radius + std::numeric_limits<float>::min());
	find_in(centre - reach - ROUNDING * glm::abs(centre), centre + reach + ROUNDING * glm::abs(centre), holds, found);
}

void PlantStore::find_along(
		const glm::vec2 &from, const glm::vec2 &to, float radius, std::vector<PlantRef> &found) const {
	if (!(radius >= 0.0f)) {
		return;
	}
	const glm::dvec2 along = glm::dvec2(to) - glm::dvec2(from);
	const double length = glm::dot(along, along);
	const double max = static_cast<double>(radius) * static_cast<double>(radius);
	const auto holds = [&](const glm::vec3 &root) {
		const glm::dvec2 way = glm::dvec2(root.x, root.z) - glm::dvec2(from);
		const double share = length > 0.0 ? std::clamp(glm::dot(way, along) / length, 0.0, 1.0) : 0.0;
		const glm::dvec2 beside = way - share * along;
		return glm::dot(beside, beside) <= max;
	};
	const glm::vec2 reach = ROUNDED_UP * radius + ROUNDING * glm::max(glm::abs(from), glm::abs(to));
	const glm::vec2 low = glm::min(from, to) - reach;
	const glm::vec2 high = glm::max(from, to) + reach;
	find_in({ low.x, -ANY_HEIGHT, low.y }, { high.x, ANY_HEIGHT, high.y }, holds, found);
}

void PlantStore::find_in_polygon(const Polygon &polygon, std::vector<PlantRef> &found) const {
	if (polygon.size() < 3) {
		return;
	}
	const AreaBox box = bounding_box(polygon);
	const auto holds = [&](const glm::vec3 &root) { return is_inside(polygon, { root.x, root.z }); };
	find_in({ box.low.x, -ANY_HEIGHT, box.low.y }, { box.high.x, ANY_HEIGHT, box.high.y }, holds, found);
}

PlantRef PlantStore::find_nearest(const glm::vec3 &centre, float radius) const {
	PlantRef nearest;
	double max = static_cast<double>(radius) * static_cast<double>(radius);
	std::size_t seen = 0;
	// Extends the search until it finds a plant or no tile remains.
	for (float reach = std::min(radius, size); radius >= 0.0f && nearest.chunk < 0;
			reach = std::min(radius, 2.0f * reach)) {
		seen = 0;
		for_each_tile(centre - reach, centre + reach, [&](const std::vector<int> &members) {
			seen++;
			for (const int number : members) {
				const PlantChunk &there = chunk(number);
				for (int slot = 0; slot < there.size(); slot++) {
					const glm::dvec3 way = glm::dvec3(there.root(slot)) - glm::dvec3(centre);
					const double away = glm::dot(way, way);
					if (away <= max && away <= static_cast<double>(reach) * static_cast<double>(reach) &&
							!there.is_gone(slot)) {
						max = away;
						nearest = { number, slot };
					}
				}
			}
		});
		if (reach >= radius || (seen == tiles.size() && reach > FARTHEST_COORDINATE)) {
			break;
		}
	}
	return nearest;
}

void PlantStore::find_in_box(const glm::vec3 &low, const glm::vec3 &high, std::vector<PlantRef> &found) const {
	find_in(low, high, [&](const glm::vec3 &root) { return is_in(root, low, high); }, found);
}

ExistingPlants PlantStore::generated_in(const AreaBox &box) const {
	ExistingPlants found;
	for_each_tile(
			{ box.low.x, 0.0f, box.low.y }, { box.high.x, 0.0f, box.high.y }, [&](const std::vector<int> &members) {
				for (const int number : members) {
					const PlantChunk &there = chunk(number);
					for (int slot = 0; !there.is_added && slot < there.size(); slot++) {
						const glm::vec3 root = there.root(slot);
						if (is_in_box(box, { root.x, root.z }) && !there.is_gone(slot)) {
							found.plants.add(there.plants.plant(slot));
							found.refs.push_back({ number, slot });
						}
					}
				}
			});
	return found;
}

PlantRef PlantStore::find(PlantId id) const {
	if (id < 0) {
		return {};
	}
	if (undergrowth::is_added(id)) {
		const auto found = added_refs.find(id);
		return found == added_refs.end() ? PlantRef() : found->second;
	}
	const auto is_its = [id](const auto &entry) { return matches_spacing(id, entry.first); };
	const auto own = std::find_if(spacings.begin(), spacings.end(), is_its);
	return own == spacings.end() ? PlantRef() : find_generated(id, own->first);
}

bool PlantStore::has_unused_ids(double other_spacing) const {
	return std::none_of(spacings.begin(), spacings.end(), [other_spacing](const auto &entry) {
		return entry.first != other_spacing && share_ids(entry.first, other_spacing);
	});
}

PlantRef PlantStore::find_generated(PlantId id, double at_spacing) const {
	glm::vec3 place(0.0f);
	generated_plant_position(id, at_spacing, place.x, place.z);
	const auto reach = static_cast<float>(at_spacing);
	PlantRef found;
	for_each_tile(place - reach, place + reach, [&](const std::vector<int> &members) {
		for (const int number : members) {
			const PlantChunk &there = chunk(number);
			if (found.chunk >= 0 || there.spacing != at_spacing || !is_near(there, place, reach)) {
				continue;
			}
			const float *x = there.plants.x.data();
			const float *z = there.plants.z.data();
			for (int slot = 0; slot < there.size(); slot++) {
				// Most plants are too far, and the exact test needs a division.
				if (std::fabs(x[slot] - place.x) < reach && std::fabs(z[slot] - place.z) < reach &&
						!there.is_gone(slot) && generated_plant_id(x[slot], z[slot], at_spacing) == id) {
					found = { number, slot };
					break;
				}
			}
		}
	});
	return found;
}

std::vector<TileKey> PlantStore::generated_tiles() const {
	std::vector<TileKey> found;
	for (const auto &[tile, members] : tiles) {
		if (std::any_of(members.begin(), members.end(), [this](int number) { return !chunk(number).is_added; })) {
			found.push_back(tile);
		}
	}
	return found;
}

std::vector<PlantRef> PlantStore::find_all(const std::vector<PlantId> &ids) const {
	std::vector<PlantRef> found;
	for (const PlantId id : ids) {
		const PlantRef place = find(id);
		if (place.chunk >= 0) {
			found.push_back(place);
		}
	}
	return found;
}

PlantId PlantStore::id(const PlantRef &place) const {
	return chunk(place.chunk).id(place.slot);
}

/// All chunk numbers. Those of generated plants are in the order in which cut_into_chunks() makes them for a whole
/// field, because tiles are built in any order.
std::vector<int> PlantStore::ordered_chunks() const {
	std::vector<int> all, generated;
	std::vector<std::pair<uint64_t, const std::vector<int> *>> along_curve;
	for (const auto &[tile, members] : tiles) {
		along_curve.emplace_back(curve_key(tile.column, tile.row), &members);
	}
	std::sort(along_curve.begin(), along_curve.end());
	const auto is_moved = [this](int number) {
		return chunk(number).size() > 0 && !chunk(number).is_added && !chunk(number).is_new;
	};
	for (const auto &[key, members] : along_curve) {
		const auto first = static_cast<std::ptrdiff_t>(generated.size());
		std::copy_if(members->begin(), members->end(), std::back_inserter(generated), is_moved);
		std::stable_sort(generated.begin() + first, generated.end(),
				[this](int one, int other) { return chunk(one).species < chunk(other).species; });
	}
	std::size_t next = 0;
	for (int number = 0; number < chunk_count(); number++) {
		all.push_back(is_moved(number) ? generated[next++] : number);
	}
	return all;
}

std::vector<PlantId> PlantStore::ids() const {
	std::vector<PlantId> all;
	all.reserve(static_cast<std::size_t>(plant_total));
	for (const int number : ordered_chunks()) {
		for (int slot = 0; slot < chunk(number).size(); slot++) {
			if (!chunk(number).is_gone(slot)) {
				all.push_back(id({ number, slot }));
			}
		}
	}
	return all;
}

std::size_t PlantStore::bytes() const {
	std::size_t bytes = chunks.capacity() * sizeof(chunks[0]) + chunks.size() * sizeof(PlantChunk);
	for (const std::shared_ptr<PlantChunk> &chunk : chunks) {
		bytes += chunk->plants.bytes() + chunk->ids.capacity() * sizeof(PlantId);
	}
	return bytes;
}

} // namespace undergrowth
