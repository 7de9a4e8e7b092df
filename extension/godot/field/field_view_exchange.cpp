// How FieldView shows other plants than before: made ready over some frames, exchanged in one, freed over some more.

#include "field/field_view.hpp"
#include "stopwatch.hpp"

#include <godot_cpp/classes/rendering_server.hpp>

#include <iterator>
#include <utility>

using namespace godot;

namespace undergrowth {

void FieldView::let_go(const Clump &clump) {
	RenderingServer *server = RenderingServer::get_singleton();
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
	prepared_levels = style.levels;
	prepared[plan.place].push_back(make(style, plan));
}

void FieldView::forget_prepared() {
	move_all(prepared, gone);
}

void FieldView::exchange(const FieldStyle &style) {
	const bool was_visible = is_visible;
	set_visible(false);
	move_all(clumps, gone);
	newcomers.clear();
	clumps = std::exchange(prepared, {});
	levels = style.levels;
	is_thinned = false;
	set_visible(was_visible);
}

bool FieldView::free_some(double usec) {
	const Stopwatch watch;
	while (!gone.empty() && watch.usec() < usec) {
		let_go(gone.back());
		gone.pop_back();
	}
	return !gone.empty();
}

} // namespace undergrowth
