// Queries and changes of CpuMotion's plants, and the exchange of blocks.

#include "field/cpu_motion.hpp"

#include <algorithm>
#include <map>
#include <utility>

using namespace godot;

namespace undergrowth {

void CpuMotion::set_update_interval(int step_count) {
	if (simulation) {
		wait();
		simulation->set_update_interval(step_count);
	}
}

void CpuMotion::fit_contact(bool on) {
	touches = on;
	if (on && simulation) {
		wait();
		touching.fit(*simulation);
	}
}

void CpuMotion::settle() {
	wait();
	is_handed = false;
	simulation->settle();
	write_all();
}

MotionState CpuMotion::read_state_now(const PlantPlace &place) {
	wait();
	const int page = rows_of(place.block).page;
	return simulation->motion(page, row_of(place));
}

glm::vec3 CpuMotion::read_tip_now(const PlantPlace &place) {
	wait();
	const PageRows &own = rows_of(place.block);
	const MotionPage &page = simulation->page(own.page);
	return page.swings() ? page.tip(row_of(place)) : simulation->shown_point(own.page, row_of(place), 1.0f, 1.0f);
}

void CpuMotion::write_state(const PlantPlace &place, const MotionState &state) {
	wait();
	is_handed = false;
	simulation->set_state(rows_of(place.block).page, row_of(place), state.tip, state.second);
}

void CpuMotion::apply_impulse(const PlantPlace &place, const glm::vec3 &impulse) {
	wait();
	is_handed = false;
	simulation->apply_impulse(rows_of(place.block).page, row_of(place), impulse);
}

bool CpuMotion::is_point_in_plants_now(const glm::vec3 &point, float margin) {
	wait();
	return simulation && simulation->is_point_in_plants(point, margin);
}

void CpuMotion::set_height(const PlantPlace &place, float share, const MotionPlant &plant) {
	heights.push_back({ place, share, plant });
}

void CpuMotion::set_hidden(const PlantPlace &place, bool hidden) {
	wait();
	const int page = rows_of(place.block).page;
	if (hidden) {
		textures->hide(page, row_of(place));
	} else {
		textures->show(page, row_of(place));
		stale_pages.push_back(page);
	}
}

// A page is removed with the last of its blocks.
void CpuMotion::drop_rows(const PageRows &own, bool leaves_texels) {
	const auto is_there = [&](const PageRows &other) { return other.page == own.page; };
	if (own.page >= 0 && std::none_of(rows.begin(), rows.end(), is_there)) {
		simulation->remove_page(own.page);
		leaves_texels ? textures->leave_rows(own.page) : textures->take_rows(own.page);
		return;
	}
	for (int i = 0; own.page >= 0 && i < own.count; i++) {
		drop(own.page, own.first + i);
	}
}

// New blocks may have the numbers of dropped ones.
void CpuMotion::exchange_blocks(const ChangeSet &changes, ArrivingBlocks &arriving) {
	std::map<int, PageRows> left;
	for (const int block : changes.dropped) {
		left[block] = std::exchange(rows[size_t(block)], {});
	}
	for (size_t i = 0; i < arriving.prepared.size(); i++) {
		take_in(changes.grown[i].block, static_cast<PreparedCpuBlock &>(*arriving.prepared[i]));
	}
	for (const KeptPlant &kept : arriving.kept) {
		const auto was = left.find(kept.from.block);
		const PageRows from = was == left.end() ? PageRows() : was->second;
		const PageRows &to = rows_of(changes.grown[size_t(kept.to.block)].block);
		if (from.page < 0 || kept.from.slot >= from.count) {
			continue;
		}
		const int row = to.first + kept.to.slot;
		const int row_before = from.first + kept.from.slot;
		const glm::vec3 before = simulation->page(from.page).root(row_before);
		const glm::vec3 now = simulation->page(to.page).root(row);
		if (before.x == now.x && before.z == now.z) {
			simulation->take_motion(to.page, row, *simulation, from.page, row_before);
		}
	}
	for (const ChangeSet::Grown &grown : changes.grown) {
		stale_pages.push_back(rows_of(grown.block).page);
	}
	for (const auto &entry : left) {
		drop_rows(entry.second, arriving.leaves_texels);
	}
	if (simulation->settings().prototypes > 0) {
		textures->write_history(*simulation, false);
	}
}

PoseTexels CpuMotion::reserve(PreparedBlock &prepared) {
	auto &own = static_cast<PreparedCpuBlock &>(prepared);
	wait();
	own.texels = textures->reserve(int(own.plants.size()));
	return own.texels.texels();
}

void CpuMotion::give_up(PreparedBlock &prepared) {
	auto &own = static_cast<PreparedCpuBlock &>(prepared);
	wait();
	textures->release(std::exchange(own.texels, {}));
}

void CpuMotion::make_room(double plants, int blocks) {
	static constexpr double USED_OF_LAST_ROW = 0.5;
	wait();
	textures->make_room(plants / PoseTexture::SIDE + USED_OF_LAST_ROW * double(blocks));
}

// A new block has its own page.
void CpuMotion::take_in(int block, PreparedCpuBlock &prepared) {
	PageRows &own = rows[size_t(block)];
	own.count = prepared.page.size();
	own.page = simulation->add_page(std::move(prepared.page), prepared.plants.data());
	if (prepared.texels.layer >= 0) {
		textures->give_reserved(own.page, std::exchange(prepared.texels, {}));
	} else {
		textures->give_rows(own.page, own.count);
	}
	// Pages that are uploaded together step together.
	simulation->set_page_phase(own.page, textures->layer_of(own.page));
	textures->write_page(*simulation, own.page);
	textures->write_beside(*simulation, own.page);
}

} // namespace undergrowth
