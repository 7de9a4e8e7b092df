#include "card/card_picture.hpp"

#include "mesh/form_measure.hpp"
#include "mesh/part_template.hpp"
#include "mesh/sight_lens.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace undergrowth {

namespace {

constexpr int SAMPLES = 6; // Along each side of a texel.
constexpr int SHADE_CELLS = 24; // Along both directions across the axis.
constexpr float MAX_SHADE = 0.45f;
constexpr float MIN_RISE = 0.1f; // Of parts above those that they shade, over the radius of the head.
constexpr float MIN_SIZE = 1e-6f; // m.
constexpr int AREA_COLUMNS = 64; // Samples of covered_area().
constexpr int AREA_ROWS = 128;
constexpr float USUAL_AREA_ERROR = 0.12f; // Of the mean: with less, a picture is not turned.
constexpr int TURN_COUNT = 6;
constexpr glm::vec2 TURNS[TURN_COUNT] = { { 1.0f, 0.0f }, { 0.8660254f, 0.5f }, { 0.5f, 0.8660254f }, { 0.0f, 1.0f },
	{ -0.5f, 0.8660254f }, { -0.8660254f, 0.5f } }; // Cosines and sines of half a circle.

struct Corner {
	float x, y, depth;
};

/// A triangle in the plane of the card (m).
struct CardTriangle {
	Corner corners[3];
	glm::vec3 lights[3]; ///< By corner.
	glm::vec2 normal;
	float leafiness;

	glm::vec3 light_at(const glm::vec2 &point) const {
		const glm::vec2 one(corners[1].x - corners[0].x, corners[1].y - corners[0].y);
		const glm::vec2 other(corners[2].x - corners[0].x, corners[2].y - corners[0].y);
		const glm::vec2 from(point.x - corners[0].x, point.y - corners[0].y);
		const float twice = one.x * other.y - other.x * one.y;
		const float b = std::clamp((from.x * other.y - other.x * from.y) / twice, 0.0f, 1.0f);
		const float c = std::clamp((one.x * from.y - from.x * one.y) / twice, 0.0f, 1.0f - b);
		return lights[0] * (1.0f - b - c) + lights[1] * b + lights[2] * c;
	}
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

Corner middle_of(const CardTriangle &triangle) {
	const Corner(&c)[3] = triangle.corners;
	return { (c[0].x + c[1].x + c[2].x) / 3.0f, (c[0].y + c[1].y + c[2].y) / 3.0f,
		(c[0].depth + c[1].depth + c[2].depth) / 3.0f };
}

/// How much triangles cover from above, by place across the axis. Interpolated: a wall of few triangles shades evenly.
class ShadeGrid {
public:
	explicit ShadeGrid(float p_reach) :
			reach(p_reach),
			cell(2.0f * p_reach / SHADE_CELLS),
			covered(static_cast<size_t>((SHADE_CELLS + 1) * (SHADE_CELLS + 1)), 0.0f) {}

	void add(const CardTriangle &triangle) {
		const Corner(&c)[3] = triangle.corners;
		const float twice =
				(c[1].x - c[0].x) * (c[2].depth - c[0].depth) - (c[2].x - c[0].x) * (c[1].depth - c[0].depth);
		const float area = 0.5f * std::abs(twice) / (cell * cell);
		const Place place = place_of(middle_of(triangle));
		for (size_t i = 0; i < 4; i++) {
			covered[place.at(i)] += area * place.weight(i);
		}
	}

	float at(const Corner &point) const {
		const Place place = place_of(point);
		float sum = 0.0f;
		for (size_t i = 0; i < 4; i++) {
			sum += covered[place.at(i)] * place.weight(i);
		}
		return sum;
	}

private:
	/// Four neighbours in the grid, and the way between them.
	struct Place {
		size_t column, row;
		float x, y;

		size_t at(size_t i) const { return (row + i / 2) * (SHADE_CELLS + 1) + column + i % 2; }
		float weight(size_t i) const { return (i % 2 ? x : 1.0f - x) * (i / 2 ? y : 1.0f - y); }
	};
	const float reach;
	const float cell;
	std::vector<float> covered;

	Place place_of(const Corner &point) const {
		const float across = std::clamp((point.x + reach) / cell, 0.0f, SHADE_CELLS - 1e-3f);
		const float deep = std::clamp((point.depth + reach) / cell, 0.0f, SHADE_CELLS - 1e-3f);
		const size_t column = static_cast<size_t>(across);
		const size_t row = static_cast<size_t>(deep);
		return { column, row, across - static_cast<float>(column), deep - static_cast<float>(row) };
	}
};

/// All parts of a card at full detail, flattened.
class FlatParts {
public:
	FlatParts(const PlantForm &p_form, const CardAxis &p_axis) : form(p_form), axis(p_axis) {}

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
		std::vector<Corner> corners;
		for (const TemplateVertex &vertex : shape.vertices) {
			const glm::vec3 point = placed.base +
					PlantForm::turned(
							placed.axes, vertex.point.middle * placed.length + vertex.point.aside * placed.width);
			const FlatPoint flat = axis.flatten(point);
			corners.push_back({ flat.across, flat.along, flat.depth });
		}
		for (size_t i = 0; i + 2 < shape.indices.size(); i += 3) {
			CardTriangle triangle;
			for (size_t k = 0; k < 3; k++) {
				const size_t at = static_cast<size_t>(shape.indices[i + k]);
				const glm::vec4 &color = shape.vertices[at].color;
				triangle.corners[k] = corners[at];
				triangle.lights[k] = glm::vec3(to_light(color.x), to_light(color.y), to_light(color.z));
			}
			triangle.leafiness = part.translucency;
			triangles.push_back(triangle);
		}
	}

	/// Extents of the corners.
	CardBox box() const {
		CardBox box = { 1e9f, -1e9f, MIN_SIZE };
		for (const CardTriangle &triangle : triangles) {
			for (const Corner &corner : triangle.corners) {
				box.low = std::min(box.low, corner.y);
				box.high = std::max(box.high, corner.y);
				box.half = std::max(box.half, std::abs(corner.x));
			}
		}
		return box;
	}

	/// The same parts from another height, `middle` m along the axis.
	std::vector<CardTriangle> seen_from(float sine, float middle) const {
		const float cosine = std::sqrt(std::max(1.0f - sine * sine, 0.0f));
		std::vector<CardTriangle> turned = triangles;
		for (CardTriangle &triangle : turned) {
			for (Corner &corner : triangle.corners) {
				const float along = corner.y - middle;
				corner = { corner.x, along * cosine - corner.depth * sine, along * sine + corner.depth * cosine };
			}
		}
		return turned;
	}

	/// Turns the parts about the axis.
	void turn(const glm::vec2 &way) {
		for (CardTriangle &triangle : triangles) {
			for (Corner &corner : triangle.corners) {
				corner = { corner.x * way.x - corner.depth * way.y, corner.y, corner.x * way.y + corner.depth * way.x };
			}
		}
	}

	/// Dims what is below other parts along the axis, as stalks below flowers. Cards receive no shadows of their own
	/// parts.
	void shade() {
		const float reach = box().half;
		std::vector<size_t> from_above(triangles.size());
		std::iota(from_above.begin(), from_above.end(), size_t(0));
		std::stable_sort(from_above.begin(), from_above.end(),
				[&](size_t a, size_t b) { return middle_of(triangles[a]).y > middle_of(triangles[b]).y; });
		ShadeGrid covered(reach);
		size_t next = 0; // The highest one that is not above others yet: a petal does not shade itself.
		for (const size_t i : from_above) {
			const Corner middle = middle_of(triangles[i]);
			for (; middle_of(triangles[from_above[next]]).y > middle.y + MIN_RISE * reach; next++) {
				covered.add(triangles[from_above[next]]);
			}
			for (int k = 0; k < 3; k++) {
				const float share = std::min(covered.at(triangles[i].corners[k]), 1.0f);
				triangles[i].lights[k] *= 1.0f - MAX_SHADE * share;
			}
		}
	}

	std::vector<CardTriangle> triangles;

private:
	const PlantForm &form;
	const CardAxis &axis;
	std::map<int, PartTemplate> shapes; ///< By kind.

	PartTemplate make(const PlacedPart &placed, const Part &part) const {
		return make_part_template(part, form.midrib_of(placed), details_of(part, true).front(), mean_color(part));
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
	/// Centre of a sample, in the plane of the card (m).
	glm::vec2 point_of(int row, int column) const {
		return { (static_cast<float>(column) + 0.5f) / static_cast<float>(columns) * 2.0f * box.half - box.half,
			box.high - (static_cast<float>(row) + 0.5f) / static_cast<float>(rows) * (box.high - box.low) };
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
		const int sample_row = SAMPLES * row + i / SAMPLES;
		const int sample_column = SAMPLES * column + i % SAMPLES;
		const int front = samples.front(sample_row, sample_column, depth);
		if (front >= 0) {
			const CardTriangle &triangle = triangles[static_cast<size_t>(front)];
			texel.light += triangle.light_at(samples.point_of(sample_row, sample_column));
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

/// Returns the area that parts cover in a picture (m²).
float covered_area(const FlatParts &parts) {
	const CardBox box = parts.box();
	Samples samples(AREA_COLUMNS, AREA_ROWS, box);
	for (const CardTriangle &triangle : parts.triangles) {
		samples.draw(triangle, 0);
	}
	int covered = 0;
	for (int i = 0; i < AREA_COLUMNS * AREA_ROWS; i++) {
		float depth;
		covered += samples.front(i / AREA_COLUMNS, i % AREA_COLUMNS, depth) >= 0 ? 1 : 0;
	}
	return static_cast<float>(covered) / (AREA_COLUMNS * AREA_ROWS) * 2.0f * box.half * (box.high - box.low);
}

/// Returns the turn about the axis from which parts cover about as much as on average. Ears of two rows are narrow from
/// one side.
glm::vec2 mean_turn(const FlatParts &parts) {
	float areas[TURN_COUNT];
	float mean = 0.0f;
	for (int i = 0; i < TURN_COUNT; i++) {
		FlatParts turned = parts;
		turned.turn(TURNS[i]);
		areas[i] = covered_area(turned);
		mean += areas[i] / TURN_COUNT;
	}
	const auto error = [&](int i) { return std::abs(areas[i] - mean); };
	int best = 0;
	for (int i = 1; i < TURN_COUNT && error(0) > USUAL_AREA_ERROR * mean; i++) {
		best = error(i) < error(best) ? i : best;
	}
	return TURNS[best];
}

CardBox bordered(CardBox box, int width, int height) {
	const float middle = 0.5f * (box.low + box.high);
	const float rise =
			0.5f * std::max(box.high - box.low, MIN_SIZE) * static_cast<float>(height) / static_cast<float>(height - 2);
	return { middle - rise, middle + rise, box.half * static_cast<float>(width) / static_cast<float>(width - 2) };
}

/// The smallest edge that is not below these heights, by view. It touches two of them.
glm::vec2 enclosing_edge(const float (&heights)[HEAD_VIEW_COUNT]) {
	glm::vec2 best(0.0f);
	float least = 1e9f;
	for (int i = 0; i < HEAD_VIEW_COUNT; i++) {
		const int k = (i + 1) % HEAD_VIEW_COUNT;
		const glm::vec2 one(head_edge({ 1.0f, 0.0f }, HEAD_VIEWS[i]), head_edge({ 0.0f, 1.0f }, HEAD_VIEWS[i]));
		const glm::vec2 other(head_edge({ 1.0f, 0.0f }, HEAD_VIEWS[k]), head_edge({ 0.0f, 1.0f }, HEAD_VIEWS[k]));
		const float twice = one.x * other.y - other.x * one.y;
		const glm::vec2 edge((heights[i] * other.y - heights[k] * one.y) / twice,
				(one.x * heights[k] - other.x * heights[i]) / twice);
		float sum = 0.0f;
		for (int view = 0; view < HEAD_VIEW_COUNT; view++) {
			const float above = head_edge(edge, HEAD_VIEWS[view]) - heights[view];
			sum += above > -MIN_SIZE ? above : 1e9f;
		}
		if (sum < least) {
			least = sum;
			best = edge;
		}
	}
	return best;
}

/// With the border of the pictures.
HeadOutline outline_of(const CardBox &box, const std::vector<std::vector<CardTriangle>> &views, int width, int height) {
	HeadOutline outline;
	outline.middle = 0.5f * (box.low + box.high);
	float lows[HEAD_VIEW_COUNT], highs[HEAD_VIEW_COUNT];
	for (int view = 0; view < HEAD_VIEW_COUNT; view++) {
		lows[view] = highs[view] = -1e9f;
		for (const CardTriangle &triangle : views[static_cast<size_t>(view)]) {
			for (const Corner &corner : triangle.corners) {
				lows[view] = std::max(lows[view], -corner.y);
				highs[view] = std::max(highs[view], corner.y);
			}
		}
	}
	const glm::vec2 low = enclosing_edge(lows) * -1.0f;
	const glm::vec2 high = enclosing_edge(highs);
	const glm::vec2 rise = (high - low) * (0.5f * static_cast<float>(height) / static_cast<float>(height - 2));
	outline.low = (low + high) * 0.5f - rise;
	outline.high = (low + high) * 0.5f + rise;
	outline.half = box.half * static_cast<float>(width) / static_cast<float>(width - 2);
	return outline;
}

CardPicture draw(std::vector<CardTriangle> triangles, const CardBox &box, int width, int height) {
	CardPicture picture;
	picture.width = width;
	picture.height = height;
	picture.box = box;
	Samples samples(SAMPLES * width, SAMPLES * height, box);
	for (size_t i = 0; i < triangles.size(); i++) {
		const Corner(&corners)[3] = triangles[i].corners;
		triangles[i].normal = normal_of(corners[0], corners[1], corners[2]);
		samples.draw(triangles[i], static_cast<int>(i));
	}
	for (int row = 0; row < height; row++) {
		for (int column = 0; column < width; column++) {
			picture.texels.push_back(resolve(samples, triangles, column, row));
		}
	}
	return picture;
}

} // namespace

std::vector<CardPicture> draw_card(const PlantForm &form, const CardPlaces &all, int place, CardShape shape, int width,
		int height, HeadOutline &outline) {
	const CardPlace &own = all.places[static_cast<size_t>(place)];
	const CardAxis axis(form, own.carrier, own.from);
	FlatParts parts(form, axis);
	for (size_t i = 0; i < form.placed.size(); i++) {
		if (all.owners[i] == place) {
			parts.add(form.placed[i]);
		}
	}
	if (shape == CardShape::strip) {
		parts.turn(mean_turn(parts));
	}
	if (shape != CardShape::head) {
		return { draw(parts.triangles, bordered(parts.box(), width, height), width, height) };
	}
	parts.shade();
	const CardBox whole = parts.box();
	std::vector<std::vector<CardTriangle>> views;
	for (const float sine : HEAD_VIEWS) {
		views.push_back(parts.seen_from(sine, 0.5f * (whole.low + whole.high)));
	}
	outline = outline_of(whole, views, width, height);
	std::vector<CardPicture> pictures;
	for (size_t i = 0; i < views.size(); i++) {
		const CardBox box = { head_edge(outline.low, HEAD_VIEWS[i]), head_edge(outline.high, HEAD_VIEWS[i]),
			outline.half };
		pictures.push_back(draw(std::move(views[i]), box, width, height));
	}
	return pictures;
}

} // namespace undergrowth
