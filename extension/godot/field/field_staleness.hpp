#pragma once

#include "queued_call.hpp"

#include <godot_cpp/classes/node.hpp>

#include <utility>

namespace undergrowth {

/// What of a field is not by its properties yet. Many of them may change in one frame: its node's _on_fill_queued() is
/// called once, after it, and takes all of it.
class FieldStaleness {
public:
	struct Parts {
		bool stand = false; ///< It grows anew.
		bool look = false; ///< It is dressed anew.
		bool area = false; ///< Paths that keep places free, or give room, are others.

		bool any() const { return stand || look || area; }
	};

	/// All of a new field is stale.
	explicit FieldStaleness(godot::Node *of) : node(of), filling(of, "_on_fill_queued") {}

	/// Outside of a tree they are taken once the node has entered one.
	void mark_stand() { mark(parts.stand); }
	void mark_look() { mark(parts.look); }
	void mark_area() { mark(parts.area); }
	/// The node has entered it.
	void enter_tree() { queue_if_any(); }
	/// What is to be done now, and is stale no more; nothing outside of a tree.
	Parts take() {
		filling.begin();
		return node->is_inside_tree() ? std::exchange(parts, {}) : Parts();
	}

	bool is_stand_stale() const { return parts.stand; }
	/// Whether the field stands by its properties. Else it grows anew soon.
	bool is_fresh() const { return node->is_inside_tree() && !parts.stand && !parts.area; }
	/// Whether it grows anew, or is dressed anew, after this frame.
	bool grows_soon() const { return (parts.stand || parts.area) && filling.is_queued(); }
	bool is_dressed_soon() const { return parts.look && filling.is_queued(); }

private:
	godot::Node *node;
	Parts parts = { true, true, false };
	QueuedCall filling;

	void mark(bool &part) {
		part = true;
		queue_if_any();
	}
	void queue_if_any() {
		if (parts.any() && node->is_inside_tree()) {
			filling.queue();
		}
	}
};

} // namespace undergrowth
