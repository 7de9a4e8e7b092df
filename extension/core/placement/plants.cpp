#include "placement/plants.hpp"

#include "base/bounded_whole.hpp"
#include "base/portable_math.hpp"
#include "conventions.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr double TURN_CODES = 65536.0;
constexpr double HEIGHT_CODES = 65536.0 / FieldPlants::MAX_HEIGHT;
constexpr double LEAN_CODES = 65535.0 / (PI / 2.0);
constexpr double COSINE_SLACK = 1.0e-7; ///< Rounding error of a float normal.

constexpr int MAX_CODE = 65535;
constexpr int MAX_COLOR_CODE = 127;
constexpr float COLOR_CODES = static_cast<float>(MAX_COLOR_CODE);
/// Limits of scales: lengths stay finite and above 0.
constexpr float MIN_SCALE = 1.0e-6f;
constexpr float MAX_SCALE = 1.0e6f;

/// NaN has the code `min`.
uint16_t nearest_code(double value, int min = 0) {
	return static_cast<uint16_t>(bounded_whole(std::floor(value + 0.5), min, MAX_CODE));
}

uint16_t height_code(float height) {
	return nearest_code(height * HEIGHT_CODES, 1); // A plant without height could not be simulated.
}

uint16_t turn_code(double turn) {
	const double share = turn / (2.0 * PI);
	const int code = bounded_whole(std::floor((share - std::floor(share)) * TURN_CODES + 0.5), 0, MAX_CODE + 1);
	return static_cast<uint16_t>(code & MAX_CODE);
}

int8_t color_code(float value) {
	const double code = std::floor(static_cast<double>(value * COLOR_CODES) + 0.5);
	return static_cast<int8_t>(bounded_whole(code, -MAX_COLOR_CODE, MAX_COLOR_CODE));
}

template <class T> void append_column(std::vector<T> &column, const std::vector<T> &more) {
	column.insert(column.end(), more.begin(), more.end());
}

template <class T> std::vector<T> pick(const std::vector<T> &column, const std::vector<int> &order) {
	std::vector<T> picked(order.size());
	for (std::size_t i = 0; i < picked.size(); i++) {
		picked[i] = column[static_cast<std::size_t>(order[i])];
	}
	return picked;
}

/// Min and max cosine of an allowed slope.
struct Cosines {
	double min;
	double max;
};

Cosines cosines(const GroundLimits &limits) {
	const double flattest = std::clamp(static_cast<double>(limits.flattest), 0.0, PI);
	const double steepest = std::clamp(static_cast<double>(limits.steepest), 0.0, PI);
	return { portable_cos(steepest) - COSINE_SLACK, portable_cos(flattest) + COSINE_SLACK };
}

bool is_slope_allowed(const glm::vec3 &normal, const Cosines &allowed) {
	const double x = normal.x;
	const double y = normal.y;
	const double z = normal.z;
	const double length = std::sqrt(x * x + y * y + z * z);
	const double cosine = y / length;
	// Also false for normals that are not finite or have no length.
	return std::isfinite(length) && cosine >= allowed.min && cosine <= allowed.max;
}

glm::dvec3 unit(const glm::dvec3 &v) {
	return v / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

/// Leans a plant further, by `share` of the turn from upright to the ground's normal.
void align(PlacedPlant &plant, const glm::vec3 &normal, double share) {
	const glm::dvec3 up(0.0, 1.0, 0.0);
	const glm::dvec3 towards = unit(up + share * (unit(glm::dvec3(normal)) - up));
	const SineAndCosine around =
			portable_sine_and_cosine(static_cast<double>(plant.turn) + static_cast<double>(plant.side));
	const SineAndCosine lean = portable_sine_and_cosine(plant.lean);
	const glm::dvec3 was(lean.sine * around.cosine, lean.cosine, -lean.sine * around.sine);
	// The shortest turn from `up` to `towards`.
	const glm::dvec3 sum = up + towards;
	const double along = sum.x * was.x + sum.y * was.y + sum.z * was.z;
	const glm::dvec3 is = was - sum * (along / (1.0 + towards.y)) + towards * (2.0 * was.y);
	plant.lean = static_cast<float>(portable_atan2(std::sqrt(is.x * is.x + is.z * is.z), is.y));
	plant.side = static_cast<float>(portable_atan2(-is.z, is.x) - static_cast<double>(plant.turn));
}

} // namespace

bool is_valid(const PlacedPlant &plant) {
	const bool finite = std::isfinite(plant.root.x) && std::isfinite(plant.root.y) && std::isfinite(plant.root.z) &&
			std::isfinite(plant.scale) && std::isfinite(plant.turn) && std::isfinite(plant.height) &&
			std::isfinite(plant.lean) && std::isfinite(plant.side) && std::isfinite(plant.lightness) &&
			std::isfinite(plant.warmth);
	return finite && plant.scale >= MIN_SCALE && plant.scale <= MAX_SCALE && plant.species >= 0 &&
			plant.species <= 255 && plant.variant >= 0 && plant.variant <= 255;
}

void FieldPlants::reserve(std::size_t count) {
	x.reserve(count);
	y.reserve(count);
	z.reserve(count);
	scale.reserve(count);
	turn.reserve(count);
	height.reserve(count);
	lean.reserve(count);
	side.reserve(count);
	species.reserve(count);
	variant.reserve(count);
	lightness.reserve(count);
	warmth.reserve(count);
}

void FieldPlants::resize(std::size_t count) {
	x.resize(count);
	y.resize(count);
	z.resize(count);
	scale.resize(count);
	turn.resize(count);
	height.resize(count);
	lean.resize(count);
	side.resize(count);
	species.resize(count);
	variant.resize(count);
	lightness.resize(count);
	warmth.resize(count);
}

bool FieldPlants::add(const PlacedPlant &plant) {
	if (!is_valid(plant)) {
		return false;
	}
	x.push_back(plant.root.x);
	y.push_back(plant.root.y);
	z.push_back(plant.root.z);
	scale.push_back(plant.scale);
	turn.push_back(turn_code(plant.turn));
	height.push_back(height_code(plant.height));
	lean.push_back(nearest_code(plant.lean * LEAN_CODES));
	side.push_back(turn_code(plant.side));
	species.push_back(static_cast<uint8_t>(plant.species));
	variant.push_back(static_cast<uint8_t>(plant.variant));
	lightness.push_back(color_code(plant.lightness));
	warmth.push_back(color_code(plant.warmth));
	return true;
}

void FieldPlants::append(const FieldPlants &other) {
	append_column(x, other.x);
	append_column(y, other.y);
	append_column(z, other.z);
	append_column(scale, other.scale);
	append_column(turn, other.turn);
	append_column(height, other.height);
	append_column(lean, other.lean);
	append_column(side, other.side);
	append_column(species, other.species);
	append_column(variant, other.variant);
	append_column(lightness, other.lightness);
	append_column(warmth, other.warmth);
}

float FieldPlants::angle_of(uint16_t code) {
	return static_cast<float>(code * (2.0 * PI / TURN_CODES));
}

float FieldPlants::color_of(int8_t code) {
	return static_cast<float>(code) / COLOR_CODES;
}

PlacedPlant FieldPlants::plant(int index) const {
	const auto i = static_cast<std::size_t>(index);
	PlacedPlant plant;
	plant.root = { x[i], y[i], z[i] };
	plant.scale = scale[i];
	plant.turn = angle_of(turn[i]);
	plant.height = static_cast<float>(height[i] / HEIGHT_CODES);
	plant.lean = static_cast<float>(lean[i] / LEAN_CODES);
	plant.side = angle_of(side[i]);
	plant.species = species[i];
	plant.variant = variant[i];
	plant.lightness = color_of(lightness[i]);
	plant.warmth = color_of(warmth[i]);
	return plant;
}

void FieldPlants::copy(int from, int to) {
	const auto f = static_cast<std::size_t>(from);
	const auto t = static_cast<std::size_t>(to);
	x[t] = x[f];
	y[t] = y[f];
	z[t] = z[f];
	scale[t] = scale[f];
	turn[t] = turn[f];
	height[t] = height[f];
	lean[t] = lean[f];
	side[t] = side[f];
	species[t] = species[f];
	variant[t] = variant[f];
	lightness[t] = lightness[f];
	warmth[t] = warmth[f];
}

FieldPlants FieldPlants::reordered(const std::vector<int> &order) const {
	FieldPlants sorted;
	sorted.x = pick(x, order);
	sorted.y = pick(y, order);
	sorted.z = pick(z, order);
	sorted.scale = pick(scale, order);
	sorted.turn = pick(turn, order);
	sorted.height = pick(height, order);
	sorted.lean = pick(lean, order);
	sorted.side = pick(side, order);
	sorted.species = pick(species, order);
	sorted.variant = pick(variant, order);
	sorted.lightness = pick(lightness, order);
	sorted.warmth = pick(warmth, order);
	return sorted;
}

void FieldPlants::remove(const std::vector<int> &ascending) {
	std::size_t next = 0;
	int kept = 0;
	for (int i = 0; i < size(); i++) {
		if (next < ascending.size() && ascending[next] == i) {
			next++;
		} else {
			copy(i, kept++);
		}
	}
	resize(static_cast<std::size_t>(kept));
}

std::size_t FieldPlants::bytes() const {
	return (x.capacity() + y.capacity() + z.capacity() + scale.capacity()) * sizeof(float) +
			(turn.capacity() + height.capacity() + lean.capacity() + side.capacity()) * sizeof(uint16_t) +
			species.capacity() + variant.capacity() + lightness.capacity() + warmth.capacity();
}

int apply_ground(FieldPlants &plants, const float *heights, const glm::vec3 *normals, const GroundLimits &limits) {
	const Cosines allowed = cosines(limits);
	const glm::vec3 level = { 0.0f, 1.0f, 0.0f };
	int kept = 0;
	for (int i = 0; i < plants.size(); i++) {
		const float height = heights[i];
		const bool has_ground = std::isfinite(height) && height >= limits.lowest && height <= limits.highest;
		if (!has_ground || !is_slope_allowed(normals != nullptr ? normals[i] : level, allowed)) {
			continue;
		}
		plants.copy(i, kept);
		plants.y[static_cast<std::size_t>(kept)] = height;
		if (limits.alignment > 0.0f && normals != nullptr) {
			PlacedPlant plant = plants.plant(kept);
			align(plant, normals[i], limits.alignment);
			plants.lean[static_cast<std::size_t>(kept)] = nearest_code(plant.lean * LEAN_CODES);
			plants.side[static_cast<std::size_t>(kept)] = turn_code(plant.side);
		}
		kept++;
	}
	plants.resize(static_cast<std::size_t>(kept));
	return kept;
}

} // namespace undergrowth
