#include "mesh/level_error.hpp"

#include "mesh/card_strip.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace undergrowth {

namespace {

constexpr float DOTS = 320.0f; // Along the longer side of a view.
constexpr float BORDER = 0.125f; // Around the plant, as a share of its view: levels may exceed it.
constexpr double SHARE = 0.95;
// Chamfer distances (Borgefors 1986): a step to a neighbour and to a diagonal neighbour, within 8 % of the true one.
constexpr uint16_t STEP = 3;
constexpr uint16_t DIAGONAL = 4;
constexpr uint16_t FAR = 30000;

/// Directions of view: across and up, as rows of a rotation. From two sides 17° above, and from 63° above.
struct Direction {
	glm::vec3 across;
	glm::vec3 up;
};
constexpr float LOW_SINE = 0.292f;
constexpr float LOW_COSINE = 0.956f;
constexpr float HIGH_SINE = 0.891f;
constexpr float HIGH_COSINE = 0.454f;
const Direction DIRECTIONS[] = {
	{ { 1.0f, 0.0f, 0.0f }, { 0.0f, LOW_COSINE, -LOW_SINE } },
	{ { 0.0f, 0.0f, 1.0f }, { -LOW_SINE, LOW_COSINE, 0.0f } },
	{ { 1.0f, 0.0f, 0.0f }, { 0.0f, HIGH_COSINE, -HIGH_SINE } },
};

std::vector<glm::vec2> project(const SeenMesh &mesh, const Direction &way) {
	std::vector<glm::vec2> flat;
	flat.reserve(static_cast<size_t>(mesh.vertex_count));
	for (int i = 0; i < mesh.vertex_count; i++) {
		const glm::vec3 &point = mesh.positions[i];
		flat.emplace_back(point.x * way.across.x + point.y * way.across.y + point.z * way.across.z,
				point.x * way.up.x + point.y * way.up.y + point.z * way.up.z);
	}
	return flat;
}

/// A picture whose dots are 0 where a triangle covers them, else FAR.
class Picture {
public:
	Picture(int p_columns, int p_rows) :
			columns(p_columns), rows(p_rows), dots(static_cast<size_t>(p_columns) * static_cast<size_t>(p_rows), FAR) {}

	/// Corners in dots. Marks dots with their centre inside, and all dots along the edges: thin parts stay connected.
	void draw(glm::vec2 a, glm::vec2 b, glm::vec2 c) {
		draw_line(a, b);
		draw_line(b, c);
		draw_line(c, a);
		if (b.y < a.y) {
			std::swap(a, b);
		}
		if (c.y < b.y) {
			std::swap(b, c);
		}
		if (b.y < a.y) {
			std::swap(a, b);
		}
		const int end = std::min(rows, first_beyond(c.y));
		for (int row = std::max(0, first_beyond(a.y)); row < end; row++) {
			const float level = static_cast<float>(row) + 0.5f;
			const float one = at(a, c, level);
			const float other = level < b.y ? at(a, b, level) : at(b, c, level);
			const int last = std::min(columns, first_beyond(std::max(one, other)));
			for (int column = std::max(0, first_beyond(std::min(one, other))); column < last; column++) {
				mark(column, row);
			}
		}
	}

	/// The same for the dots whose place in the texture, from those of the corners, is covered.
	template <class Covers>
	void draw_card(const glm::vec2 (&corners)[3], const glm::vec2 (&uvs)[3], const Covers &covers) {
		const glm::vec2 one = corners[1] - corners[0];
		const glm::vec2 other = corners[2] - corners[0];
		const float twice = one.x * other.y - other.x * one.y;
		if (twice == 0.0f) {
			return;
		}
		const auto low = [&](float a, float b, float c) { return first_beyond(std::min({ a, b, c })); };
		const auto high = [&](float a, float b, float c) { return first_beyond(std::max({ a, b, c })); };
		const int last_row = std::min(rows, high(corners[0].y, corners[1].y, corners[2].y));
		const int last_column = std::min(columns, high(corners[0].x, corners[1].x, corners[2].x));
		const int first_column = std::max(0, low(corners[0].x, corners[1].x, corners[2].x));
		for (int row = std::max(0, low(corners[0].y, corners[1].y, corners[2].y)); row < last_row; row++) {
			for (int column = first_column; column < last_column; column++) {
				const glm::vec2 from =
						glm::vec2(static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f) - corners[0];
				const float b = (from.x * other.y - other.x * from.y) / twice;
				const float c = (one.x * from.y - from.x * one.y) / twice;
				if (b >= 0.0f && c >= 0.0f && b + c <= 1.0f &&
						covers(uvs[0] + (uvs[1] - uvs[0]) * b + (uvs[2] - uvs[0]) * c)) {
					mark(column, row);
				}
			}
		}
	}

	/// Replaces each dot by its distance to the nearest marked one.
	void find_distances() {
		for (int row = 0; row < rows; row++) {
			uint16_t *own = row_of(row);
			if (row > 0) {
				relax_row(own, row_of(row - 1));
			}
			for (int column = 1; column < columns; column++) {
				own[column] = nearer(own[column], own[column - 1], STEP);
			}
		}
		for (int row = rows - 1; row >= 0; row--) {
			uint16_t *own = row_of(row);
			if (row + 1 < rows) {
				relax_row(own, row_of(row + 1));
			}
			for (int column = columns - 1; column > 0; column--) {
				own[column - 1] = nearer(own[column - 1], own[column], STEP);
			}
		}
	}

	std::vector<uint16_t> &values() { return dots; }

private:
	const int columns;
	const int rows;
	std::vector<uint16_t> dots;

	static int first_beyond(float place) {
		return static_cast<int>(std::clamp(place, -1e6f, 1e6f) + 1e6f + 0.5f) - 1000000;
	}
	static float at(const glm::vec2 &low, const glm::vec2 &high, float level) {
		const float rise = high.y - low.y;
		return rise > 0.0f ? low.x + (high.x - low.x) * ((level - low.y) / rise) : low.x;
	}
	void mark(int column, int row) { dots[static_cast<size_t>(row * columns + column)] = 0; }
	void draw_line(const glm::vec2 &from, const glm::vec2 &to) {
		const float length = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
		const int steps = static_cast<int>(std::min(length, 4.0f * DOTS)) + 1;
		for (int i = 0; i <= steps; i++) {
			const float way = static_cast<float>(i) / static_cast<float>(steps);
			const int column = static_cast<int>(std::floor(from.x + (to.x - from.x) * way));
			const int row = static_cast<int>(std::floor(from.y + (to.y - from.y) * way));
			if (column >= 0 && column < columns && row >= 0 && row < rows) {
				mark(column, row);
			}
		}
	}
	uint16_t *row_of(int row) { return dots.data() + static_cast<size_t>(row) * static_cast<size_t>(columns); }
	static uint16_t nearer(uint16_t own, uint16_t other, uint16_t cost) {
		return std::min(own, static_cast<uint16_t>(other + cost));
	}
	/// Lowers distances to those by way of the three dots in the row beside. One loop for each dot: compilers vectorize
	/// them.
	void relax_row(uint16_t *own, const uint16_t *beside) const {
		for (int column = 0; column < columns; column++) {
			own[column] = nearer(own[column], beside[column], STEP);
		}
		for (int column = 1; column < columns; column++) {
			own[column] = nearer(own[column], beside[column - 1], DIAGONAL);
		}
		for (int column = 1; column < columns; column++) {
			own[column - 1] = nearer(own[column - 1], beside[column], DIAGONAL);
		}
	}
};

int code_of(const SeenCards &cards, int32_t vertex) {
	return static_cast<int>(cards.custom0[vertex].z) - FIRST_CARD_CODE;
}

/// Positions with all cards turned to a view, as shaders turn them, and the pictures of the cards.
struct TurnedCards {
	std::vector<glm::vec3> points;
	std::vector<float> pictures; ///< By vertex: layer, with the share of the next one as its fraction; -1: no card.

	TurnedCards(const SeenMesh &mesh, const SeenCards &cards, const Direction &way) :
			points(mesh.positions, mesh.positions + mesh.vertex_count), pictures(points.size(), -1.0f) {
		const glm::vec3 eye = glm::cross(way.across, way.up);
		for (int i = 0; i < mesh.vertex_count; i++) {
			const int code = code_of(cards, i);
			if (code >= 0) {
				pictures[static_cast<size_t>(i)] = static_cast<float>(code / CARD_CODES);
			}
			if (code < 0 || code % CARD_CODES == static_cast<int>(CardTurn::fixed)) {
				continue;
			}
			const bool is_head = code % CARD_CODES == static_cast<int>(CardTurn::head);
			const glm::vec3 aside(cards.custom2[i]);
			const glm::vec3 &axis = cards.normals[i];
			const glm::vec3 out(cards.tangents[i]);
			const glm::vec3 beside = glm::cross(eye, axis);
			const glm::vec3 side = beside / std::max(glm::length(beside), 1e-6f);
			const glm::vec2 edge = is_head ? glm::vec2(glm::dot(aside, axis), glm::dot(aside, out)) : glm::vec2(0.0f);
			const float reach = glm::length(aside - axis * edge.x - out * edge.y);
			const float sine = glm::dot(axis, eye);
			points[static_cast<size_t>(i)] += side * (cards.uvs[i].x < 0.5f ? -reach : reach) - aside;
			if (is_head) {
				points[static_cast<size_t>(i)] += glm::cross(side, eye) * head_edge(edge, sine);
				pictures[static_cast<size_t>(i)] += head_picture(sine);
			}
		}
	}
};

bool covers(const SeenCards &cards, float picture, const glm::vec2 &uv) {
	const int x = std::clamp(static_cast<int>(uv.x * static_cast<float>(cards.width)), 0, cards.width - 1);
	const int y = std::clamp(static_cast<int>(uv.y * static_cast<float>(cards.height)), 0, cards.height - 1);
	const size_t layer = static_cast<size_t>(picture);
	const float share = picture - static_cast<float>(layer);
	const size_t at = static_cast<size_t>(4 * (y * cards.width + x) + 3);
	const float alpha = static_cast<float>(cards.layers[layer][at]);
	const float next = share > 0.0f ? static_cast<float>(cards.layers[layer + 1][at]) : alpha;
	return alpha + (next - alpha) * share + 255.0f * head_gain(share) >= 128.0f;
}

void draw_cards(const SeenMesh &mesh, const SeenCards &cards, const std::vector<float> &pictures,
		const std::vector<glm::vec2> &flat, const glm::vec2 &corner, float dot, Picture &into) {
	for (int i = 0; i + 2 < mesh.index_count; i += 3) {
		glm::vec2 corners[3], uvs[3];
		for (int k = 0; k < 3; k++) {
			corners[k] = (flat[static_cast<size_t>(mesh.indices[i + k])] - corner) / dot;
			uvs[k] = cards.uvs[mesh.indices[i + k]];
		}
		const float picture = pictures[static_cast<size_t>(mesh.indices[i])];
		if (picture < 0.0f) {
			into.draw(corners[0], corners[1], corners[2]);
		} else {
			into.draw_card(corners, uvs, [&](const glm::vec2 &uv) { return covers(cards, picture, uv); });
		}
	}
}

void draw_mesh(
		const SeenMesh &mesh, const std::vector<glm::vec2> &flat, const glm::vec2 &corner, float dot, Picture &into) {
	const auto dots = [&](int32_t vertex) { return (flat[static_cast<size_t>(vertex)] - corner) / dot; };
	for (int i = 0; i + 2 < mesh.index_count; i += 3) {
		into.draw(dots(mesh.indices[i]), dots(mesh.indices[i + 1]), dots(mesh.indices[i + 2]));
	}
}

/// Adds up the distances of one picture's covered dots to the other picture. Each row of dots has a weight of 1.
void count(const std::vector<uint16_t> &covered, const std::vector<uint16_t> &away, int columns,
		std::vector<double> &weights) {
	const size_t width = static_cast<size_t>(columns);
	for (size_t row = 0; row + width <= covered.size(); row += width) {
		const auto begin = covered.begin() + static_cast<std::ptrdiff_t>(row);
		const auto dots = std::count(begin, begin + columns, uint16_t(0));
		for (size_t i = row; i < row + width && dots > 0; i++) {
			if (covered[i] == 0) {
				weights[std::min<size_t>(away[i], weights.size() - 1)] += 1.0 / static_cast<double>(dots);
			}
		}
	}
}

/// Returns the distance (dots) within which this share of all weights is.
float distance_of(const std::vector<double> &weights, double share) {
	double all = 0.0;
	for (const double some : weights) {
		all += some;
	}
	double within = 0.0;
	size_t at = 0;
	while (at + 1 < weights.size() && (within += weights[at]) < share * all) {
		at++;
	}
	return static_cast<float>(at) / static_cast<float>(STEP);
}

} // namespace

LevelError::LevelError(const SeenMesh &whole) {
	float longest = 0.0f;
	std::vector<std::vector<glm::vec2>> all;
	std::vector<glm::vec2> lows;
	std::vector<glm::vec2> sizes;
	for (const Direction &way : DIRECTIONS) {
		all.push_back(project(whole, way));
		glm::vec2 low(std::numeric_limits<float>::max());
		glm::vec2 high(-std::numeric_limits<float>::max());
		for (const glm::vec2 &point : all.back()) {
			low = { std::min(low.x, point.x), std::min(low.y, point.y) };
			high = { std::max(high.x, point.x), std::max(high.y, point.y) };
		}
		lows.push_back(low);
		sizes.push_back(high - low);
		longest = std::max({ longest, sizes.back().x, sizes.back().y });
	}
	if (!(longest > 0.0f) || !std::isfinite(longest)) {
		return;
	}
	dot_size = longest * (1.0f + 2.0f * BORDER) / DOTS;
	for (size_t i = 0; i < all.size(); i++) {
		View view;
		view.left = lows[i].x - BORDER * longest;
		view.low = lows[i].y - BORDER * longest;
		view.columns = static_cast<int>((sizes[i].x + 2.0f * BORDER * longest) / dot_size) + 1;
		view.rows = static_cast<int>((sizes[i].y + 2.0f * BORDER * longest) / dot_size) + 1;
		Picture picture(view.columns, view.rows);
		draw_mesh(whole, all[i], { view.left, view.low }, dot_size, picture);
		picture.find_distances();
		view.away = std::move(picture.values());
		views.push_back(std::move(view));
	}
}

float LevelError::of(const SeenMesh &level) const {
	return measure(level, nullptr);
}

float LevelError::of(const SeenMesh &level, const SeenCards &cards) const {
	return measure(level, &cards);
}

float LevelError::measure(const SeenMesh &level, const SeenCards *cards) const {
	if (views.empty()) {
		return 0.0f;
	}
	std::vector<double> weights(static_cast<size_t>(STEP) * static_cast<size_t>(2.0f * DOTS), 0.0);
	for (size_t i = 0; i < views.size(); i++) {
		const View &view = views[i];
		Picture picture(view.columns, view.rows);
		if (cards) {
			const TurnedCards all(level, *cards, DIRECTIONS[i]);
			const SeenMesh turned = { all.points.data(), level.vertex_count, level.indices, level.index_count };
			draw_cards(turned, *cards, all.pictures, project(turned, DIRECTIONS[i]), { view.left, view.low }, dot_size,
					picture);
		} else {
			draw_mesh(level, project(level, DIRECTIONS[i]), { view.left, view.low }, dot_size, picture);
		}
		picture.find_distances();
		count(picture.values(), view.away, view.columns, weights);
		count(view.away, picture.values(), view.columns, weights);
	}
	return dot_size * std::max(0.5f, distance_of(weights, SHARE));
}

} // namespace undergrowth
