#include "placement/plant_store.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace undergrowth {

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
		const PlantRef ref = find(id);
		if (ref.chunk >= 0) {
			found.push_back(ref);
		}
	}
	return found;
}

PlantId PlantStore::id(const PlantRef &ref) const {
	const PlantChunk &there = chunk(ref.chunk);
	if (there.is_added) {
		return there.ids[static_cast<std::size_t>(ref.slot)];
	}
	const glm::vec3 root = there.root(ref.slot);
	return generated_plant_id(root.x, root.z, there.spacing);
}

std::vector<PlantId> PlantStore::ids() const {
	std::vector<PlantId> all;
	all.reserve(static_cast<std::size_t>(plant_total));
	for (int number = 0; number < chunk_count(); number++) {
		for (int slot = 0; slot < chunk(number).size(); slot++) {
			if (!chunk(number).is_gone(slot)) {
				all.push_back(id({ number, slot }));
			}
		}
	}
	return all;
}

std::size_t PlantStore::bytes() const {
	std::size_t bytes = chunks.capacity() * sizeof(PlantChunk);
	for (const PlantChunk &chunk : chunks) {
		bytes += chunk.plants.bytes() + chunk.ids.capacity() * sizeof(PlantId);
	}
	return bytes;
}

} // namespace undergrowth
