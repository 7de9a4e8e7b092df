#include "mesh/form_writer.hpp"

#include "base/portable_math.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace undergrowth {

namespace {

// Light in a canopy decreases exponentially with the leaf area above (Beer-Lambert).
constexpr double EXTINCTION = 1.6; // From the top of a plant to the ground, where a fifth remains.
constexpr float INNER_SHADE = 0.4f; // Fraction of the light in the middle of a clump.
constexpr float RANK_STEPS = 256.0f; // The sum of the rank and the code of the venation fits into a half float.
constexpr float BRIGHTNESS_SHARE = 0.25f; // Maxima of a full colour deviation, as in mesh/deviation.cpp.

float rounded_rank(float rank) {
	return std::floor(std::min(rank, 1.0f - 1.0f / RANK_STEPS) * RANK_STEPS) / RANK_STEPS;
}

} // namespace

FormWriter::FormWriter(
		const PlantForm &p_form, const FormBones &bones, const MeshOptions &options, const FormBuffers &buffers) :
		form(p_form), skeleton(bones), out(buffers), color_deviation(options.color_deviation) {
	static const auto falls = [] { // The same for all plants.
		std::array<float, HEIGHTS + 2> at;
		for (size_t i = 0; i < at.size(); i++) {
			const double below = std::max(0.0, 1.0 - static_cast<double>(i) / HEIGHTS);
			at[i] = static_cast<float>(portable_exp(-EXTINCTION * below));
		}
		return at;
	}();
	std::copy(falls.begin(), falls.end(), light);
}

float FormWriter::openness(const glm::vec3 &point) const {
	const float place = std::clamp(point.y / form.height, 0.0f, 1.0f) * HEIGHTS;
	const int below = static_cast<int>(place);
	const float t = place - static_cast<float>(below);
	const float above_it = light[below] * (1.0f - t) + light[below + 1] * t;
	const float away = std::sqrt(point.x * point.x + point.z * point.z);
	const float inside = form.reach > 0.0f ? std::max(0.0f, 1.0f - away / form.reach) : 0.0f;
	return above_it * (1.0f - INNER_SHADE * inside * inside);
}

void FormWriter::put(const Common &common, const glm::vec3 &middle, const glm::vec3 &aside, const glm::vec3 &normal,
		const glm::vec3 &along, const glm::vec4 &color, glm::vec2 uv, float offset) {
	const PartAttachment &attachment = common.attachment;
	const int i = vertices++;
	out.positions[i] = middle + aside;
	out.normals[i] = normal;
	out.tangents[i] = glm::vec4(along, 1.0f);
	const glm::vec3 tinted = glm::vec3(color) * common.brightness;
	out.colors[i] = { std::min(tinted.x, 1.0f), std::min(tinted.y, 1.0f), std::min(tinted.z, 1.0f),
		openness(middle + aside) };
	out.uvs[i] = uv;
	const float x = attachment.is_root ? stem_offset_of(form, middle) : attachment.stem_offset;
	out.stem_places[i] = attachment.is_root ? x : attachment.stem_place;
	const float weight = attachment.weight_at(offset);
	const bool is_card = common.veins >= static_cast<float>(FIRST_CARD_CODE);
	const float rank = is_card ? 0.0f : rounded_rank(attachment.rank);
	out.custom0[i] = { x, weight, common.veins + rank, common.leafiness };
	out.custom1[i] = glm::vec4(attachment.pivot, common.swing.pace);
	out.custom2[i] = glm::vec4(aside, common.swing.place);
	for (size_t k = 0; k < MAX_INNER_SWINGS && out.inner[k] != nullptr; k++) {
		const InnerSwing &inner = attachment.inner[k];
		out.inner[k][i] = static_cast<int>(k) < attachment.inner_count
				? InnerVertex{ inner.pivot, inner.weight_at(offset), inner.code }
				: InnerVertex();
	}
	skeleton.bind(attachment, x, offset, out.bones + 4 * i, out.weights + 4 * i);
}

void FormWriter::add_part(const PlacedPart &part, const PartAttachment &attachment, const PartTemplate &shape) {
	const Part &kind = form.parts[static_cast<size_t>(part.kind)];
	const float veins = static_cast<float>(venation_of(kind)) - static_cast<float>(Venation::none);
	const Common common = { attachment, attachment.code, kind.translucency, veins,
		1.0f + BRIGHTNESS_SHARE * color_deviation * part.tint };
	const float width = part.width;
	for (const int32_t index : shape.indices) {
		put_index(vertices + index);
	}
	for (const TemplateVertex &vertex : shape.vertices) {
		const SurfacePoint &point = vertex.point;
		glm::vec3 normal = surface_normal(point, part.length, width);
		if (vertex.lean != 0.0f) {
			normal = glm::normalize(normal + point.around * vertex.lean);
		}
		put(common, part.base + PlantForm::turned(part.axes, point.middle * part.length),
				PlantForm::turned(part.axes, point.aside * width), PlantForm::turned(part.axes, normal),
				PlantForm::turned(part.axes, point.along), vertex.color, vertex.uv, vertex.offset);
	}
}

void FormWriter::add_strip(const CardStrip &strip) {
	const int first = vertices;
	for (const CardStrip::Row &row : strip.rows) {
		const PartAttachment &attachment = row.attachment;
		const float brightness = 1.0f + BRIGHTNESS_SHARE * color_deviation * strip.tint;
		const Common common = { attachment, attachment.code, strip.leafiness, card_code(strip.layer, strip.turn),
			brightness };
		put(common, row.middle, row.left, row.normal, row.along, strip.color, row.left_uv, row.offset);
		put(common, row.middle, row.right, row.normal, row.along, strip.color, row.right_uv, row.offset);
	}
	for (int row = first; row + 2 < vertices; row += 2) { // Clockwise from the side of the normal.
		for (const int corner : { 1, 3, 2, 1, 2, 0 }) {
			put_index(row + corner);
		}
	}
}

float FormWriter::needed_width(const Mark &begin, const Mark &end, float shown, float near_share) const {
	float twice = 0.0f;
	for (int i = begin.index; i < end.index; i += 3) {
		twice += twice_shown(
				out.positions[out.indices[i]], out.positions[out.indices[i + 1]], out.positions[out.indices[i + 2]]);
	}
	return std::min(twice > 0.0f ? 2.0f * shown / (twice * near_share) : 1.0f, MAX_WIDENING);
}

void FormWriter::widen(const Mark &begin, const Mark &end, float factor) {
	for (int i = begin.vertex; i < end.vertex; i++) {
		const glm::vec3 aside(out.custom2[i]);
		out.positions[i] += aside * (factor - 1.0f);
		out.custom2[i] = glm::vec4(aside * factor, out.custom2[i].w);
	}
}

void FormWriter::stretch(float factor) {
	const glm::vec3 up(1.0f, factor, 1.0f);
	for (int i = 0; i < vertices && factor != 1.0f; i++) {
		out.positions[i] *= up;
		out.normals[i] = glm::normalize(out.normals[i] / up);
		out.tangents[i] = glm::vec4(glm::normalize(glm::vec3(out.tangents[i]) * up), 1.0f);
		out.custom1[i].y *= factor;
		out.custom2[i].y *= factor;
		for (size_t k = 0; k < MAX_INNER_SWINGS && out.inner[k] != nullptr; k++) {
			out.inner[k][i].pivot.y *= factor;
		}
	}
}

} // namespace undergrowth
