#pragma once

#include "queued_call.hpp"

#include <godot_cpp/classes/node.hpp>

#include <utility>

namespace undergrowth {

/// The dirty flags of a field. Many properties may change in one frame: the node's _on_fill_queued() is called once,
/// after the frame, and takes all flags.
class FieldStaleness {
public:
	struct Parts {
		bool stand = false; ///< Plants need a rebuild.
		bool look = false; ///< Materials and meshes need a rebuild.
		bool area = false; ///< Paths of the outline or the exclusions have changed.

		bool any() const { return stand || look || area; }
	};

	/// A new field has all flags of plants and materials set.
	explicit FieldStaleness(godot::Node *of) : node(of), filling(of, "_on_fill_queued") {}

	/// Outside of a tree, flags stay set until the node enters one.
	void mark_stand() { mark(parts.stand); }
	void mark_look() { mark(parts.look); }
	void mark_area() { mark(parts.area); }
	/// Call when the node has entered a tree.
	void enter_tree() { queue_if_any(); }
	/// Returns and clears all flags; none outside of a tree.
	Parts take() {
		filling.begin();
		return node->is_inside_tree() ? std::exchange(parts, {}) : Parts();
	}

	bool is_stand_stale() const { return parts.stand; }
	/// True if the plants match the properties. If false, a rebuild starts soon.
	bool is_fresh() const { return node->is_inside_tree() && !parts.stand && !parts.area; }
	/// True if a rebuild of plants, or of materials, starts after this frame.
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
