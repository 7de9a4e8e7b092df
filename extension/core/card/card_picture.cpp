#include "card/card_picture.hpp"

#include "mesh/form_measure.hpp"
#include "mesh/part_template.hpp"
#include "mesh/shown_tone.hpp"
#include "mesh/sight_lens.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace undergrowth {

namespace {

constexpr int SAMPLES = 6; // Along each side of a texel.
constexpr float MIN_SIZE = 1e-6f; // m.

struct Corner {
	float x, y, depth;
};

/// A triangle in the plane of the card (m), with the means of its corners.
struct CardTriangle {
	Corner corners[3];
	glm::vec3 light;
	glm::vec2 normal;
	float leafiness;
};

/// The normal of the side that the camera sees, without its part towards the camera.
glm::vec2 normal_of(const Corner &a, const Corner &b, const Corner &c) {
	const glm::vec3 one(b.x - a.x, b.y - a.y, b.depth - a.depth);
	const glm::vec3 other(c.x - a.x, c.y - a.y, c.depth - a.depth);
	const glm::vec3 normal = glm::cross(one, other);
	const float length = glm::length(normal);
	const float scale = length > 0.0f ? (normal.z < 0.0f ? -1.0f : 1.0f) / length : 0.0f;
	return { normal.x * scale, normal.y * scale };
}

/// All parts of a card at full detail, flattened.
class FlatParts {
public:
	FlatParts(const PlantForm &p_form, const CardAxis &p_axis, bool p_from_above) :
			form(p_form), axis(p_axis), from_above(p_from_above) {}

	void add(const PlacedPart &placed) {
		const Part &part = form.parts[static_cast<size_t>(placed.kind)];
		PartTemplate own;
		if (placed.own_midrib >= 0) {
			own = make(placed, part);
		}
		const auto known = shapes.find(placed.kind);
		const PartTemplate &shape = placed.own_midrib >= 0 ? own
				: known != shapes.end()					   ? known->second
										: shapes.emplace(placed.kind, make(placed, part)).first->second;
		const Venation veins = venation_of(part);
		std::vector<Corner> corners;
		for (const TemplateVertex &vertex : shape.vertices) {
			const glm::vec3 point = placed.base +
					PlantForm::turned(
							placed.axes, vertex.point.middle * placed.length + vertex.point.aside * placed.width);
			const FlatPoint flat = from_above ? axis.from_above(point) : axis.flatten(point);
			corners.push_back({ flat.across, flat.along, flat.depth });
		}
		for (size_t i = 0; i + 2 < shape.indices.size(); i += 3) {
			CardTriangle triangle;
			triangle.light = glm::vec3(0.0f);
			for (size_t k = 0; k < 3; k++) {
				const size_t at = static_cast<size_t>(shape.indices[i + k]);
				const glm::vec4 &color = shape.vertices[at].color;
				const float tone = petal_tone(veins, shape.vertices[at].uv.y) / 3.0f;
				triangle.corners[k] = corners[at];
				triangle.light += glm::vec3(to_light(color.x), to_light(color.y), to_light(color.z)) * tone;
			}
			triangle.normal = normal_of(triangle.corners[0], triangle.corners[1], triangle.corners[2]);
			triangle.leafiness = part.translucency;
			triangles.push_back(triangle);
		}
	}

	CardBox box(int width, int height) const {
		CardBox box = { 1e9f, -1e9f, 0.0f };
		for (const CardTriangle &triangle : triangles) {
			for (const Corner &corner : triangle.corners) {
				box.low = std::min(box.low, corner.y);
				box.high = std::max(box.high, corner.y);
				box.half = std::max(box.half, std::abs(corner.x));
			}
		}
		if (from_above) {
			box.half = std::max({ box.half, std::abs(box.low), std::abs(box.high) });
			box.low = -box.half;
			box.high = box.half;
		}
		// A border of one texel.
		const float middle = 0.5f * (box.low + box.high);
		const float rise = 0.5f * std::max(box.high - box.low, MIN_SIZE) * static_cast<float>(height) /
				static_cast<float>(height - 2);
		box.half = std::max(box.half, MIN_SIZE) * static_cast<float>(width) / static_cast<float>(width - 2);
		box.low = middle - rise;
		box.high = middle + rise;
		return box;
	}

	std::vector<CardTriangle> triangles;

private:
	const PlantForm &form;
	const CardAxis &axis;
	const bool from_above;
	std::map<int, PartTemplate> shapes; ///< By kind.

	PartTemplate make(const PlacedPart &placed, const Part &part) const {
		return make_part_template(part, form.midrib_of(placed), details_of(part).front(), mean_color(part));
	}
};

/// The nearest triangle at each sample.
class Samples {
public:
	Samples(int p_columns, int p_rows, const CardBox &p_box) :
			columns(p_columns),
			rows(p_rows),
			box(p_box),
			depths(static_cast<size_t>(p_columns) * static_cast<size_t>(p_rows), -1e9f),
			fronts(depths.size(), -1) {}

	void draw(const CardTriangle &triangle, int number) {
		Corner a = place(triangle.corners[0]);
		Corner b = place(triangle.corners[1]);
		Corner c = place(triangle.corners[2]);
		const float twice = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
		if (twice == 0.0f) {
			return;
		}
		const float slope_x = ((b.depth - a.depth) * (c.y - a.y) - (c.depth - a.depth) * (b.y - a.y)) / twice;
		const float slope_y = ((c.depth - a.depth) * (b.x - a.x) - (b.depth - a.depth) * (c.x - a.x)) / twice;
		const Corner origin = a;
		sort(a, b);
		sort(b, c);
		sort(a, b);
		for (int row = first_beyond(a.y); row < std::min(rows, first_beyond(c.y)); row++) {
			const float level = static_cast<float>(row) + 0.5f;
			const float one = at(a, c, level);
			const float other = level < b.y ? at(a, b, level) : at(b, c, level);
			const int end = std::min(columns, first_beyond(std::max(one, other)));
			for (int column = first_beyond(std::min(one, other)); column < end; column++) {
				const float x = static_cast<float>(column) + 0.5f - origin.x;
				put(row, column, origin.depth + slope_x * x + slope_y * (level - origin.y), number);
			}
		}
	}
	int front(int row, int column, float &depth) const {
		const size_t at = static_cast<size_t>(row) * static_cast<size_t>(columns) + static_cast<size_t>(column);
		depth = depths[at];
		return fronts[at];
	}

private:
	const int columns;
	const int rows;
	const CardBox box;
	std::vector<float> depths;
	std::vector<int> fronts;

	Corner place(const Corner &flat) const {
		return { (flat.x + box.half) / (2.0f * box.half) * static_cast<float>(columns),
			(box.high - flat.y) / (box.high - box.low) * static_cast<float>(rows), flat.depth };
	}
	static void sort(Corner &low, Corner &high) {
		if (high.y < low.y) {
			std::swap(low, high);
		}
	}
	static float at(const Corner &low, const Corner &high, float level) {
		const float rise = high.y - low.y;
		return rise > 0.0f ? low.x + (high.x - low.x) * ((level - low.y) / rise) : low.x;
	}
	void put(int row, int column, float depth, int number) {
		const size_t at = static_cast<size_t>(row) * static_cast<size_t>(columns) + static_cast<size_t>(column);
		if (depth > depths[at]) {
			depths[at] = depth;
			fronts[at] = number;
		}
	}
};

CardTexel resolve(const Samples &samples, const std::vector<CardTriangle> &triangles, int column, int row) {
	CardTexel texel;
	int covered = 0;
	for (int i = 0; i < SAMPLES * SAMPLES; i++) {
		float depth;
		const int front = samples.front(SAMPLES * row + i / SAMPLES, SAMPLES * column + i % SAMPLES, depth);
		if (front >= 0) {
			const CardTriangle &triangle = triangles[static_cast<size_t>(front)];
			texel.light += triangle.light;
			texel.normal += triangle.normal;
			texel.leafiness += triangle.leafiness;
			texel.depth += depth;
			covered++;
		}
	}
	if (covered > 0) {
		const float share = 1.0f / static_cast<float>(covered);
		texel.coverage = static_cast<float>(covered) / static_cast<float>(SAMPLES * SAMPLES);
		texel.light *= share;
		texel.normal *= share;
		texel.leafiness *= share;
		texel.depth *= share;
	}
	return texel;
}

} // namespace

CardPicture draw_card(const PlantForm &form, const CardPlaces &all, int place, bool from_above, int width, int height) {
	const CardPlace &own = all.places[static_cast<size_t>(place)];
	const CardAxis axis(form, own.carrier, own.from);
	FlatParts parts(form, axis, from_above);
	for (size_t i = 0; i < form.placed.size(); i++) {
		if (all.owners[i] == place) {
			parts.add(form.placed[i]);
		}
	}
	CardPicture picture;
	picture.width = width;
	picture.height = height;
	picture.box = parts.box(width, height);
	Samples samples(SAMPLES * width, SAMPLES * height, picture.box);
	for (size_t i = 0; i < parts.triangles.size(); i++) {
		samples.draw(parts.triangles[i], static_cast<int>(i));
	}
	for (int row = 0; row < height; row++) {
		for (int column = 0; column < width; column++) {
			picture.texels.push_back(resolve(samples, parts.triangles, column, row));
		}
	}
	return picture;
}

} // namespace undergrowth
