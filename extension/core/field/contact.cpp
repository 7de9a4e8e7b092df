#include "field/contact.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr float LEAST_CELL = 1e-3f; // m.
constexpr float LEAST_HEIGHT = 0.02f; // Of a direction's y: where the ground stops it.
constexpr float MOST_CELLS = 1e9f;
constexpr int MOST_CONTACTS = 255;

glm::vec3 rest_tip(const FieldPage &page, int index) {
	return page.root(index) + page.length(index) * page.rest(index);
}

} // namespace

void TipContact::fit(const FieldSimulation &field) {
	page_firsts.clear();
	float radius = 0.5f * LEAST_CELL;
	uint32_t total = 0;
	for (int page = 0; page < field.page_count(); page++) {
		page_firsts.push_back(total);
		if (field.page(page).swings()) {
			total += static_cast<uint32_t>(field.page(page).size());
			radius = std::max(radius, field.page(page).collision_radius());
		}
	}
	page_firsts.push_back(total);
	cell_size = 2.0f * radius;
	cells_per_metre = 0.999f / cell_size; // Cells are a little larger than they need to be, whatever rounding does.
	std::size_t buckets = 16;
	while (buckets < total) {
		buckets *= 2;
	}
	tips.resize(total);
	velocities.resize(total);
	pages.resize(total);
	touching.assign(total, 0);
	sorted.resize(total);
	bucket_ends.resize(buckets + 1);
	for (int page = 0; page < field.page_count(); page++) {
		std::fill(pages.begin() + page_firsts[static_cast<std::size_t>(page)],
				pages.begin() + page_firsts[static_cast<std::size_t>(page) + 1], static_cast<uint16_t>(page));
	}
}

void TipContact::gather(const FieldSimulation &field, int begin, int end) {
	for (int number = begin; number < end; number++) {
		const FieldPage &page = field.page(number);
		for (int i = 0; page.swings() && i < page.size(); i++) {
			const std::size_t tip = first(number) + static_cast<std::size_t>(i);
			const TipState state = page.state(i);
			tips[tip] = page.root(i) + page.length(i) * state.direction;
			velocities[tip] = page.length(i) * state.rate;
		}
	}
}

int TipContact::cell(float place) const {
	const float cells = std::clamp(place * cells_per_metre, -MOST_CELLS, MOST_CELLS);
	const int towards_0 = static_cast<int>(cells);
	return cells < static_cast<float>(towards_0) ? towards_0 - 1 : towards_0;
}

/// Neighbours along x stand in neighbouring buckets, so that three cells are one run of `sorted`.
uint32_t TipContact::bucket(int cell_x, int cell_z) const {
	const uint32_t row = static_cast<uint32_t>(cell_z) * 0x9e3779b1u;
	const uint32_t mask = static_cast<uint32_t>(bucket_ends.size()) - 2u;
	return ((row ^ (row >> 15)) + static_cast<uint32_t>(cell_x)) & mask;
}

void TipContact::sort() {
	std::fill(bucket_ends.begin(), bucket_ends.end(), 0u);
	for (const glm::vec3 &tip : tips) {
		bucket_ends[bucket(cell(tip.x), cell(tip.z)) + 1]++;
	}
	for (std::size_t i = 1; i < bucket_ends.size(); i++) {
		bucket_ends[i] += bucket_ends[i - 1];
	}
	// From the last tip down, so that each bucket rises; bucket_ends[i + 1] comes down to where bucket i starts.
	for (std::size_t i = tips.size(); i-- > 0;) {
		sorted[--bucket_ends[bucket(cell(tips[i].x), cell(tips[i].z)) + 1]] = static_cast<uint32_t>(i);
	}
	std::copy(bucket_ends.begin() + 1, bucket_ends.end(), bucket_ends.begin());
	bucket_ends.back() = static_cast<uint32_t>(tips.size());
}

template <class Visit>
void TipContact::for_each_contact(const FieldSimulation &field, uint32_t tip, const Visit &visit) const {
	const FieldPage &own_page = field.page(pages[tip]);
	const int own_index = static_cast<int>(tip - page_firsts[pages[tip]]);
	const glm::vec3 place = tips[tip];
	const int cell_z = cell(place.z);
	const auto visit_run = [&](uint32_t begin, uint32_t end, int row) {
		for (uint32_t i = begin; i < end; i++) {
			const uint32_t other = sorted[i];
			const glm::vec3 offset = place - tips[other];
			const float squared = glm::dot(offset, offset);
			// Rows of cells may share buckets: each tip counts in its own row only.
			if (squared >= cell_size * cell_size || other == tip || cell(tips[other].z) != row) {
				continue;
			}
			const FieldPage &page = field.page(pages[other]);
			const float sum = own_page.collision_radius() + page.collision_radius();
			if (squared >= sum * sum) {
				continue;
			}
			const int index = static_cast<int>(other - page_firsts[pages[other]]);
			const float wanted = std::min(sum, glm::distance(rest_tip(own_page, own_index), rest_tip(page, index)));
			const float distance = std::sqrt(squared);
			if (distance < wanted) {
				visit(other, offset, distance, wanted);
			}
		}
	};
	const auto buckets = static_cast<uint32_t>(bucket_ends.size() - 1);
	for (int row = cell_z - 1; row <= cell_z + 1; row++) {
		const uint32_t start = bucket(cell(place.x) - 1, row);
		const uint32_t end = start + 3;
		visit_run(bucket_ends[start], bucket_ends[std::min(end, buckets)], row);
		if (end > buckets) {
			visit_run(bucket_ends[0], bucket_ends[end - buckets], row);
		}
	}
}

void TipContact::count(const FieldSimulation &field, int begin, int end) {
	for (std::size_t tip = first(begin); tip < first(end); tip++) {
		int found = 0;
		for_each_contact(
				field, static_cast<uint32_t>(tip), [&found](uint32_t, const glm::vec3 &, float, float) { found++; });
		touching[tip] = static_cast<uint8_t>(std::min(found, MOST_CONTACTS));
	}
}

void TipContact::separate(FieldSimulation &field, int begin, int end) {
	for (std::size_t tip = first(begin); tip < first(end); tip++) {
		if (touching[tip] == 0) {
			continue;
		}
		FieldPage &page = field.page(pages[tip]);
		const int index = static_cast<int>(tip - first(pages[tip]));
		glm::vec3 move = { 0.0f, 0.0f, 0.0f };
		glm::vec3 blow = { 0.0f, 0.0f, 0.0f };
		for_each_contact(field, static_cast<uint32_t>(tip),
				[&](uint32_t other, const glm::vec3 &offset, float distance, float wanted) {
					const float other_mass = field.page(pages[other]).mass();
					const float share = other_mass / (page.mass() + other_mass) /
							static_cast<float>(std::max(touching[tip], touching[other]));
					// Tips at the same place part along x, the one of the lower number to the right.
					const glm::vec3 normal =
							distance > 0.0f ? offset / distance : glm::vec3(tip < other ? 1.0f : -1.0f, 0.0f, 0.0f);
					move += share * (wanted - distance) * normal;
					const float approach = glm::dot(velocities[tip] - velocities[other], normal);
					blow -= share * std::min(approach, 0.0f) * normal;
				});
		TipState state = page.state(index);
		const glm::vec3 along = move - glm::dot(move, state.direction) * state.direction;
		state.rate += blow / page.length(index);
		state.direction += along / page.length(index);
		state.direction.y = std::max(state.direction.y, LEAST_HEIGHT);
		page.set_state(index, state);
	}
}

void TipContact::resolve(FieldSimulation &field) {
	gather(field, 0, field.page_count());
	sort();
	count(field, 0, field.page_count());
	separate(field, 0, field.page_count());
}

std::size_t TipContact::bytes() const {
	return page_firsts.capacity() * sizeof(uint32_t) + (tips.capacity() + velocities.capacity()) * sizeof(glm::vec3) +
			pages.capacity() * sizeof(uint16_t) + touching.capacity() +
			(bucket_ends.capacity() + sorted.capacity()) * sizeof(uint32_t);
}

} // namespace undergrowth
