#include "mesh/form_body.hpp"

#include "base/portable_math.hpp"
#include "conventions.hpp"
#include "mesh/plan_steps.hpp"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace undergrowth {

namespace {

constexpr int PLACES = 3; // Measured positions of a part: base, middle, tip.
constexpr float MAX_ENLARGEMENT = 2.0f; // Limit of an area factor.
constexpr float FEW = 3.5f; // More replaced bodies than this lengthen a spindle.
constexpr float MAX_LENGTHENING = 2.5f; // Limit of a length factor.
constexpr float MAX_RISE = 0.6f; // Fraction of a flat whorl's radius.
constexpr float MIN_RADIUS_SHARE = 0.4f; // Fraction of a lathe's radius.
constexpr float MAX_STOUTNESS = 0.4f; // Silhouette of a spindle, as a fraction of its squared length.
constexpr float MIN_RADIUS = 1e-4f; // m.
constexpr float MIN_END = 0.1f; // Fraction of a spindle's length between its widest ring and an end.
constexpr float EVEN_LENGTH = 3.4641f; // Length of an even rod over the standard deviation of its points.
constexpr float MIN_SPREAD = 0.35f; // Of broad bodies, as a fraction of that length.
constexpr float MIN_TOP = 0.6f; // Mean height of their area, as a fraction of their length.
constexpr float MAX_TAPER = 0.4f; // Of a rod: change of its radius from the middle to an end.
constexpr float DISC_RADIUS = 1.4142f; // Radius of an even disc over its root mean square.

/// A third of the area of a part (m²).
struct ColoredArea {
	float along;
	float area;
	glm::vec4 color;
};

/// Measures of a body's parts in its own axes.
struct Measure {
	float low = 1e9f;
	float high = -1e9f;
	float farthest = 0.0f; ///< Of midribs (m).
	float reach = 0.0f; ///< Of edges (m).
	float area = 0.0f; ///< Area of parts (m²).
	float shown = 0.0f; ///< Silhouette without occlusion (m²).
	double moment = 0.0; ///< Area times the distance along the axis.
	double moment_2 = 0.0; ///< Area times the squared distance along the axis.
	double spread = 0.0; ///< Area times the squared distance from the axis.
	float shine = 0.0f;
	std::vector<ColoredArea> areas;
	// Means over the parts that are attached to the carrier itself:
	float along[PLACES] = {};
	float away[PLACES] = {};
	float lid = 0.0f; ///< m², of those parts.
	int count = 0;
};

struct OwnPlace {
	float along;
	float away;
};

/// Origin of the measures of parts of a body.
struct Origin {
	glm::vec3 place; ///< m.
	glm::vec3 along;
	float before; ///< m along the carrier, from the body's origin.
};

/// Returns the attachment on the body's carrier, of a part or of the part that carries it. The carrier is curved.
Origin origin_of(const FormBody &body, const PlantForm &form, const PlacedPart &placed) {
	const PlacedPart *own = &placed;
	while (own->group != body.group) {
		own = &form.placed[static_cast<size_t>(own->carrier)];
	}
	const float first = form.placed[static_cast<size_t>(body.first)].offset;
	if (own->carrier == ON_GROUND || own->offset == first) {
		return { body.origin, body.axes.along, 0.0f };
	}
	const PlacedPart &carrier = form.placed[static_cast<size_t>(own->carrier)];
	return { form.point_of(carrier, own->offset), form.axes_of(carrier, own->offset).along,
		(own->offset - first) * carrier.length };
}

OwnPlace place_from(const Origin &origin, const glm::vec3 &point) {
	const glm::vec3 way = point - origin.place;
	const float along = glm::dot(way, origin.along);
	return { origin.before + along, glm::length(way - origin.along * along) };
}

void add(
		Measure &m, const FormBody &body, const PlantForm &form, const FormMeasure &measure, const PlacedPart &placed) {
	const Part &part = form.parts[static_cast<size_t>(placed.kind)];
	const glm::vec4 &color = measure.colors[static_cast<size_t>(placed.kind)];
	const size_t group = static_cast<size_t>(placed.group);
	const bool is_own = placed.group == body.group;
	const Origin origin = origin_of(body, form, placed);
	const float area = placed.length * placed.width * measure.mean_widths[static_cast<size_t>(placed.kind)];
	for (int i = 0; i < PLACES; i++) {
		const OwnPlace own = place_from(origin, form.point_of(placed, 0.5f * static_cast<float>(i)));
		m.low = std::min(m.low, own.along);
		m.high = std::max(m.high, own.along);
		m.farthest = std::max(m.farthest, own.away);
		m.reach = std::max(m.reach, own.away + 0.5f * placed.width * part.width_at(0.5f * static_cast<float>(i)));
		m.along[i] += is_own ? own.along : 0.0f;
		m.away[i] += is_own ? own.away : 0.0f;
		m.moment += static_cast<double>(area * own.along / PLACES);
		m.moment_2 += static_cast<double>(area * own.along * own.along / PLACES);
		m.spread += static_cast<double>(area * own.away * own.away / PLACES);
		m.areas.push_back({ own.along, area / PLACES, color });
	}
	m.count += is_own ? 1 : 0;
	m.lid += is_own ? area : 0.0f;
	m.area += area;
	m.shown += measure.shown[group] / static_cast<float>(form.groups[group].count);
	m.shine += part.translucency * area;
}

/// Overlapping parts of area A cover H·(1 - exp(-A/H)) of an envelope H; here as a rational approximation.
float covered(float area, float envelope) {
	return envelope > 0.0f ? area / (1.0f + area / envelope) : area;
}

void shape_dome(FormBody &body, const Measure &m, float dome) {
	if (dome > HALF_SPHERE) {
		const float middle = 0.5f * (m.low + m.high);
		// Two cones with the area of the sphere from the side: π/2 of its radius.
		body.rings = { { m.low, 0.0f }, { middle, 1.57f * m.farthest }, { m.high, 0.0f } };
		body.has_base = true;
	} else {
		body.rings = { { m.low, m.farthest }, { m.high, 0.0f } };
	}
	body.has_tip = true;
}

/// Matches the area of a lathe from the side to that of its parts. A flat whorl is not visible from the side as a lathe
/// of midribs. Its parts are, because they lean, fold and curl. So the lathe rises until its area matches.
void thicken(FormBody &body, const Measure &m) {
	float widest = 0.0f;
	float low = body.rings.front().along;
	float high = low;
	for (const FormBody::Ring &ring : body.rings) {
		widest = std::max(widest, ring.radius);
		low = std::min(low, ring.along);
		high = std::max(high, ring.along);
	}
	const float wanted = 0.5f * m.shown; // The nearer half of the parts hides the farther half.
	const float shows = widest * (high - low);
	if (shows > 1.3f * wanted) { // Thin upright parts hide less of what is inside them than their lathe.
		for (FormBody::Ring &ring : body.rings) {
			ring.radius *= std::max(wanted / shows, MIN_RADIUS_SHARE);
		}
		return;
	}
	if (shows >= std::min(wanted, MAX_RISE * widest * widest) || !(widest > 0.0f)) {
		return;
	}
	const float rise = std::min(wanted / widest, MAX_RISE * widest);
	const float sign = body.rings.back().along < body.rings.front().along ? -1.0f : 1.0f;
	const float base = body.rings.front().along;
	for (size_t i = 1; i < body.rings.size(); i++) {
		body.rings[i].along = base + sign * rise * static_cast<float>(i) / static_cast<float>(body.rings.size() - 1);
	}
}

/// Makes the lathe of the mean midrib. If it is flat and the parts leave gaps, its radius is reduced to their area.
void shape_lathe(FormBody &body, const Measure &m) {
	const auto mean = [&m](int i) {
		return FormBody::Ring(m.along[i] / static_cast<float>(m.count), m.away[i] / static_cast<float>(m.count));
	};
	FormBody::Ring ways[PLACES] = { mean(0), mean(1), mean(2) };
	const float rise = std::abs(ways[2].along - ways[0].along);
	const float max = std::sqrt(ways[0].radius * ways[0].radius + m.lid / static_cast<float>(PI));
	if (rise < ways[2].radius - ways[0].radius && max < ways[2].radius) {
		ways[1].radius *= max / ways[2].radius;
		ways[2].radius = max;
	}
	body.rings.push_back({ ways[0].along, 0.0f });
	if (body.detail.rings > 1) {
		body.rings.push_back(ways[1]);
	}
	body.rings.push_back(ways[2]);
	if (body.detail.rings == 1) { // A cone has the lathe's mean width.
		body.rings.back().radius =
				std::max(ways[2].radius, 0.25f * ways[0].radius + ways[1].radius + 0.25f * ways[2].radius);
	}
	body.has_base = true;
	thicken(body, m);
}

/// Radius of an even disc of the same spread (m).
float spread_of(const Measure &m) {
	const double area = std::max(static_cast<double>(m.area), 1e-12);
	return std::min(DISC_RADIUS * std::sqrt(static_cast<float>(m.spread / area)), std::max(m.farthest, MIN_RADIUS));
}

/// True if its parts spread and most of their area is near the top, as in umbels.
bool is_broad(const Measure &m) {
	const double area = std::max(static_cast<double>(m.area), 1e-12);
	const double mean = m.moment / area;
	const float variance = static_cast<float>(m.moment_2 / area - mean * mean);
	const float length = EVEN_LENGTH * std::sqrt(std::max(variance, 0.0f));
	return static_cast<float>(mean) > m.low + MIN_TOP * (m.high - m.low) && spread_of(m) > MIN_SPREAD * length;
}

/// A broad one keeps the radius of its parts and is shorter, so that an umbel is flat. It is widest where most of their
/// area is. All others keep their length. The area from the side is the same.
void shape_spindle(FormBody &body, const Measure &m) {
	const float length = std::max(m.high - m.low, MIN_RADIUS);
	const float farthest = std::max(m.farthest, MIN_RADIUS);
	body.shown = covered(m.shown, 2.0f * farthest * length);
	body.has_base = body.has_tip = true;
	if (!is_broad(m)) {
		body.rings = { { m.low, 0.0f }, { 0.5f * (m.low + m.high), body.shown / length }, { m.high, 0.0f } };
		return;
	}
	const float mean = static_cast<float>(m.moment / std::max(static_cast<double>(m.area), 1e-12));
	const float middle = std::clamp(mean, m.low + MIN_END * length, m.high - MIN_END * length);
	const float radius = std::max(spread_of(m), body.shown / length);
	const float share = body.shown / (radius * length);
	body.rings = { { middle - share * (middle - m.low), 0.0f }, { middle, radius },
		{ middle + share * (m.high - middle), 0.0f } };
}

/// Mean colour with these shares, by area.
glm::vec4 mean_of(const std::vector<ColoredArea> &areas, const std::vector<float> &shares) {
	glm::vec3 squares(0.0f);
	float alpha = 0.0f, area = 0.0f;
	for (size_t i = 0; i < areas.size(); i++) {
		squares += glm::vec3(areas[i].color) * glm::vec3(areas[i].color) * shares[i];
		alpha += areas[i].color.w * shares[i];
		area += shares[i];
	}
	area = std::max(area, 1e-18f);
	return glm::vec4(glm::sqrt(squares / area), alpha / area);
}

/// Mean colour of the parts below this height; of all parts without any there.
glm::vec4 color_below(const Measure &m, float height) {
	std::vector<float> shares;
	for (const ColoredArea &own : m.areas) {
		shares.push_back(own.along < height ? own.area : 1e-6f * own.area);
	}
	return mean_of(m.areas, shares);
}

/// Mean colour as seen from the tip: parts hide those behind them, as layers of random leaves do (Beer-Lambert).
/// `disc`: area over which they are spread (m²).
glm::vec4 color_from_tip(const Measure &m, float disc) {
	std::vector<ColoredArea> areas = m.areas;
	std::stable_sort(
			areas.begin(), areas.end(), [](const ColoredArea &a, const ColoredArea &b) { return a.along > b.along; });
	std::vector<float> shares;
	double before = 0.0;
	for (const ColoredArea &own : areas) {
		shares.push_back(own.area * static_cast<float>(portable_exp(-before / static_cast<double>(disc))));
		before += static_cast<double>(own.area);
	}
	return mean_of(areas, shares);
}

/// Parts close to their axis hide each other, also those of other groups there: a rod is no wider than the parts reach.
/// It tapers as their area does.
void shape_rod(FormBody &body, const Measure &m, float others, float all) {
	const float length = std::max(m.high - m.low, MIN_RADIUS);
	const float envelope = 2.0f * std::max(m.reach, MIN_RADIUS) * length;
	body.shown = covered((m.shown + others) / all, envelope) * all;
	const float mean = static_cast<float>(m.moment / std::max(static_cast<double>(m.area), 1e-12));
	const float taper = std::clamp(6.0f * ((mean - m.low) / length - 0.5f), -MAX_TAPER, MAX_TAPER);
	const float radius = 0.5f * body.shown / length;
	body.rings = { { m.low, radius * (1.0f - taper) }, { m.high, radius * (1.0f + taper) } };
}

void color_rings(FormBody &body, const Measure &m) {
	const bool is_divided = body.shown > 0.0f && body.rings.size() > 2 && is_broad(m);
	const float radius = is_divided ? body.rings[1].radius : 0.0f;
	const glm::vec4 upper = is_divided ? color_from_tip(m, static_cast<float>(PI) * radius * radius)
									   : color_below(m, std::numeric_limits<float>::max());
	for (FormBody::Ring &ring : body.rings) {
		ring.color = upper;
	}
	if (is_divided) {
		body.rings.front().color = color_below(m, body.rings[1].along);
	}
}

/// Mean width of a circle from the side, relative to that of the polygon in it.
float polygon_fill(int sides) {
	const double half_turn = PI / sides;
	return static_cast<float>(half_turn / portable_sin(half_turn));
}

/// `others`: area of parts that are not drawn (m²). `all`: parts of the group, relative to those in bodies.
void shape(FormBody &body, const PlantForm &form, const Measure &m, float others, float all) {
	const PartGroup &group = form.groups[static_cast<size_t>(body.group)];
	if (group.layout == Layout::disc) {
		shape_dome(body, m, group.dome);
	} else if (group.layout == Layout::whorl) {
		shape_lathe(body, m);
	} else if (body.detail.is_rod) {
		shape_rod(body, m, others, all);
	} else {
		shape_spindle(body, m);
	}
	for (FormBody::Ring &ring : body.rings) {
		ring.radius *= polygon_fill(body.detail.sides);
	}
	color_rings(body, m);
	body.translucency = m.shine / std::max(m.area, 1e-12f);
}

/// Lengthens a spindle towards the base of its carrier, so that it is not a plate. Such a spindle also replaces bodies
/// on other carriers, with tips at other heights.
void stretch_down(FormBody &body, const PlantForm &form, float longer) {
	const PlacedPart &part = form.placed[static_cast<size_t>(body.first)];
	const float high = body.rings.back().along;
	const float low = body.rings.front().along;
	const float lowest = std::min(low, -part.offset * form.placed[static_cast<size_t>(part.carrier)].length);
	const float factor = std::clamp((high - lowest) / std::max(high - low, MIN_RADIUS), 1.0f, longer);
	for (FormBody::Ring &ring : body.rings) {
		ring.along = high - (high - ring.along) * factor;
		ring.radius /= factor;
	}
}

/// Sets its axes: those of its carrier, at the mean position of the parts there.
FormBody begin_body(const PlantForm &form, const FormPlan &plan, size_t first) {
	const PlacedPart &part = form.placed[first];
	FormBody body;
	body.group = part.group;
	body.first = static_cast<int>(first);
	body.detail = plan.groups[static_cast<size_t>(part.group)].body;
	body.origin = part.base;
	body.axes = { { 1.0f, 0.0f, 0.0f }, { 0.0f, 1.0f, 0.0f }, { 0.0f, 0.0f, 1.0f } };
	if (part.carrier != ON_GROUND) {
		const PlacedPart &carrier = form.placed[static_cast<size_t>(part.carrier)];
		body.axes = form.axes_of(carrier, part.offset);
		body.origin = form.point_of(carrier, part.offset);
	}
	return body;
}

} // namespace

std::vector<FormBody> make_bodies(const PlantForm &form, const FormMeasure &measure, const FormPlan &plan) {
	std::vector<FormBody> bodies;
	std::vector<Measure> measures(static_cast<size_t>(plan.body_count));
	std::vector<int> counts(form.groups.size(), 0);
	for (size_t i = 0; i < form.placed.size() && plan.body_count > 0; i++) {
		if (plan.bodies[i] < 0) {
			continue;
		}
		const size_t number = static_cast<size_t>(plan.bodies[i]);
		if (number == bodies.size()) {
			bodies.push_back(begin_body(form, plan, i));
			counts[static_cast<size_t>(bodies.back().group)]++;
		}
		add(measures[number], bodies[number], form, measure, form.placed[i]);
	}
	std::vector<int> parts(form.groups.size(), 0); // Parts in bodies.
	for (size_t i = 0; i < bodies.size(); i++) {
		parts[static_cast<size_t>(bodies[i].group)] += measures[i].count;
	}
	for (size_t i = 0; i < bodies.size(); i++) {
		FormBody &body = bodies[i];
		// If carriers are dropped, the remaining bodies of the group also show their parts.
		const size_t group = static_cast<size_t>(body.group);
		const float own = measure.shown[group] * static_cast<float>(measures[i].count) /
				static_cast<float>(form.groups[group].count);
		const float more = own > 0.0f ? plan.shown[group] / static_cast<float>(counts[group]) / own : 1.0f;
		const float others = std::max(own * (more - 1.0f), 0.0f);
		const float all = static_cast<float>(form.groups[group].count) / static_cast<float>(parts[group]);
		shape(body, form, measures[i], others, all);
		if (body.shown > 0.0f) {
			stretch_down(body, form, all > FEW ? std::min(std::sqrt(all), MAX_LENGTHENING) : 1.0f);
		}
		const float length = body.rings.back().along - body.rings.front().along;
		if (body.shown > 0.0f) {
			const bool is_rod = body.detail.is_rod; // It has the area of the others already.
			const float least = is_rod ? body.shown / all : body.shown;
			const float with_others = is_rod ? body.shown : body.shown + others;
			body.shown = std::min(with_others, std::max(MAX_STOUTNESS * length * length, least));
		}
		const Layout layout = form.groups[group].layout;
		const bool is_spindle = layout == Layout::along || layout == Layout::ground; // As long as its carrier.
		for (FormBody::Ring &ring : body.rings) {
			ring.radius *= std::sqrt(std::min(more, MAX_ENLARGEMENT));
			ring.along *= is_spindle ? 1.0f : std::sqrt(std::min(more, MAX_ENLARGEMENT));
		}
	}
	return bodies;
}

} // namespace undergrowth
