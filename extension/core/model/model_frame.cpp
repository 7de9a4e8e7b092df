#include "model/model_frame.hpp"

#include "model/model_islands.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace undergrowth {

namespace {

constexpr float TALLEST = 20.0f; // m: taller files are in another unit.
constexpr float SMALLEST = 0.01f; // m.
constexpr float HUNDRED = 100.0f;
constexpr float BASE = 0.04f; // Of the height: what is the base of a plant.
constexpr float BURIED = 0.2f; // Of the height: roots and stems below the ground.
constexpr float ABOVE_ORIGIN = 0.05f; // Of the height.
constexpr float BESIDE_ORIGIN = 0.3f; // Of the width: how far the middle may be from an origin at the base.
constexpr float MUCH_NARROWER = 0.5f; // Ratio of the widths of two bases.
constexpr UpAxis AXES[] = { UpAxis::plus_y, UpAxis::plus_z, UpAxis::minus_z, UpAxis::plus_x, UpAxis::minus_x,
	UpAxis::minus_y };

struct Box {
	glm::vec3 least = glm::vec3(std::numeric_limits<float>::max());
	glm::vec3 greatest = glm::vec3(std::numeric_limits<float>::lowest());

	void add(const glm::vec3 &point) {
		for (int axis = 0; axis < 3; axis++) {
			least[axis] = std::min(least[axis], point[axis]);
			greatest[axis] = std::max(greatest[axis], point[axis]);
		}
	}
	glm::vec3 extent() const { return greatest - least; }
	glm::vec3 centre() const { return 0.5f * (least + greatest); }
};

template <class Act> void for_each_point(const std::vector<ModelSurface> &surfaces, const Act &act) {
	for (const ModelSurface &surface : surfaces) {
		for (int i = 0; i < surface.vertices; i++) {
			act(surface.positions[i]);
		}
	}
}

// Rotations, so that textures and normals are not mirrored. Columns are where the file's axes go.
glm::mat3 turn_of(UpAxis up) {
	switch (up) {
		case UpAxis::minus_y:
			return { { 1.0f, 0.0f, 0.0f }, { 0.0f, -1.0f, 0.0f }, { 0.0f, 0.0f, -1.0f } };
		case UpAxis::plus_z:
			return { { 1.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, -1.0f }, { 0.0f, 1.0f, 0.0f } };
		case UpAxis::minus_z:
			return { { 1.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 1.0f }, { 0.0f, -1.0f, 0.0f } };
		case UpAxis::plus_x:
			return { { 0.0f, 1.0f, 0.0f }, { -1.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 1.0f } };
		case UpAxis::minus_x:
			return { { 0.0f, -1.0f, 0.0f }, { 1.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 1.0f } };
		default:
			return glm::mat3(1.0f);
	}
}

Box box_of(const std::vector<ModelSurface> &surfaces, const glm::mat3 &turn) {
	Box box;
	for_each_point(surfaces, [&](const glm::vec3 &point) { box.add(turn * point); });
	return box;
}

// True if the file's origin is where such a plant meets the ground.
bool has_origin_at_base(const Box &box) {
	const glm::vec3 extent = box.extent();
	const glm::vec3 centre = box.centre();
	const float height = extent.y;
	return height > 0.0f && box.least.y <= ABOVE_ORIGIN * height && box.least.y >= -BURIED * height &&
			std::fabs(centre.x) <= BESIDE_ORIGIN * std::max(extent.x, 0.1f * height) &&
			std::fabs(centre.z) <= BESIDE_ORIGIN * std::max(extent.z, 0.1f * height);
}

Box base_of(const std::vector<ModelSurface> &surfaces, const glm::mat3 &turn, const Box &box) {
	const float end = box.least.y + BASE * box.extent().y;
	Box base;
	for_each_point(surfaces, [&](const glm::vec3 &in_file) {
		const glm::vec3 point = turn * in_file;
		if (point.y <= end) {
			base.add(point);
		}
	});
	return base;
}

// Width of the base over the whole width.
float narrowness(const std::vector<ModelSurface> &surfaces, UpAxis up) {
	const glm::mat3 turn = turn_of(up);
	const Box box = box_of(surfaces, turn);
	const Box base = base_of(surfaces, turn, box);
	const float whole = std::max(box.extent().x, box.extent().z);
	return whole > 0.0f ? std::max(base.extent().x, base.extent().z) / whole : 1.0f;
}

// True if the largest island, the stem, begins at the base.
bool begins_with_stem(const ModelIsland &stem, const std::vector<glm::vec3> &places, UpAxis up) {
	const glm::mat3 turn = turn_of(up);
	Box of_stem;
	of_stem.add(turn * stem.least);
	of_stem.add(turn * stem.greatest);
	Box whole;
	std::for_each(places.begin(), places.end(), [&](const glm::vec3 &place) { whole.add(turn * place); });
	const float rise = of_stem.least.y - whole.least.y;
	return rise <= BASE * whole.extent().y && of_stem.extent().y > 0.5f * whole.extent().y;
}

// For files with an origin anywhere.
UpAxis find_up_by_base(const std::vector<ModelSurface> &surfaces) {
	std::vector<glm::vec3> places;
	for_each_point(surfaces, [&](const glm::vec3 &point) { places.push_back(point); });
	const std::vector<ModelIsland> islands = find_islands(surfaces, places).islands;
	if (islands.size() > 1) {
		const auto size = [](const ModelIsland &one) {
			const glm::vec3 extent = one.greatest - one.least;
			return one.is_foliage ? 0.0f : std::max({ extent.x, extent.y, extent.z });
		};
		const ModelIsland &stem = *std::max_element(islands.begin(), islands.end(),
				[&](const ModelIsland &one, const ModelIsland &other) { return size(one) < size(other); });
		for (const UpAxis up : { UpAxis::plus_y, UpAxis::plus_z }) {
			if (begins_with_stem(stem, places, up)) {
				return up;
			}
		}
	}
	const glm::vec3 extent = box_of(surfaces, glm::mat3(1.0f)).extent();
	const float of_y = narrowness(surfaces, UpAxis::plus_y);
	const float of_z = narrowness(surfaces, UpAxis::plus_z);
	return extent.z > extent.y && of_z < MUCH_NARROWER * of_y ? UpAxis::plus_z : UpAxis::plus_y;
}

UpAxis find_up(const std::vector<ModelSurface> &surfaces) {
	for (const UpAxis up : AXES) {
		if (has_origin_at_base(box_of(surfaces, turn_of(up)))) {
			return up;
		}
	}
	return find_up_by_base(surfaces);
}

// The root in the turned axes.
glm::vec3 find_root(const std::vector<ModelSurface> &surfaces, const glm::mat3 &turn, const Box &box) {
	const float height = box.extent().y;
	const Box base = base_of(surfaces, turn, box);
	const float slack = 0.05f * height;
	const bool is_beside = base.least.x - slack > 0.0f || base.greatest.x + slack < 0.0f ||
			base.least.z - slack > 0.0f || base.greatest.z + slack < 0.0f;
	const bool is_buried = box.least.y < 0.0f && box.least.y >= -BURIED * height;
	const glm::vec3 centre = base.centre();
	return { is_beside ? centre.x : 0.0f, is_buried && !is_beside ? 0.0f : box.least.y, is_beside ? centre.z : 0.0f };
}

float find_scale(float height) {
	float scale = 1.0f;
	while (height * scale > TALLEST) {
		scale /= scale == 1.0f ? HUNDRED : 10.0f;
	}
	while (height * scale < SMALLEST) {
		scale *= HUNDRED;
	}
	return scale;
}

} // namespace

ModelFrame find_model_frame(const std::vector<ModelSurface> &surfaces, const ModelFrameOptions &options) {
	ModelFrame frame;
	frame.up = options.up == UpAxis::automatic ? find_up(surfaces) : options.up;
	frame.turn = turn_of(frame.up);
	const Box box = box_of(surfaces, frame.turn);
	frame.root = options.has_root ? frame.turn * options.root : find_root(surfaces, frame.turn, box);
	float tall = box.greatest.y - frame.root.y;
	if (!(tall > 0.0f)) { // It lies flat on the ground, or the root is above it.
		tall = std::max({ box.extent().x, box.extent().z, box.extent().y });
	}
	frame.scale = options.height > 0.0f ? options.height / tall : find_scale(tall);
	frame.height = tall * frame.scale;
	return frame;
}

} // namespace undergrowth
