#include "field/contact.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float MIN_CELL = 1e-3f; // m.
constexpr float MAX_CELLS = 1e9f;
static_assert(TipContact::MAX_CONTACTS <= 255, "the number of a tip's contacts is a byte");

/// A field's plants have the axes of the field.
PageFrame frame_of(const FieldSimulation & /*field*/, int /*page*/) {
	return {};
}

const PageFrame &frame_of(const PageRefs &pages, int page) {
	return pages.frame(page);
}

template <class Pages> glm::vec3 rest_tip(const Pages &field, int number, int index) {
	const MotionPage &page = field.page(number);
	return page.root(index) + page.length(index) * frame_of(field, number).outward(page.rest(index));
}

} // namespace

template <class Pages> void TipContact::fit(const Pages &field) {
	page_firsts.clear();
	uint32_t total = 0;
	for (int page = 0; page < field.page_count(); page++) {
		page_firsts.push_back(total);
		if (field.page(page).swings()) {
			total += static_cast<uint32_t>(field.page(page).size());
		}
	}
	page_firsts.push_back(total);
	follow_radii(field);
	std::size_t bucket_count = 16;
	while (bucket_count < total) {
		bucket_count *= 2;
	}
	vectors.resize(total);
	buckets.resize(total);
	pages.resize(total);
	touching.assign(total, 0);
	sorted.resize(total);
	bucket_ends.resize(bucket_count + 1);
	for (int page = 0; page < field.page_count(); page++) {
		std::fill(pages.begin() + page_firsts[static_cast<std::size_t>(page)],
				pages.begin() + page_firsts[static_cast<std::size_t>(page) + 1], static_cast<uint32_t>(page));
	}
}

template <class Pages> void TipContact::follow_radii(const Pages &field) {
	float radius = 0.5f * MIN_CELL;
	for (int page = 0; page < field.page_count(); page++) {
		radius = field.page(page).swings() ? std::max(radius, field.page(page).collision_radius()) : radius;
	}
	cell_size = 2.0f * radius;
	cells_per_metre = 0.999f / cell_size; // Cells are slightly larger than necessary, for any rounding.
}

template <class Pages> void TipContact::gather(const Pages &field, int begin, int end) {
	for (int number = begin; number < end; number++) {
		const MotionPage &page = field.page(number);
		std::fill(touching.begin() + page_begin(number), touching.begin() + page_begin(number + 1),
				static_cast<uint8_t>(0));
		const PageFrame frame = frame_of(field, number);
		for (int i = 0; page.swings() && i < page.size(); i++) {
			const std::size_t tip = first(number) + static_cast<std::size_t>(i);
			vectors[tip] = page.root(i) + frame.outward(page.arm(i, 1.0f));
			buckets[tip] = bucket(cell(vectors[tip].x), cell(vectors[tip].z));
		}
	}
}

int TipContact::cell(float place) const {
	const float cells = std::clamp(place * cells_per_metre, -MAX_CELLS, MAX_CELLS);
	const int towards_0 = static_cast<int>(cells);
	return towards_0 - static_cast<int>(cells < static_cast<float>(towards_0)); // A branch here would be unpredictable.
}

/// Neighbours along x have neighbouring buckets, so three cells are one run of `sorted`.
uint32_t TipContact::bucket(int cell_x, int cell_z) const {
	const uint32_t row = static_cast<uint32_t>(cell_z) * 0x9e3779b1u;
	const uint32_t mask = static_cast<uint32_t>(bucket_ends.size()) - 2u;
	return ((row ^ (row >> 15)) + static_cast<uint32_t>(cell_x)) & mask;
}

void TipContact::sort() {
	std::fill(bucket_ends.begin(), bucket_ends.end(), 0u);
	for (const uint32_t one : buckets) {
		bucket_ends[one + 1]++;
	}
	max_in_bucket = 0;
	for (std::size_t i = 1; i < bucket_ends.size(); i++) {
		max_in_bucket = std::max(max_in_bucket, bucket_ends[i]);
		bucket_ends[i] += bucket_ends[i - 1];
	}
	// From the last tip down, so each bucket is in ascending order. bucket_ends[i + 1] moves down to the start of
	// bucket i.
	for (std::size_t i = buckets.size(); i-- > 0;) {
		sorted[--bucket_ends[buckets[i] + 1]] = { vectors[i], static_cast<uint32_t>(i) };
	}
	std::copy(bucket_ends.begin() + 1, bucket_ends.end(), bucket_ends.begin());
	bucket_ends.back() = static_cast<uint32_t>(sorted.size());
}

template <class Pages, class Visit>
void TipContact::for_each_contact(const Pages &field, const SortedTip &own, Visit &&visit) const {
	const auto visit_run = [&](uint32_t begin, uint32_t end, int row) {
		for (uint32_t i = begin; i < end; i++) {
			const SortedTip &other = sorted[i];
			const glm::vec3 offset = own.place - other.place;
			const float squared = glm::dot(offset, offset);
			// Rows of cells can share buckets: each tip counts in its own row only.
			if (squared >= cell_size * cell_size || other.tip == own.tip || cell(other.place.z) != row) {
				continue;
			}
			const MotionPage &own_page = field.page(page_of(own.tip));
			const MotionPage &page = field.page(page_of(other.tip));
			const float sum = own_page.collision_radius() + page.collision_radius();
			if (squared >= sum * sum || own_page.is_gone(index_of(own.tip)) || page.is_gone(index_of(other.tip))) {
				continue;
			}
			const float at_rest = glm::distance(rest_tip(field, page_of(own.tip), index_of(own.tip)),
					rest_tip(field, page_of(other.tip), index_of(other.tip)));
			const float wanted = std::min(sum, at_rest);
			const float distance = std::sqrt(squared);
			if (distance < wanted) {
				visit(other.tip, offset, distance, wanted);
			}
		}
	};
	for_each_run(own, visit_run);
}

/// Two tips are compared if their positions in their buckets differ by at most NEIGHBOURS. If the buckets are so small
/// that all tips are compared, the three buckets of a row are one run.
template <class Visit> void TipContact::for_each_run(const SortedTip &own, Visit &&visit) const {
	const auto bucket_count = static_cast<uint32_t>(bucket_ends.size() - 1);
	const int cell_x = cell(own.place.x);
	const int cell_z = cell(own.place.z);
	if (leaves_out()) {
		const auto place = static_cast<uint32_t>(&own - sorted.data());
		const uint32_t rank = place - bucket_ends[bucket(cell_x, cell_z)];
		for (int row = cell_z - 1; row <= cell_z + 1; row++) {
			for_each_run_near(rank, bucket(cell_x - 1, row), row, visit);
		}
		return;
	}
	for (int row = cell_z - 1; row <= cell_z + 1; row++) {
		const uint32_t start = bucket(cell_x - 1, row);
		const uint32_t end = start + 3;
		visit(bucket_ends[start], bucket_ends[std::min(end, bucket_count)], row);
		if (end > bucket_count) {
			visit(bucket_ends[0], bucket_ends[end - bucket_count], row);
		}
	}
}

template <class Visit> void TipContact::for_each_run_near(uint32_t rank, uint32_t start, int row, Visit &&visit) const {
	constexpr auto NEAR = static_cast<uint32_t>(NEIGHBOURS);
	const auto mask = static_cast<uint32_t>(bucket_ends.size()) - 2u;
	for (uint32_t one = start; one != start + 3; one++) {
		const uint32_t first = bucket_ends[one & mask];
		const uint32_t end = bucket_ends[(one & mask) + 1];
		visit(std::min(first + (rank > NEAR ? rank - NEAR : 0u), end), std::min(first + rank + NEAR + 1u, end), row);
	}
}

std::size_t TipContact::candidate_count() const {
	std::size_t found = 0;
	for (const SortedTip &own : sorted) {
		for_each_run(own, [&found](uint32_t begin, uint32_t end, int) { found += end - begin; });
	}
	return found - sorted.size(); // Each tip also finds itself.
}

template <class Pages> void TipContact::count(const Pages &field, int begin, int end) {
	for (std::size_t i = first(begin); i < first(end); i++) {
		const SortedTip &own = sorted[i];
		int found = 0;
		for_each_contact(field, own, [&found](uint32_t, const glm::vec3 &, float, float) { found++; });
		if (found > 0) {
			touching[own.tip] = static_cast<uint8_t>(found);
			const MotionPage &page = field.page(page_of(own.tip));
			vectors[own.tip] = frame_of(field, page_of(own.tip)).outward(page.tip_velocity(index_of(own.tip)));
		}
	}
}

template <class Pages> void TipContact::separate(Pages &field, int begin, int end) {
	for (std::size_t i = first(begin); i < first(end); i++) {
		if (touching[sorted[i].tip] > 0) {
			separate_one(field, sorted[i]);
		}
	}
}

template <class Pages> void TipContact::separate_one(Pages &field, const SortedTip &own) {
	const uint32_t tip = own.tip;
	MotionPage &page = field.page(page_of(tip));
	glm::vec3 move = { 0.0f, 0.0f, 0.0f };
	glm::vec3 faster = { 0.0f, 0.0f, 0.0f };
	for_each_contact(field, own, [&](uint32_t other, const glm::vec3 &offset, float distance, float wanted) {
		const float other_mass = field.page(page_of(other)).mass();
		const float share =
				other_mass / (page.mass() + other_mass) / static_cast<float>(std::max(touching[tip], touching[other]));
		// Tips at the same position separate along x, the one of the lower number to the right.
		const glm::vec3 normal =
				distance > 0.0f ? offset / distance : glm::vec3(tip < other ? 1.0f : -1.0f, 0.0f, 0.0f);
		move += share * (wanted - distance) * normal;
		const float approach = glm::dot(vectors[tip] - vectors[other], normal);
		faster -= share * std::min(approach, 0.0f) * normal;
	});
	const int index = index_of(tip);
	const PageFrame &frame = frame_of(field, page_of(tip));
	move = frame.inward(move);
	if (page.law() == Law::stem) {
		page.move_tip(index, move, frame.inward(faster));
		return;
	}
	TipState state = page.state(index);
	const glm::vec3 along = move - glm::dot(move, state.direction) * state.direction;
	state.rate += frame.inward(faster) / page.length(index);
	state.direction += along / page.length(index);
	state.direction.y = std::max(state.direction.y, MIN_PUSHED_HEIGHT);
	page.set_state(index, state);
}

template <class Pages> void TipContact::resolve(Pages &field) {
	follow_radii(field);
	gather(field, 0, field.page_count());
	sort();
	count(field, 0, field.page_count());
	separate(field, 0, field.page_count());
}

std::size_t TipContact::bytes() const {
	return (page_firsts.capacity() + pages.capacity()) * sizeof(uint32_t) + vectors.capacity() * sizeof(glm::vec3) +
			touching.capacity() + (bucket_ends.capacity() + buckets.capacity()) * sizeof(uint32_t) +
			sorted.capacity() * sizeof(SortedTip);
}

#define FOR_PAGES(Pages)                                                                                               \
	template void TipContact::fit(const Pages &field);                                                                 \
	template void TipContact::follow_radii(const Pages &field);                                                        \
	template void TipContact::gather(const Pages &field, int begin, int end);                                          \
	template void TipContact::count(const Pages &field, int begin, int end);                                           \
	template void TipContact::separate(Pages &field, int begin, int end);                                              \
	template void TipContact::resolve(Pages &field);

FOR_PAGES(FieldSimulation)
FOR_PAGES(PageRefs)

#undef FOR_PAGES

} // namespace undergrowth
