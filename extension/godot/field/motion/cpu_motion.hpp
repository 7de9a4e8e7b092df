#pragma once

#include "base/worker_task.hpp"
#include "field/contact.hpp"
#include "field/mean_lean.hpp"
#include "field/motion/field_drift.hpp"
#include "field/motion/field_steps.hpp"
#include "field/motion/field_wind_clock.hpp"
#include "field/motion/prepared_cpu_motion.hpp"
#include "motion/fixed_step.hpp"
#include "motion/swing_clock.hpp"

#include <memory>
#include <vector>

namespace undergrowth {

/// The motion of a field by the core's simulation. The engine's worker threads step it between two frames. Every method
/// here waits for them if it uses their data. Main thread.
class CpuMotion : public FieldMotion {
public:
	CpuMotion();
	~CpuMotion() override;

	Prepare prepare() const override;
	PrepareChunk prepare_chunk() const override;
	void wait() override;
	bool is_ready() const override { return simulation != nullptr; }
	bool needs_cameras() const override;
	void start(const FieldSettings &settings) override;
	void begin_transfer(PreparedMotion &prepared, const std::vector<PlantMatch> &matches) override;
	bool is_transferring() const override { return transfer.is_running(); }
	void cancel_transfer() override;
	void adopt(PreparedMotion &prepared, const std::vector<PlantMatch> &matches, const ChangeSet &changes,
			const PlantStore &store, const FieldRenderSetup &setup) override;
	void apply(const ChangeSet &changes, const PlantStore &store, const FieldRenderSetup &setup,
			ArrivingChunks *arriving) override;
	PoseTexels reserve(PreparedChunk &prepared) override;
	void release_texels(PreparedChunk &prepared) override;
	void make_room(double plants, int chunks) override;
	void add_species(const SpeciesStyle &style) override;
	bool has_room_for_species() override;
	void set_species(int index, const SpeciesStyle &style, const PlantStore &store, bool is_still) override;
	void set_update_interval(int steps) override;
	void fit_contact(bool on) override;
	bool is_crowded() const override { return touches && touching.is_crowded(); }

	double advance(const Frame &frame, const MotionOptions &options) override;
	void preview(const Frame &frame, const MotionOptions &options) override;
	double motion_time() const override;
	void settle() override;

	bool upload() override;
	void set_hidden(const PlantRef &ref, bool hidden) override;
	void set_height(const PlantRef &ref, float share, const MotionPlant &plant) override;
	bool has_heights() const override { return textures && textures->has_heights(); }
	PoseTexels texels(int chunk) const override { return textures->texels(rows_of(chunk)); }
	godot::RID pose_texture() const override { return textures ? textures->poses() : godot::RID(); }
	godot::RID blend_texture() const override { return textures ? textures->blends() : godot::RID(); }
	godot::RID beat_texture() const override { return textures ? textures->beats() : godot::RID(); }
	float swing_clock() const override { return swings.now(shown_alpha); }
	float mean_lean(int species) const override { return leans.of(species); }
	godot::Vector4 history_of(int species) const override;
	bool follows_prototypes() const override { return textures && textures->follows(); }
	Delays follower_delays(const godot::Transform3D &axes) const override;

	MotionState blocking_read_state(const PlantRef &ref) override;
	glm::vec3 blocking_read_tip(const PlantRef &ref) override;
	StemMotion blocking_read_drawn_stem(const PlantRef &ref) const override;
	bool blocking_is_point_in_plants(const glm::vec3 &point, float margin) override;
	void write_state(const PlantRef &ref, const MotionState &state) override;
	void apply_impulse(const PlantRef &ref, const glm::vec3 &impulse) override;

	int simulated_count() const override { return simulation ? simulation->simulated_count() : 0; }
	double bytes_per_plant() const override { return simulation ? simulation->bytes_per_plant() : 0.0; }
	double busy_usec() const override { return steps.busy_usec(); }

private:
	std::unique_ptr<FieldSimulation> simulation;
	std::unique_ptr<PoseTexture> textures;
	std::vector<PageRows> rows; ///< By chunk.
	std::vector<PlantRef> pending_removals; ///< Removed plants that the simulation still contains.
	struct Height {
		PlantRef ref;
		float share;
		MotionPlant plant;
	};
	std::vector<Height> heights; ///< Changed heights that are not in the simulation yet.
	/// Pages with plants that are shown again or follow other prototypes, not written yet.
	std::vector<int> dirty_pages;
	TipContact touching;
	bool touches = false;
	double time_after_step = 0.0; ///< s: FieldSimulation::time() after the running step.
	FieldSteps steps; // Declared after the data that it uses, so it is destroyed first.
	WorkerTask transfer; // For the same reason.
	bool is_transferred = false; ///< The motion of matched plants is transferred for adopt(), and nothing moved since.
	FixedStep clock;
	FieldWindClock wind_clock;
	FieldDrift drift;
	std::vector<AirSource> stirring; ///< In the present step.
	bool showed_heights = false; ///< At the last upload().
	float shown_alpha = 0.0f; ///< Of the next frame to draw.
	SwingClock swings;
	MeanLean leans;
	int frames_since_far = 0;
	std::vector<glm::vec3> pushed_at; ///< m, field axes: bodies of the last step.

	const PageRows &rows_of(int chunk) const { return rows[size_t(chunk)]; }
	int row_of(const PlantRef &ref) const { return rows_of(ref.chunk).first + ref.slot; }
	void begin_clock();
	void write_all();
	int modes_of_prototypes(int species) const; ///< 0: it has none.
	void grow(const ChangeSet::Grown &grown, const PlantStore &store, const FieldRenderSetup &setup);
	void take_in(int chunk, PreparedCpuChunk &prepared);
	void drop(int page, int row);
	void exchange_chunks(const ChangeSet &changes, ArrivingChunks &arriving);
	void drop_rows(const PageRows &own, bool leaves_texels);
	void take_added(const PlantStore &store, const FieldRenderSetup &setup, const FieldSimulation *old,
			const std::vector<PageRows> &old_rows);
	void set_rests(const PageRows &plants, const std::vector<glm::vec3> &rests, bool is_still);
	void update_far(const Frame &frame, const MotionOptions &options);
	void push(double ago);
	void stir(const Frame &frame, const MotionOptions &options, double ago);
	void find_events(double margin);
	void start_step(const MotionOptions &options, bool with_contact);
};

} // namespace undergrowth
