#include "mesh/form_mesh.hpp"

#include "mesh/drawn_attachments.hpp"
#include "mesh/form_match.hpp"
#include "mesh/form_writer.hpp"
#include "mesh/part_detail.hpp"

#include <algorithm>
#include <numeric>

namespace undergrowth {

namespace {

// Largest factors of the width of a flat part, times the number of parts in place of which it is drawn, and at all.
constexpr float MAX_OF_PART = 1.8f;
constexpr float MAX_OF_SHEET = 5.0f;
constexpr int MIN_LIMITED = 60; // Vertices: coarser plants show their mean colour instead of single leaves.
constexpr float MAX_TAKEN = 0.15f; // Of the area of the largest group, which it takes from others.
constexpr float MAX_OF_ROD = 1.1f;
constexpr float MAX_STOUTNESS = 0.65f; // Silhouette of a spindle over its squared length: half of width over length.

/// Shapes that parts of a kind share, created for the first such part. Groups of one kind may have different details.
class Shapes {
public:
	Shapes(const PlantForm &p_form, const FormMeasure &p_measure, const FormPlan &p_plan) :
			form(p_form), measure(p_measure), plan(p_plan), shared(p_form.groups.size()) {}

	const PartTemplate &of(const PlacedPart &placed) {
		const Part &part = form.parts[static_cast<size_t>(placed.kind)];
		const PartDetail &detail = plan.groups[static_cast<size_t>(placed.group)].detail;
		if (placed.own_midrib >= 0) {
			own = make(placed, part, detail);
			return own;
		}
		PartTemplate &shape = shared[static_cast<size_t>(placed.group)];
		if (shape.vertices.empty()) {
			shape = make(placed, part, detail);
		}
		return shape;
	}

private:
	const PlantForm &form;
	const FormMeasure &measure;
	const FormPlan &plan;
	std::vector<PartTemplate> shared;
	PartTemplate own;

	PartTemplate make(const PlacedPart &placed, const Part &part, const PartDetail &detail) const {
		return make_part_template(
				part, form.midrib_of(placed), detail, measure.colors[static_cast<size_t>(placed.kind)]);
	}
};

/// The written parts of one group.
struct WrittenGroup {
	FormWriter::Mark begin, end;
	size_t first_unit;
	float near;
	float shown; ///< m².
	float max; ///< Of its width.
};

/// Widens groups to their areas. Small groups that would become too wide leave the rest of their area to the largest
/// one: a twisted leaf that is drawn flat and lies on the ground has no area from the side, but is a plate from above.
void widen_groups(FormWriter &writer, const std::vector<WrittenGroup> &groups, std::vector<WrittenUnit> &units) {
	std::vector<float> factors;
	size_t largest = 0;
	for (size_t i = 0; i < groups.size(); i++) {
		const WrittenGroup &own = groups[i];
		factors.push_back(writer.needed_width(own.begin, own.end, own.shown, own.near));
		largest = own.shown > groups[largest].shown ? i : largest;
	}
	std::vector<size_t> widest(groups.size());
	std::iota(widest.begin(), widest.end(), size_t(0));
	std::stable_sort(widest.begin(), widest.end(),
			[&](size_t a, size_t b) { return factors[a] * groups[b].max > factors[b] * groups[a].max; });
	float left = 0.0f;
	for (const size_t i : widest) {
		const WrittenGroup &own = groups[i];
		const float rest = factors[i] > own.max ? own.shown * (1.0f - own.max / factors[i]) : 0.0f;
		if (i == largest || rest <= 0.0f || left + rest > MAX_TAKEN * groups[largest].shown) {
			continue;
		}
		left += rest;
		factors[i] = own.max;
		const size_t end = i + 1 < groups.size() ? groups[i + 1].first_unit : units.size();
		for (size_t unit = own.first_unit; unit < end; unit++) {
			units[unit].max = 1.0f;
		}
	}
	for (size_t i = 0; i < groups.size(); i++) {
		const float more = i == largest && left > 0.0f ? left / groups[i].shown : 0.0f;
		writer.widen(groups[i].begin, groups[i].end, factors[i] * (1.0f + more));
	}
}

} // namespace

void build_form_mesh(const PlantForm &form, const FormMeasure &measure, const FormPlan &plan, const FormBones &bones,
		const MeshOptions &options, float height, const FormBuffers &buffers) {
	const DrawnAttachments attachments(form, plan, measure.attachments);
	FormWriter writer(form, bones, options, buffers);
	Shapes shapes(form, measure, plan);
	std::vector<WrittenUnit> units;
	const auto begin_unit = [&](float near, bool is_flower) {
		units.push_back({ writer.mark().vertex, writer.mark().index, near, is_flower, 1e9f });
	};
	std::vector<WrittenGroup> written;
	for (size_t g = 0; g < form.groups.size(); g++) {
		const PartGroup &group = form.groups[g];
		const Part &part = form.parts[static_cast<size_t>(group.kind)];
		const PartDetail &detail = plan.groups[g].detail;
		const float near = detail.columns == 2 ? 1.0f : near_share(part.kind);
		const FormWriter::Mark begin = writer.mark();
		const size_t first_unit = units.size();
		for (int i = group.first; i < group.first + group.count; i++) {
			const size_t place = static_cast<size_t>(i);
			if (plan.fates[place] == FormPlan::drawn) {
				begin_unit(near, group.layout == Layout::whorl);
				PlacedPart placed = form.placed[place];
				placed.base += attachments.shift_of(place);
				writer.add_part(placed, attachments.attachment_of(place), shapes.of(placed));
			}
		}
		const int drawn = static_cast<int>(units.size() - first_unit);
		if (drawn > 0) {
			const bool is_limited = part.kind == PartKind::blade && plan.counts.vertices >= MIN_LIMITED;
			const float thinned = static_cast<float>(group.count) / static_cast<float>(drawn);
			const float max = is_limited ? std::min(MAX_OF_PART * thinned, MAX_OF_SHEET) : FormWriter::MAX_WIDENING;
			written.push_back({ begin, writer.mark(), first_unit, near, plan.shown[g], max });
		}
	}
	widen_groups(writer, written, units);
	for (FormBody &body : make_bodies(form, measure, plan)) {
		attachments.place_rings(body);
		const FormWriter::Mark begin = writer.mark();
		const PartGroup &group = form.groups[static_cast<size_t>(body.group)];
		const bool is_rod = body.detail.is_rod;
		begin_unit(0.5f, is_rod || group.layout == Layout::whorl || group.layout == Layout::disc);
		writer.add_body(body);
		if (body.shown > 0.0f) {
			const FormWriter::Mark end = writer.mark();
			writer.widen(begin, end, writer.needed_width(begin, end, body.shown, 0.5f));
			const float length = body.rings.back().along - body.rings.front().along;
			units.back().max = is_rod ? MAX_OF_ROD : std::max(MAX_STOUTNESS * length * length / body.shown, 1.0f);
		}
	}
	if (plan.is_cut) {
		begin_unit(0.0f, false);
		match_form(measure, units, buffers);
	}
	writer.stretch(height / form.height);
}

} // namespace undergrowth
