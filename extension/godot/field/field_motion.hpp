#pragma once

#include "field/contact.hpp"
#include "field/field_bodies.hpp"
#include "field/field_fill.hpp"
#include "field/field_options.hpp"
#include "field/field_steps.hpp"
#include "motion/fixed_step.hpp"
#include "stand/plant_store.hpp"

#include <memory>
#include <vector>

namespace undergrowth {

/// How the plants of a field move: the simulation, its clock and its wind, what pushes it, and the texture that tells
/// the graphics card of it. It follows the PlantStore by change sets; block numbers are the store's. Worker threads
/// step it between two frames: everything here waits for them, so whatever reads a state says so in its name.
class FieldMotion {
public:
	FieldMotion();
	~FieldMotion();
	FieldMotion(const FieldMotion &) = delete;
	FieldMotion &operator=(const FieldMotion &) = delete;

	/// Until the worker threads are done.
	void wait();
	bool is_ready() const { return simulation != nullptr; }
	/// Whether there is anything to see it by: textures, which stand once something was uploaded.
	bool has_poses() const { return textures && textures->poses().is_valid(); }
	/// Whether the next step asks for Frame::eyes. It does so now and then only.
	bool wants_eyes() const;
	/// An empty field, for plants that code adds.
	void start(const FieldSettings &settings);
	/// Takes over what was grown: block i of `result` is block changes.grown[i] of the store. Plants that stood before
	/// go on with their motion.
	void adopt(FieldResult &result, const ChangeSet &changes, const PlantStore &store, const FieldStyle &style);
	/// Follows an edit that fills nothing.
	void apply(const ChangeSet &changes, const PlantStore &store, const FieldStyle &style);
	void add_species(const FieldLook &look);
	/// The species' constants are others; the motion goes on. Where nothing moves (`is_still`), plants at rest take
	/// another rest direction at once.
	void set_species(int index, const FieldLook &look, const PlantStore &store, bool is_still);
	void set_update_interval(int steps);
	/// On or off, and anew where tips got other spheres.
	void fit_contact(bool on);

	/// What a frame is about.
	struct Frame {
		double delta = 0.0; ///< s.
		godot::Transform3D axes; ///< From the field's to the world's, invertible.
		godot::Ref<PlantWind> wind; ///< Null: still air.
		std::vector<godot::Vector3> eyes; ///< World axes: whoever looks.
		godot::SceneTree *tree = nullptr;
	};

	/// Steps for a frame: the last one goes on beside it and is shown in the next one. Tells how many µs of this
	/// thread steps took, which small fields take here.
	double advance(const Frame &frame, const MotionOptions &options);
	/// Steps for a tool, at the wind's own clock and without bodies; done when it returns.
	void preview(const Frame &frame, const MotionOptions &options);
	/// Sends what is new to the textures; tells whether they are other ones now.
	bool upload();
	/// Takes all poses over into the textures.
	void write_all();
	/// All plants into their rest.
	void settle();

	/// Where the shader finds the history of a species' prototypes: first layer, newest slot, blend; x is -1 where
	/// plants swing by themselves.
	godot::Vector3 history_of(int species) const;
	/// How late followers are, as the shader takes it: steps by metre of world x, y and z, and at the world's origin.
	struct Delays {
		godot::Vector4 after, before;
		float share = 1.0f; ///< Of `after`, while they go over to it.
	};
	Delays follower_delays(const godot::Transform3D &axes) const;

	TipState read_state_now(const PlantPlace &place);
	void write_state(const PlantPlace &place, const TipState &state);
	void apply_impulse(const PlantPlace &place, const glm::vec3 &impulse);
	bool is_point_in_plants_now(const glm::vec3 &point, float margin);
	/// The bend that is drawn in this frame.
	glm::vec2 read_drawn_bend_now(const PlantPlace &place) const;
	/// The textures show a plant, or a skeleton does instead.
	void set_hidden(const PlantPlace &place, bool hidden);

	/// Whether so many tips touch that some pairs are left out.
	bool is_crowded() const { return touches && touching.is_crowded(); }

	FieldBodies bodies;
	/// Bodies that came among plants, or left them, since it was asked last.
	std::vector<FieldBodies::Event> take_events() { return std::move(events); }
	const PoseTexture *poses() const { return textures.get(); }
	FieldWind wind_here(const Frame &frame, double offset) const;
	double step_length() const { return clock.step(); }
	int simulated_count() const { return simulation ? simulation->simulated_count() : 0; }
	double bytes_per_plant() const { return simulation ? simulation->bytes_per_plant() : 0.0; }
	double busy_usec() const { return steps.busy_usec(); }

private:
	std::unique_ptr<FieldSimulation> simulation;
	std::unique_ptr<PoseTexture> textures;
	std::vector<int> pages; ///< By block; -1: none.
	std::vector<int> block_of_page;
	std::vector<int> stale_blocks; ///< Plants of which are drawn again, and not written yet.
	TipContact touching;
	bool touches = false;
	FieldSteps steps; // After what it works on: it is destroyed first.
	FixedStep clock;
	float shown_alpha = 0.0f; ///< Of the step that is shown next.
	double wind_offset = 0.0; ///< s, the wind's clock less the simulation's.
	double seen_wind_time = -1.0; ///< s.
	uint64_t seen_wind = 0; ///< Its instance id.
	int frames_since_far = 0;
	std::vector<FieldBodies::Event> events;
	std::vector<glm::vec3> pushed_at; ///< m, field axes: bodies of the last step.

	int page_of(int block) const { return pages[size_t(block)]; }
	void grow(const ChangeSet::Grown &grown, const PlantStore &store, const FieldStyle &style);
	void drop_page(int block);
	void give_page(int block, int page);
	void keep_states(const FieldResult &result, const ChangeSet &changes, const PlantStore &store, FieldSimulation &old,
			const std::vector<int> &old_pages);
	void take_added(const PlantStore &store, const FieldStyle &style, const FieldSimulation *old,
			const std::vector<int> &old_pages);
	void set_rests(int page, const std::vector<glm::vec3> &rests, bool is_still);
	void update_wind(const Frame &frame, int step_count);
	void update_far(const Frame &frame, const MotionOptions &options);
	void push(double ago);
	void find_events(double margin);
	void start_step(const MotionOptions &options, bool with_contact);
};

} // namespace undergrowth
