#pragma once

#include "base/queued_call.hpp"

#include <godot_cpp/classes/node.hpp>

#include <utility>

namespace undergrowth {

/// The dirty flags of a field. Many properties may change in one frame: the node's _on_rebuild_queued() is called once,
/// after the frame, and takes all flags.
class FieldDirtyFlags {
public:
	struct Parts {
		bool placement = false; ///< Plants need a rebuild.
		bool style = false; ///< Materials and meshes need a rebuild.
		bool area = false; ///< Paths of the outline or the exclusions have changed.

		bool any() const { return placement || style || area; }
	};

	/// A new field has all flags of plants and materials set.
	explicit FieldDirtyFlags(godot::Node *of) : node(of), rebuild_call(of, "_on_rebuild_queued") {}

	/// Outside of a tree, flags stay set until the node enters one.
	void mark_placement() { mark(parts.placement); }
	void mark_style() { mark(parts.style); }
	void mark_area() { mark(parts.area); }
	/// Call when the node has entered a tree.
	void enter_tree() { queue_if_any(); }
	/// Returns and clears all flags; none outside of a tree.
	Parts take() {
		rebuild_call.begin();
		return node->is_inside_tree() ? std::exchange(parts, {}) : Parts();
	}

	bool is_placement_dirty() const { return parts.placement; }
	/// True if the plants match the properties. If false, a rebuild starts soon.
	bool is_clean() const { return node->is_inside_tree() && !parts.placement && !parts.area; }
	/// True if a rebuild of plants, or of materials, starts after this frame.
	bool is_rebuild_queued() const { return (parts.placement || parts.area) && rebuild_call.is_queued(); }
	bool is_restyle_queued() const { return parts.style && rebuild_call.is_queued(); }

private:
	godot::Node *node;
	Parts parts = { true, true, false };
	QueuedCall rebuild_call;

	void mark(bool &part) {
		part = true;
		queue_if_any();
	}
	void queue_if_any() {
		if (parts.any() && node->is_inside_tree()) {
			rebuild_call.queue();
		}
	}
};

} // namespace undergrowth
