// Queries and changes of CpuMotion's plants, and the exchange of chunks.

#include "field/motion/cpu_motion.hpp"

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
	is_transferred = false;
	simulation->settle();
	write_all();
}

MotionState CpuMotion::blocking_read_state(const PlantRef &ref) {
	wait();
	const int page = rows_of(ref.chunk).page;
	return simulation->motion(page, row_of(ref));
}

glm::vec3 CpuMotion::blocking_read_tip(const PlantRef &ref) {
	wait();
	const PageRows &own = rows_of(ref.chunk);
	const MotionPage &page = simulation->page(own.page);
	return page.swings() ? page.tip(row_of(ref)) : simulation->shown_point(own.page, row_of(ref), 1.0f, 1.0f);
}

void CpuMotion::write_state(const PlantRef &ref, const MotionState &state) {
	wait();
	is_transferred = false;
	simulation->set_state(rows_of(ref.chunk).page, row_of(ref), state.tip, state.second);
}

void CpuMotion::apply_impulse(const PlantRef &ref, const glm::vec3 &impulse) {
	wait();
	is_transferred = false;
	simulation->apply_impulse(rows_of(ref.chunk).page, row_of(ref), impulse);
}

bool CpuMotion::blocking_is_point_in_plants(const glm::vec3 &point, float margin) {
	wait();
	return simulation && simulation->is_point_in_plants(point, margin);
}

void CpuMotion::set_height(const PlantRef &ref, float share, const MotionPlant &plant) {
	heights.push_back({ ref, share, plant });
}

void CpuMotion::set_hidden(const PlantRef &ref, bool hidden) {
	wait();
	const int page = rows_of(ref.chunk).page;
	if (hidden) {
		textures->hide(page, row_of(ref));
	} else {
		textures->show(page, row_of(ref));
		dirty_pages.push_back(page);
	}
}

// A page is removed with the last of its chunks.
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

// New chunks may have the numbers of dropped ones.
void CpuMotion::exchange_chunks(const ChangeSet &changes, ArrivingChunks &arriving) {
	std::map<int, PageRows> left;
	for (const int chunk : changes.dropped) {
		left[chunk] = std::exchange(rows[size_t(chunk)], {});
	}
	for (size_t i = 0; i < arriving.prepared.size(); i++) {
		take_in(changes.grown[i].chunk, static_cast<PreparedCpuChunk &>(*arriving.prepared[i]));
	}
	for (const PlantMatch &match : arriving.matches) {
		const auto was = left.find(match.from.chunk);
		const PageRows from = was == left.end() ? PageRows() : was->second;
		const PageRows &to = rows_of(changes.grown[size_t(match.to.chunk)].chunk);
		if (from.page < 0 || match.from.slot >= from.count) {
			continue;
		}
		const int row = to.first + match.to.slot;
		const int row_before = from.first + match.from.slot;
		const glm::vec3 before = simulation->page(from.page).root(row_before);
		const glm::vec3 now = simulation->page(to.page).root(row);
		if (before.x == now.x && before.z == now.z) {
			simulation->transfer_motion(to.page, row, *simulation, from.page, row_before);
		}
	}
	for (const ChangeSet::Grown &grown : changes.grown) {
		dirty_pages.push_back(rows_of(grown.chunk).page);
	}
	for (const auto &entry : left) {
		drop_rows(entry.second, arriving.leaves_texels);
	}
	if (simulation->settings().prototypes > 0) {
		textures->write_history(*simulation, false);
	}
}

PoseTexels CpuMotion::reserve(PreparedChunk &prepared) {
	auto &own = static_cast<PreparedCpuChunk &>(prepared);
	wait();
	own.texels = textures->reserve(int(own.plants.size()));
	return own.texels.texels();
}

void CpuMotion::release_texels(PreparedChunk &prepared) {
	auto &own = static_cast<PreparedCpuChunk &>(prepared);
	wait();
	textures->release(std::exchange(own.texels, {}));
}

void CpuMotion::make_room(double plants, int chunks) {
	static constexpr double USED_OF_LAST_ROW = 0.5;
	wait();
	textures->make_room(plants / PoseTexture::SIDE + USED_OF_LAST_ROW * double(chunks));
}

// A new chunk has its own page.
void CpuMotion::take_in(int chunk, PreparedCpuChunk &prepared) {
	PageRows &own = rows[size_t(chunk)];
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
