// Exchange of the multimeshes of FieldView: prepared over some frames, exchanged in one, freed over some more.

#include "field/field_view.hpp"
#include "stopwatch.hpp"

#include <godot_cpp/classes/rendering_server.hpp>

#include <iterator>
#include <utility>

using namespace godot;

namespace undergrowth {

void FieldView::let_go(const Clump &clump) {
	RenderingServer *server = RenderingServer::get_singleton();
	if (clump.near) {
		return;
	}
	if (clump.shadow.is_valid()) {
		server->free_rid(clump.shadow);
	}
	server->free_rid(clump.instance);
	server->free_rid(clump.multimesh);
}

void FieldView::move_all(Clumps &from, std::vector<Clump> &into) {
	for (auto &[place, group] : from) {
		into.insert(into.end(), std::make_move_iterator(group.begin()), std::make_move_iterator(group.end()));
	}
	from.clear();
}

void FieldView::prepare(const FieldStyle &style, const ClumpPlan &plan) {
	prepared_levels = levels_of(style);
	prepared[plan.place].push_back(make(style, plan));
	next_revealed.reset();
}

void FieldView::forget_prepared() {
	move_all(prepared, leaving);
	next_revealed.reset();
}

void FieldView::reveal(Clump &clump) {
	clump.is_revealed = has_untold = true;
	set_visible(clump, is_visible);
}

// The renderer processes everything new before it frees an instance.
void FieldView::tell_if_undrawn() {
	if (std::exchange(has_untold, false)) {
		RenderingServer *server = RenderingServer::get_singleton();
		server->free_rid(server->instance_create());
	}
}

bool FieldView::reveal_some(double usec) {
	const Stopwatch watch;
	auto entry = next_revealed ? prepared.lower_bound(*next_revealed) : prepared.begin();
	for (; entry != prepared.end(); ++entry) {
		next_revealed = entry->first;
		for (Clump &clump : entry->second) {
			if (clump.is_revealed) {
				continue;
			}
			reveal(clump);
			if (watch.usec() > usec) {
				return true;
			}
		}
	}
	return false;
}

// Calls act(place, group) for all groups of a square, whole or in parts, and removes them.
template <class Act> void FieldView::take_parts(Clumps &from, const ClumpPlace &place, const Act &act) {
	auto group = from.lower_bound(place);
	while (group != from.end() && group->first.is_beside(place)) {
		act(group->first, group->second);
		group = from.erase(group);
	}
}

bool FieldView::has_near(const std::vector<Clump> &group) {
	return std::any_of(group.begin(), group.end(), [](const Clump &clump) { return clump.near != nullptr; });
}

void FieldView::clear(const ClumpPlace &place) {
	take_parts(clumps, place, [this](const ClumpPlace &, std::vector<Clump> &group) {
		has_other_near = has_other_near || has_near(group);
		std::for_each(group.begin(), group.end(), &FieldView::let_go);
	});
}

void FieldView::drop_tile(const TileKey &tile) {
	for (int level = 0; level < level_count(); level++) {
		take_parts(clumps, { false, level, 1, tile }, [this](const ClumpPlace &, std::vector<Clump> &group) {
			has_other_near = has_other_near || has_near(group);
			for (const Clump &clump : group) {
				set_visible(clump, false);
				gone.push_back(clump);
			}
		});
	}
}

void FieldView::show_tile(const FieldStyle &style, const TileKey &tile) {
	RenderingServer *server = RenderingServer::get_singleton();
	is_thinned = false;
	for (int level = 0; level < int(style.levels.size()); level++) {
		take_parts(prepared, { false, level, 1, tile }, [&](const ClumpPlace &place, std::vector<Clump> &group) {
			for (Clump &clump : group) {
				if (clump.near) {
					has_other_near = true;
				} else {
					const FieldLevel &seen = style.looks[size_t(clump.species)].levels[size_t(level)];
					wear_material(server, style, place, clump);
					set_range(clump, seen);
					set_wear(clump, seen);
				}
				reveal(clump);
				clumps[place].push_back(std::move(clump));
			}
		});
	}
}

void FieldView::forget_tile(const TileKey &tile) {
	for (int level = 0; level < (prepared_levels.empty() ? 0 : int(prepared_levels.front().size())); level++) {
		take_parts(prepared, { false, level, 1, tile }, [this](const ClumpPlace &, std::vector<Clump> &group) {
			std::move(group.begin(), group.end(), std::back_inserter(gone));
		});
	}
}

void FieldView::exchange(const FieldStyle &style) {
	move_all(clumps, leaving);
	newcomers.clear();
	clumps = std::exchange(prepared, {});
	next_revealed.reset();
	levels = levels_of(style);
	near.wear(style);
	has_other_near = true;
	is_thinned = false;
}

bool FieldView::free_some(double usec, bool hides_all) {
	const Stopwatch watch;
	while (!leaving.empty() && (hides_all || watch.usec() < usec)) {
		set_visible(leaving.back(), false);
		gone.push_back(std::move(leaving.back()));
		leaving.pop_back();
	}
	while (!gone.empty() && watch.usec() < usec) {
		let_go(gone.back());
		gone.pop_back();
	}
	return !gone.empty() || !leaving.empty();
}

} // namespace undergrowth
