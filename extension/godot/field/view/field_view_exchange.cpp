// Exchange of the multimeshes of FieldView: prepared over some frames, exchanged in one, freed over some more.

#include "base/stopwatch.hpp"
#include "field/view/field_view.hpp"

#include <godot_cpp/classes/rendering_server.hpp>

#include <iterator>
#include <utility>

using namespace godot;

namespace undergrowth {

void FieldView::free_batch(const Batch &batch) {
	RenderingServer *server = RenderingServer::get_singleton();
	if (batch.near) {
		return;
	}
	if (batch.shadow.is_valid()) {
		server->free_rid(batch.shadow);
	}
	server->free_rid(batch.instance);
	server->free_rid(batch.multimesh);
}

void FieldView::move_all(Batches &from, std::vector<Batch> &into) {
	for (auto &[place, group] : from) {
		into.insert(into.end(), std::make_move_iterator(group.begin()), std::make_move_iterator(group.end()));
	}
	from.clear();
}

void FieldView::prepare(const FieldRenderSetup &setup, const BatchPlan &plan) {
	prepared_levels = levels_of(setup);
	prepared[plan.place].push_back(make(setup, plan));
	next_revealed.reset();
}

void FieldView::forget_prepared() {
	move_all(prepared, leaving);
	next_revealed.reset();
}

void FieldView::reveal(Batch &batch) {
	batch.is_revealed = has_unflushed = true;
	set_visible(batch, is_visible);
}

// The renderer processes everything new before it frees an instance.
void FieldView::flush_if_undrawn() {
	if (std::exchange(has_unflushed, false)) {
		RenderingServer *server = RenderingServer::get_singleton();
		server->free_rid(server->instance_create());
	}
}

bool FieldView::reveal_some(double usec) {
	const Stopwatch watch;
	auto entry = next_revealed ? prepared.lower_bound(*next_revealed) : prepared.begin();
	for (; entry != prepared.end(); ++entry) {
		next_revealed = entry->first;
		for (Batch &batch : entry->second) {
			if (batch.is_revealed) {
				continue;
			}
			reveal(batch);
			if (watch.usec() > usec) {
				return true;
			}
		}
	}
	return false;
}

// Calls act(place, group) for all groups of a square, whole or in parts, and removes them.
template <class Act> void FieldView::take_parts(Batches &from, const BatchKey &place, const Act &act) {
	auto group = from.lower_bound(place);
	while (group != from.end() && group->first.is_beside(place)) {
		act(group->first, group->second);
		group = from.erase(group);
	}
}

bool FieldView::has_near(const std::vector<Batch> &group) {
	return std::any_of(group.begin(), group.end(), [](const Batch &batch) { return batch.near != nullptr; });
}

void FieldView::clear(const BatchKey &place) {
	take_parts(batches, place, [this](const BatchKey &, std::vector<Batch> &group) {
		has_other_near = has_other_near || has_near(group);
		std::for_each(group.begin(), group.end(), &FieldView::free_batch);
	});
}

void FieldView::drop_tile(const TileKey &tile) {
	for (int level = 0; level < level_count(); level++) {
		take_parts(batches, { false, level, 1, tile }, [this](const BatchKey &, std::vector<Batch> &group) {
			has_other_near = has_other_near || has_near(group);
			for (const Batch &batch : group) {
				set_visible(batch, false);
				gone.push_back(batch);
			}
		});
	}
}

void FieldView::show_tile(const FieldRenderSetup &setup, const TileKey &tile) {
	RenderingServer *server = RenderingServer::get_singleton();
	is_culled = false;
	for (int level = 0; level < int(setup.levels.size()); level++) {
		take_parts(prepared, { false, level, 1, tile }, [&](const BatchKey &place, std::vector<Batch> &group) {
			for (Batch &batch : group) {
				if (batch.near) {
					has_other_near = true;
				} else {
					const FieldLevel &seen = setup.styles[size_t(batch.species)].levels[size_t(level)];
					set_material(server, setup, place, batch);
					set_range(batch, seen);
					apply_flags(batch, seen);
				}
				reveal(batch);
				batches[place].push_back(std::move(batch));
			}
		});
	}
}

void FieldView::forget_tile(const TileKey &tile) {
	for (int level = 0; level < (prepared_levels.empty() ? 0 : int(prepared_levels.front().size())); level++) {
		take_parts(prepared, { false, level, 1, tile }, [this](const BatchKey &, std::vector<Batch> &group) {
			std::move(group.begin(), group.end(), std::back_inserter(gone));
		});
	}
}

void FieldView::exchange(const FieldRenderSetup &setup) {
	move_all(batches, leaving);
	new_chunks.clear();
	batches = std::exchange(prepared, {});
	next_revealed.reset();
	levels = levels_of(setup);
	near.bind(setup);
	has_other_near = true;
	is_culled = false;
}

bool FieldView::free_some(double usec, bool hides_all) {
	const Stopwatch watch;
	while (!leaving.empty() && (hides_all || watch.usec() < usec)) {
		set_visible(leaving.back(), false);
		gone.push_back(std::move(leaving.back()));
		leaving.pop_back();
	}
	while (!gone.empty() && watch.usec() < usec) {
		free_batch(gone.back());
		gone.pop_back();
	}
	return !gone.empty() || !leaving.empty();
}

} // namespace undergrowth
