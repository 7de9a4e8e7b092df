#include "form/growth.hpp"

#include "base/random.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr double GOLDEN_SHARE = 0.61803398874989484820;
constexpr int HEIGHT_PLACES = 8; // Of a midrib whose heights are evaluated.
constexpr float TIP = 0.75f; // Offset on a carrier.
constexpr float ROD = 4.0f; // Length over the distance of its parts from their carrier.
enum Draw : uint64_t { DRAW_LENGTH = 4, DRAW_TINT = 5, DRAW_WANDER = 6 };

uint64_t seed_of(uint64_t seed, int group, int carrier, int i) {
	const uint64_t place = (static_cast<uint64_t>(group) << 40) ^ (static_cast<uint64_t>(carrier + 1) << 20);
	return mix_bits(seed ^ mix_bits(place ^ static_cast<uint64_t>(i)));
}

} // namespace

Growth::Growth(float height, uint64_t p_seed) : seed(p_seed) {
	grown.height = height;
}

int Growth::depth_of(int handle) const {
	return handle == ON_GROUND
			? 0
			: grown.groups[static_cast<size_t>(grown.placed[static_cast<size_t>(handle)].group)].depth;
}

std::string Growth::add_kind(const Part &part, int &kind) {
	const std::string fault = find_part_fault(part);
	if (fault.empty()) {
		kind = static_cast<int>(grown.parts.size());
		grown.parts.push_back(part);
		families.emplace_back(part.kind == PartKind::bead ? MidribCurve() : part.curve);
		grown.midribs.emplace_back(families.back());
	}
	return fault;
}

std::string Growth::add_stem(const Part &part, int &handle) {
	if (grown.stem != PlantForm::NO_STEM) {
		return "it already has a stem. Add further axes as a PlantAxis.";
	}
	Part stem = part;
	stem.kind = PartKind::axis;
	stem.length_min = stem.length_max = grown.height;
	stem.curve = MidribCurve();
	int kind = 0;
	std::vector<int> handles;
	std::string fault = add_kind(stem, kind);
	if (fault.empty()) {
		Arrangement alone;
		alone.layout = Layout::ground;
		fault = arrange(kind, alone, { ON_GROUND }, handles);
	}
	if (fault.empty()) {
		handle = grown.stem = handles.front();
	}
	return fault;
}

std::string Growth::find_carrier_fault(const std::vector<int> &carriers) const {
	if (carriers.empty()) {
		return "its parts have no carrier. Pass the handles that an earlier call returned, or the ground.";
	}
	const int count = static_cast<int>(grown.placed.size());
	const bool all_known = std::all_of(
			carriers.begin(), carriers.end(), [count](int carrier) { return carrier >= ON_GROUND && carrier < count; });
	return all_known ? std::string()
					 : "a handle belongs to another plant. Pass handles that calls for this plant returned.";
}

std::string Growth::find_count_fault(
		const Arrangement &arrangement, const std::vector<int> &carriers, int &depth) const {
	const double max = static_cast<double>(grown.placed.size()) +
			static_cast<double>(arrangement.count_max) * static_cast<double>(carriers.size());
	if (max > MAX_PARTS) {
		return "it would have " + std::to_string(static_cast<long long>(max)) + " parts. A plant may have at most " +
				std::to_string(MAX_PARTS) + ".";
	}
	for (const int carrier : carriers) {
		depth = std::max(depth, depth_of(carrier) + 1);
	}
	return depth <= MAX_DEPTH ? std::string()
							  : "parts carry parts in more than " + std::to_string(MAX_DEPTH) +
					" levels. Place them on parts that are nearer to the ground.";
}

std::string Growth::arrange(
		int kind, const Arrangement &arrangement, const std::vector<int> &carriers, std::vector<int> &handles) {
	int depth = 1;
	std::string fault = kind >= 0 && kind < static_cast<int>(grown.parts.size())
			? find_arrangement_fault(arrangement)
			: std::string("its part is unknown. Set a part.");
	if (fault.empty()) {
		fault = find_carrier_fault(carriers);
	}
	if (fault.empty()) {
		fault = find_count_fault(arrangement, carriers, depth);
	}
	if (!fault.empty()) {
		return fault;
	}
	const int group = add_group(kind, arrangement, carriers, depth);
	for (const int carrier : carriers) {
		place_on(group, arrangement, carrier, handles);
	}
	if (grown.groups.back().count == 0) { // By chance this plant has no part of the group.
		grown.groups.pop_back();
	}
	return fault;
}

int Growth::add_group(int kind, const Arrangement &arrangement, const std::vector<int> &carriers, int depth) {
	const auto group_of = [this](int carrier) {
		return carrier == ON_GROUND ? ON_GROUND : grown.placed[static_cast<size_t>(carrier)].group;
	};
	const int first = group_of(carriers.front());
	const bool is_one =
			std::all_of(carriers.begin(), carriers.end(), [&](int carrier) { return group_of(carrier) == first; });
	PartGroup group;
	group.kind = kind;
	group.carrier_group = is_one ? first : ON_GROUND;
	group.layout = arrangement.layout;
	group.radius = arrangement.radius;
	group.dome = arrangement.dome;
	group.depth = depth;
	group.first = static_cast<int>(grown.placed.size());
	grown.groups.push_back(group);
	return static_cast<int>(grown.groups.size()) - 1;
}

void Growth::place_on(int group, const Arrangement &arrangement, int carrier, std::vector<int> &handles) {
	const int count = count_of(arrangement, seed_of(seed, group, carrier, -1));
	for (int i = 0; i < count; i++) {
		const uint64_t own_seed = seed_of(seed, group, carrier, i);
		handles.push_back(static_cast<int>(grown.placed.size()));
		place(group, arrangement, carrier, seat_of(arrangement, i, count, own_seed), own_seed);
	}
}

void Growth::place(int group, const Arrangement &arrangement, int carrier, const Seat &seat, uint64_t own_seed) {
	PartGroup &own_group = grown.groups[static_cast<size_t>(group)];
	const Part &part = grown.parts[static_cast<size_t>(own_group.kind)];
	PartAxes axes = { { 1.0f, 0.0f, 0.0f }, { 0.0f, 1.0f, 0.0f }, { 0.0f, 0.0f, 1.0f } };
	glm::vec3 base(0.0f);
	if (carrier != ON_GROUND) {
		axes = grown.axes_of(grown.placed[static_cast<size_t>(carrier)], seat.offset);
		base = grown.point_of(grown.placed[static_cast<size_t>(carrier)], seat.offset);
	}
	const PartAxes aside = turn_into(axes, seat.azimuth, 0.0f);
	const float scale = arrangement.scale_at(seat.way);
	const float share = 0.5f + 0.5f * signed_noise(own_seed, DRAW_LENGTH);
	PlacedPart placed;
	placed.kind = own_group.kind;
	placed.group = group;
	placed.carrier = carrier;
	placed.axes = turn_into(axes, seat.azimuth, seat.tilt);
	placed.axes = arrangement.flat ? turn_level(placed.axes, axes) : placed.axes;
	placed.base = base + aside.outward * seat.away + aside.along * seat.lift;
	placed.length = (part.length_min + (part.length_max - part.length_min) * share) * scale * seat.stretch;
	placed.width = part.width * scale;
	placed.offset = seat.offset;
	const double order = GOLDEN_SHARE * own_group.count;
	placed.rank = static_cast<float>(order - std::floor(order));
	placed.tint = signed_noise(own_seed, DRAW_TINT);
	if (part.curve.wander > 0.0f && part.kind != PartKind::bead) {
		placed.own_midrib = static_cast<int>(grown.wanderers.size());
		grown.wanderers.emplace_back(families[static_cast<size_t>(placed.kind)], mix_bits(own_seed ^ DRAW_WANDER));
	}
	own_group.count++;
	grown.placed.push_back(placed);
}

/// Finds the heads that are rods, with all that they carry. Parts at the tip of their carrier continue it, as the axis
/// of an ear does.
void Growth::find_rods() {
	struct Extent {
		float low = 1.0f, high = 0.0f; ///< Offsets on the carriers.
		float carrier = 1e9f; ///< m, the shortest one.
		float longest = 0.0f, away = 0.0f; ///< m from the place on the carrier.
		bool is_tip = true;
	};
	std::vector<Extent> extents(grown.groups.size());
	std::vector<bool> is_head(grown.groups.size(), false);
	for (const PlacedPart &part : grown.placed) {
		const glm::vec3 tip = grown.point_of(part, 1.0f);
		for (const PlacedPart *own = &part; own->carrier != ON_GROUND;) {
			const PlacedPart &carrier = grown.placed[static_cast<size_t>(own->carrier)];
			const glm::vec3 along = grown.axes_of(carrier, own->offset).along;
			const glm::vec3 way = tip - grown.point_of(carrier, own->offset);
			Extent &extent = extents[static_cast<size_t>(own->group)];
			extent.is_tip = extent.is_tip && own->offset > TIP;
			extent.low = std::min(extent.low, own->offset);
			extent.high = std::max(extent.high, own->offset);
			extent.carrier = std::min(extent.carrier, carrier.length);
			extent.longest = std::max(extent.longest, glm::dot(way, along));
			extent.away = std::max(extent.away, glm::length(glm::cross(way, along)));
			own = &carrier;
		}
	}
	for (size_t g = 0; g < extents.size(); g++) {
		PartGroup &group = grown.groups[g];
		const Extent &own = extents[g];
		const bool is_tip = group.carrier_group != ON_GROUND && own.is_tip;
		const float length = std::max(own.high - own.low, 0.0f) * own.carrier + (is_tip ? own.longest : 0.0f);
		is_head[g] = is_tip || (group.carrier_group != ON_GROUND && is_head[static_cast<size_t>(group.carrier_group)]);
		group.is_rod = is_head[g] && group.layout == Layout::along && length > ROD * own.away;
	}
}

PlantForm Growth::finish() {
	find_rods();
	float top = 0.0f;
	for (const PlacedPart &part : grown.placed) {
		for (int i = 0; i <= HEIGHT_PLACES; i++) {
			const glm::vec3 point = grown.point_of(part, static_cast<float>(i) / HEIGHT_PLACES);
			top = std::max(top, point.y);
			grown.reach = std::max(grown.reach, std::sqrt(point.x * point.x + point.z * point.z));
		}
	}
	if (grown.stem == PlantForm::NO_STEM && top > 0.0f) {
		grown.height = top;
	}
	return std::move(grown);
}

} // namespace undergrowth
