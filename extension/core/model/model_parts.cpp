#include "model/model_parts.hpp"

#include "base/random.hpp"
#include "model/carrier_points.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace undergrowth {

namespace {

constexpr float GROUND = 0.05f; // Of the height: islands that begin below it are roots.
constexpr float GROUND_OF_FOLIAGE = 0.02f; // The same beside a stem.
constexpr float STEM_HEIGHT = 0.2f; // Of the height: the shortest stem.
constexpr float TWIG = 0.25f; // Of the height: the smallest twig.
constexpr size_t MAX_TWIGS = 24;
constexpr int MIN_CARRIED = 2;
constexpr float HEAD_FROM = 0.9f; // Of the height of its stem.
constexpr float HEAD_STEM = 0.4f; // Of the height: the shortest stem with a head.
constexpr float HEAD_SIZE = 0.35f; // Of the height.
constexpr int MAX_SAMPLES = 16; // Vertices of an island from which the nearest carrier is searched.
constexpr float BASE_OF_PART = 0.12f; // Of the length of a part: vertices this near to its end are its base.
constexpr float MAX_ASIDE = 0.4f; // Of the size of a part: how far its base is from the vertex nearest to its carrier.
constexpr int GRAIN_STEPS = 16;
constexpr float STILL = 0.1f; // Of the height: below it a root swings less.
constexpr float LEANING = 0.08f; // Of the length: a part that leans less has no side of its own.
constexpr float BESIDE = 0.02f; // Of the height: a part this far from the middle hangs on a side.
constexpr float DAMPING = 0.12f;
constexpr float SWINGS_OF_METRE = 1.2f; // Hz, of a part of 1 m.
constexpr float SLOWEST = 0.8f; // Hz.
constexpr float FASTEST = 8.0f;
constexpr float MIN_ROOM = 0.02f;
constexpr float PHASE_CELL = 0.05f; // m: parts of two levels within it have the same phase.

float size_of(const ModelIsland &island) {
	return glm::length(island.greatest - island.least);
}

/// The parts of one model while they are found.
struct Finder {
	const std::vector<ModelSurface> &surfaces;
	const std::vector<glm::vec3> &places;
	const ModelIslands &found;
	float height;
	std::vector<ModelPart> parts;
	std::vector<int> carriers; // By island; -1: none.
	std::vector<int> carried; // Number of islands on each.

	const ModelIsland &island(size_t number) const { return found.islands[number]; }
	const glm::vec3 &place(const ModelIsland &of, int member) const {
		return places[static_cast<size_t>(found.members[static_cast<size_t>(of.first + member)])];
	}
	void find_roots();
	void find_midrib(size_t number);
	std::vector<bool> possible_twigs() const;
	float attach(size_t number, const CarrierPoints &points, const std::vector<bool> &is_open, bool is_final);
	void attach_twigs(const CarrierPoints &points, std::vector<bool> twigs, std::vector<bool> &is_open);
	void attach_all();
	glm::vec3 grain_of(const ModelIsland &of, const glm::vec3 &middle) const;
	glm::vec3 base_of(const ModelIsland &of, const glm::vec3 &nearest) const;
	void set_tip(size_t number);
	bool set_side(size_t number);
	void set_swing(ModelPart &part, float length) const;
	void let_swing(size_t number);
	void join_heads();
};

void Finder::find_roots() {
	const auto is_stem = [&](const ModelIsland &one) {
		return !one.is_foliage && one.least.y <= GROUND * height &&
				one.greatest.y - one.least.y >= STEM_HEIGHT * height;
	};
	const bool has_stem = std::any_of(found.islands.begin(), found.islands.end(), is_stem);
	size_t lowest = 0;
	bool is_any = false;
	for (size_t i = 0; i < parts.size(); i++) {
		const float end = has_stem && island(i).is_foliage ? GROUND_OF_FOLIAGE : GROUND;
		parts[i].is_root = island(i).least.y <= end * height;
		is_any = is_any || parts[i].is_root;
		lowest = island(i).least.y < island(lowest).least.y ? i : lowest;
	}
	if (!is_any && !parts.empty()) {
		parts[lowest].is_root = true;
	}
}

// The middle of each slice; empty slices are between their neighbours.
void Finder::find_midrib(size_t number) {
	constexpr int SLICES = ModelMidrib::SLICES;
	const ModelIsland &of = island(number);
	ModelMidrib &midrib = parts[number].midrib;
	midrib.least = of.least.y;
	midrib.step = std::max((of.greatest.y - of.least.y) / SLICES, 1e-6f);
	midrib.middles.fill(glm::vec3(0.0f));
	midrib.radii.fill(0.0f);
	std::array<int, SLICES + 1> counts = {};
	const auto slice_of = [&](float y) {
		return static_cast<size_t>(std::clamp((y - midrib.least) / midrib.step + 0.5f, 0.0f, float(SLICES)));
	};
	for (int i = 0; i < of.count; i++) {
		midrib.middles[slice_of(place(of, i).y)] += place(of, i);
		counts[slice_of(place(of, i).y)]++;
	}
	int before = -1;
	for (int slice = 0; slice <= SLICES; slice++) {
		if (counts[static_cast<size_t>(slice)] == 0) {
			continue;
		}
		midrib.middles[static_cast<size_t>(slice)] /= static_cast<float>(counts[static_cast<size_t>(slice)]);
		for (int empty = before + 1; empty < slice; empty++) {
			const glm::vec3 to = midrib.middles[static_cast<size_t>(slice)];
			const glm::vec3 from = before < 0 ? to : midrib.middles[static_cast<size_t>(before)];
			const float share = static_cast<float>(empty - before) / static_cast<float>(slice - before);
			midrib.middles[static_cast<size_t>(empty)] = glm::mix(from, to, share);
		}
		before = slice;
	}
	for (int i = 0; i < of.count; i++) {
		const size_t slice = slice_of(place(of, i).y);
		const glm::vec3 aside = place(of, i) - midrib.middles[slice];
		midrib.radii[slice] +=
				glm::length(glm::vec2(aside.x, aside.z)) / static_cast<float>(std::max(counts[slice], 1));
	}
}

std::vector<bool> Finder::possible_twigs() const {
	std::vector<size_t> large;
	for (size_t i = 0; i < parts.size(); i++) {
		if (!parts[i].is_root && !island(i).is_foliage && size_of(island(i)) >= TWIG * height) {
			large.push_back(i);
		}
	}
	std::stable_sort(large.begin(), large.end(),
			[this](size_t one, size_t other) { return size_of(island(one)) > size_of(island(other)); });
	std::vector<bool> twigs(parts.size(), false);
	for (size_t i = 0; i < std::min(large.size(), MAX_TWIGS); i++) {
		twigs[large[i]] = true;
	}
	return twigs;
}

// The longest direction of an island: that of the largest variance, by power iteration.
glm::vec3 Finder::grain_of(const ModelIsland &of, const glm::vec3 &middle) const {
	glm::mat3 variances(0.0f);
	for (int i = 0; i < of.count; i++) {
		const glm::vec3 aside = place(of, i) - middle;
		variances += glm::outerProduct(aside, aside);
	}
	glm::vec3 grain = of.greatest - of.least;
	for (int i = 0; i < GRAIN_STEPS && glm::dot(grain, grain) > 0.0f; i++) {
		grain = variances * glm::normalize(grain);
	}
	return glm::dot(grain, grain) > 0.0f ? glm::normalize(grain) : glm::vec3(0.0f, 1.0f, 0.0f);
}

// The middle of the end at which an island is attached. Most leaves and cards are longer than wide.
glm::vec3 Finder::base_of(const ModelIsland &of, const glm::vec3 &nearest) const {
	glm::vec3 middle(0.0f);
	for (int i = 0; i < of.count; i++) {
		middle += place(of, i) / static_cast<float>(of.count);
	}
	const glm::vec3 grain = grain_of(of, middle);
	const float side = glm::dot(nearest - middle, grain) < 0.0f ? -1.0f : 1.0f;
	float end = 0.0f;
	for (int i = 0; i < of.count; i++) {
		end = std::max(end, side * glm::dot(place(of, i) - middle, grain));
	}
	glm::vec3 sum(0.0f);
	int count = 0;
	for (int i = 0; i < of.count; i++) {
		if (side * glm::dot(place(of, i) - middle, grain) >= (1.0f - 2.0f * BASE_OF_PART) * end) {
			sum += place(of, i);
			count++;
		}
	}
	const glm::vec3 base = count > 0 ? sum / static_cast<float>(count) : nearest;
	return glm::distance(base, nearest) < MAX_ASIDE * size_of(of) ? base : nearest;
}

// Returns the distance (m) to the nearest open carrier. `is_final`: attaches the island there.
float Finder::attach(size_t number, const CarrierPoints &points, const std::vector<bool> &is_open, bool is_final) {
	const ModelIsland &of = island(number);
	const int step = std::max(of.count / MAX_SAMPLES, 1);
	CarrierPoints::Found best;
	glm::vec3 nearest = place(of, 0);
	for (int i = 0; i < of.count; i += step) {
		const CarrierPoints::Found one = points.nearest(place(of, i), is_open);
		if (one.island >= 0 && (best.island < 0 || one.square < best.square)) {
			best = one;
			nearest = place(of, i);
		}
	}
	if (is_final) {
		ModelPart &part = parts[number];
		carriers[number] = best.island;
		part.pivot = base_of(of, nearest);
		const bool is_on_root = best.island < 0 || parts[static_cast<size_t>(best.island)].is_root;
		part.stem_offset = is_on_root ? std::clamp(part.pivot.y / height, 0.0f, 1.0f)
									  : parts[static_cast<size_t>(best.island)].stem_offset;
		if (best.island >= 0) {
			carried[static_cast<size_t>(best.island)]++;
		}
	}
	return best.island < 0 ? 0.0f : std::sqrt(best.square);
}

// Attaches the nearest twig first, so that twigs may carry twigs.
void Finder::attach_twigs(const CarrierPoints &points, std::vector<bool> twigs, std::vector<bool> &is_open) {
	while (true) {
		int nearest = -1;
		float least = 0.0f;
		for (size_t i = 0; i < twigs.size(); i++) {
			if (!twigs[i]) {
				continue;
			}
			const float away = attach(i, points, is_open, false);
			if (nearest < 0 || away < least) {
				nearest = static_cast<int>(i);
				least = away;
			}
		}
		if (nearest < 0) {
			return;
		}
		attach(static_cast<size_t>(nearest), points, is_open, true);
		twigs[static_cast<size_t>(nearest)] = false;
		is_open[static_cast<size_t>(nearest)] = true;
	}
}

void Finder::attach_all() {
	const std::vector<bool> twigs = possible_twigs();
	std::vector<bool> carries = twigs;
	std::vector<bool> is_open(parts.size(), false);
	for (size_t i = 0; i < parts.size(); i++) {
		carries[i] = carries[i] || parts[i].is_root;
		is_open[i] = parts[i].is_root;
	}
	const CarrierPoints points(surfaces, places, found, carries, height);
	attach_twigs(points, twigs, is_open);
	for (size_t i = 0; i < parts.size(); i++) {
		if (!parts[i].is_root && !twigs[i]) {
			attach(i, points, is_open, true);
		}
	}
}

void Finder::set_tip(size_t number) {
	const ModelIsland &of = island(number);
	ModelPart &part = parts[number];
	if (part.is_root) {
		part.pivot = part.midrib.middles[0];
		part.pivot.y = part.midrib.least;
	}
	glm::vec3 middle(0.0f);
	for (int i = 0; i < of.count; i++) {
		middle += place(of, i) / static_cast<float>(of.count);
	}
	const glm::vec3 way = middle - part.pivot;
	const float length = glm::length(way);
	float farthest = 0.0f;
	for (int i = 0; i < of.count && length > 0.0f; i++) {
		farthest = std::max(farthest, glm::dot(place(of, i) - part.pivot, way) / length);
	}
	part.tip = length > 0.0f ? part.pivot + way * (farthest / length) : part.pivot;
}

// Returns false for a part in the middle that does not lean.
bool Finder::set_side(size_t number) {
	ModelPart &part = parts[number];
	const glm::vec3 centre = island(number).centre();
	const glm::vec3 way = 2.0f * (centre - part.pivot);
	const glm::vec2 lean(way.x, way.z);
	const glm::vec2 beside(part.pivot.x, part.pivot.z);
	if (glm::length(lean) > LEANING * part.length()) {
		part.swing.side = glm::normalize(lean);
	} else if (glm::length(beside) > BESIDE * height) {
		part.swing.side = glm::normalize(beside);
	} else {
		part.swing.side = { 1.0f, 0.0f };
		return !part.is_root;
	}
	return true;
}

void Finder::set_swing(ModelPart &part, float length) const {
	PartMotion &swing = part.swing;
	swing.frequency = std::clamp(SWINGS_OF_METRE / std::sqrt(std::max(length, 1e-3f)), SLOWEST, FASTEST);
	swing.damping_ratio = DAMPING;
	const auto cell = [](float metres) { return std::floor(metres / PHASE_CELL + 0.5f); };
	const uint64_t bits = bits_of_place(static_cast<uint64_t>(static_cast<int64_t>(cell(part.pivot.y))),
			cell(part.pivot.x) + 0.0f, cell(part.pivot.z) + 0.0f);
	swing.phase = static_cast<float>(unit16(bits, 0));
	const glm::vec3 way = part.tip - part.pivot;
	const float away = std::max(glm::length(glm::vec2(way.x, way.z)), 1e-4f);
	swing.room = swing.is_head() ? 1.0f : std::clamp(0.5f * std::max(part.tip.y, 0.0f) / away, MIN_ROOM, 1.0f);
	part.code = encode_part_motion(swing);
	part.swing = decode_part_motion(part.code);
}

void Finder::let_swing(size_t number) {
	ModelPart &part = parts[number];
	part.swings = true;
	part.swinger = static_cast<int>(number);
	set_swing(part, part.length());
}

void Finder::join_heads() {
	for (size_t stem = 0; stem < parts.size(); stem++) {
		const float top = island(stem).greatest.y;
		if (!parts[stem].is_root || carried[stem] == 0 || top < HEAD_STEM * height) {
			continue;
		}
		std::vector<size_t> head;
		glm::vec3 least(0.0f), greatest(0.0f);
		for (size_t i = 0; i < parts.size(); i++) {
			const bool is_of_it = carriers[i] == static_cast<int>(stem) && parts[i].swings &&
					parts[i].pivot.y >= HEAD_FROM * top && size_of(island(i)) <= HEAD_SIZE * height;
			if (is_of_it) {
				least = head.empty() ? island(i).least : glm::min(least, island(i).least);
				greatest = head.empty() ? island(i).greatest : glm::max(greatest, island(i).greatest);
				head.push_back(i);
			}
		}
		if (head.empty() || glm::length(greatest - least) > HEAD_SIZE * height) {
			continue;
		}
		ModelPart whole = parts[head[0]];
		whole.swings = false;
		whole.weight = 1.0f;
		whole.pivot = parts[stem].midrib.middles[ModelMidrib::SLICES];
		whole.tip = { whole.pivot.x, greatest.y, whole.pivot.z };
		whole.stem_offset = std::clamp(whole.pivot.y / height, 0.0f, 1.0f);
		whole.swing = PartMotion();
		set_swing(whole, glm::length(greatest - least));
		for (const size_t one : head) {
			parts[one] = whole;
		}
	}
}

} // namespace

glm::vec3 ModelMidrib::at(float height) const {
	const float place = std::clamp((height - least) / step, 0.0f, static_cast<float>(SLICES));
	const size_t below = std::min(static_cast<size_t>(place), static_cast<size_t>(SLICES - 1));
	glm::vec3 middle = glm::mix(middles[below], middles[below + 1], place - static_cast<float>(below));
	middle.y = height;
	return middle;
}

float ModelPart::length() const {
	return glm::distance(pivot, tip);
}

float ModelPart::offset_of(const glm::vec3 &place) const {
	const glm::vec3 way = tip - pivot;
	const float square = glm::dot(way, way);
	return square > 0.0f ? std::clamp(glm::dot(place - pivot, way) / square, 0.0f, 1.0f) : 0.0f;
}

float ModelPart::weight_of(const glm::vec3 &place, float height) const {
	const float still = is_root ? std::clamp(place.y / (STILL * height), 0.0f, 1.0f) : 1.0f;
	return swings ? offset_of(place) * still : weight;
}

float ModelPart::stem_offset_of(const glm::vec3 &place, float height) const {
	return is_root ? std::clamp(place.y / height, 0.0f, 1.0f) : stem_offset;
}

glm::vec3 ModelPart::midrib_at(const glm::vec3 &place) const {
	return is_root ? midrib.at(place.y) : pivot + (tip - pivot) * offset_of(place);
}

std::vector<ModelPart> attach_islands(const std::vector<ModelSurface> &surfaces, const std::vector<glm::vec3> &places,
		const ModelIslands &found, float height) {
	const size_t count = found.islands.size();
	Finder finder = { surfaces, places, found, height, std::vector<ModelPart>(count), std::vector<int>(count, -1),
		std::vector<int>(count, 0) };
	finder.find_roots();
	int roots = 0;
	for (size_t i = 0; i < count; i++) {
		if (finder.parts[i].is_root) {
			finder.find_midrib(i);
			roots++;
		}
	}
	finder.attach_all();
	const PartMotionCode still = encode_part_motion(PartMotion());
	for (size_t i = 0; i < count; i++) {
		ModelPart &part = finder.parts[i];
		part.code = still;
		finder.set_tip(i);
		const bool is_twig = !part.is_root && finder.carried[i] >= MIN_CARRIED;
		const bool is_stem = part.is_root && (roots == 1 || finder.carried[i] > 0);
		if (!is_twig && !is_stem && part.length() > 0.0f && finder.set_side(i)) {
			finder.let_swing(i);
		}
	}
	finder.join_heads();
	return std::move(finder.parts);
}

} // namespace undergrowth
