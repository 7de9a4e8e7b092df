#pragma once

#include <atomic>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/class_db.hpp>

namespace probe {

// Counts its living instances, and passes references along every path between scripts and C++.
class ProbeCounter : public godot::RefCounted {
	GDCLASS(ProbeCounter, godot::RefCounted)

	static inline std::atomic<int> alive{ 0 };
	godot::Ref<godot::RefCounted> held;

protected:
	static void _bind_methods();

public:
	ProbeCounter() { alive++; }
	~ProbeCounter() override { alive--; }

	static int get_alive() { return alive; }
	static godot::Ref<ProbeCounter> make();
	static godot::Array make_many(int p_count);
	static godot::Ref<godot::Resource> make_resource();
	void hold(const godot::Ref<godot::RefCounted> &p_ref) { held = p_ref; }
	godot::Ref<godot::RefCounted> get_held() const { return held; }
	godot::Ref<ProbeCounter> pass(const godot::Ref<ProbeCounter> &p_ref) { return p_ref; }
	godot::Variant pass_variant(const godot::Variant &p_value) { return p_value; }
	int count_of(const godot::Ref<godot::RefCounted> &p_ref) const;
	// Copies, moves, converts, wraps in Variants and arrays; the count must end where it began.
	bool juggle(const godot::Ref<ProbeCounter> &p_ref);
	godot::Ref<ProbeCounter> get_self() { return godot::Ref<ProbeCounter>(this); }
};

} // namespace probe
