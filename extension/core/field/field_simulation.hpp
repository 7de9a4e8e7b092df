#pragma once

#include "field/canopy_grid.hpp"
#include "field/detached_followers.hpp"
#include "field/field_settings.hpp"
#include "field/follow_delays.hpp"
#include "field/prototypes.hpp"
#include "field/speed_histogram.hpp"
#include "motion/bodies.hpp"
#include "motion/motion_page.hpp"
#include "motion/part_bend.hpp"
#include "wind/air_drift.hpp"
#include "wind/air_sources.hpp"
#include "wind/field_wind.hpp"

#include <cstdint>
#include <vector>

namespace undergrowth {

/// Motion of all plants of a field, in pages that any number of threads may step.
///
/// A step is begin_step(), then step_pages() once for every page, in any split and on any threads: the bits are the
/// same. Step n covers the time from n·step to (n + interval)·step, by one step of that length under the wind at its
/// MotionPage::wind_moment(), so the drawn interpolation between the bend before and after (alpha()) is never
/// late. A page whose interval is k steps at steps n with n % k == phase % k: never all pages in one step (thesis,
/// section 5.3.1). Nothing allocates between begin_step() and the next change of the field.
///
/// Page and index identify a plant and do not change.
class FieldSimulation {
public:
	explicit FieldSimulation(const FieldSettings &settings);

	const FieldSettings &settings() const { return options; }
	/// Returns the species' index.
	int add_species(const MotionSpecies &species);
	/// Does not interrupt the motion.
	void set_species(int index, const MotionSpecies &species);
	/// Sets the rest directions (unit, y > 0) of `count` plants of a page from `first` on, for the spring law. Call it
	/// after set_species() with another law or lean. The motion continues; followers switch to prototypes with that
	/// lean.
	void set_rests(int page, int first, const glm::vec3 *rests, int count);
	int species_count() const { return static_cast<int>(kinds.size()); }

	/// A page of `count` plants of one species, up to MotionPage::PAGE_PLANTS; returns its number, the lowest
	/// one that remove_page() freed, if any. Returns -1 and adds nothing if a plant is invalid, the species is unknown,
	/// or there are too many plants.
	int add_page(int species, const MotionPlant *plants, int count);
	/// The same with a page that was built elsewhere from these plants and this simulation's settings.
	int add_page(MotionPage &&page, const MotionPlant *plants);
	/// Appends plants of its species to a page that has room for them; their indices follow those that are there.
	/// Returns false and adds nothing if a plant is invalid or there is no room.
	bool add_to_page(int page, const MotionPlant *plants, int count);
	/// Removes a plant; other indices do not change. Its row remains, but bodies, blows, contact and queries skip it.
	void drop(int page, int index);
	/// Changes position, length and rest of a plant, as MotionPage::set_plant().
	void set_plant(int page, int index, const MotionPlant &plant);
	/// Removes a page with its plants; other page numbers do not change. Until add_page() reuses the number, it refers
	/// to an empty page.
	void remove_page(int page);
	/// Upper bound of page numbers, free ones included.
	int page_count() const { return static_cast<int>(entries.size()); }
	int plant_count() const;
	/// Number of rows of all pages, at least plant_count(). Needs no loop.
	int row_count() const { return plant_rows; }
	/// Plants that are stepped, prototypes included.
	int simulated_count() const;
	const MotionPage &page(int index) const { return at(index).page; }
	MotionPage &page(int index) { return at(index).page; }

	/// A change of the wind takes effect at each page's next step, at no cost per plant. Followers change to new delays
	/// within a second (FollowDelays).
	void set_wind(const FieldWind &wind);
	const FieldWind &wind() const { return blowing; }
	/// Sources of wind for the next steps, in the axes of the field. Followers within reach swing by themselves until
	/// they come to rest (DetachedFollowers); if there are too many, those with the strongest wind.
	void set_air_sources(const std::vector<AirSource> &sources);
	/// How the field moves through the air in the coming steps, in its own axes. Prototypes move as its origin does.
	void set_drift(const AirDrift &of_field) { drift = of_field; }
	/// Takes effect at each page's next step.
	void set_update_interval(int steps);
	/// The page's interval becomes `multiple` (1, 2, 4 ... 32) times the field's, 64 steps at most, when the time
	/// of its last step is over.
	void set_page_multiple(int page, int multiple);
	int page_interval(int page) const;
	/// Marks a page as near a camera. Stems of two modes (StemConstants::modes) step both while they are near or while
	/// bodies, blows or contact push plants of their page, and for DetachedFollowers::ALONE after that. Then they
	/// return to one mode within DetachedFollowers::GOING_BACK, which is half the work. A push shows the second mode at
	/// once, nearness blends it in. Followers show all modes of their stems.
	void set_page_near(int page, bool is_near) { beat(page).is_near = is_near; }
	/// Sets in which step of its interval a page is due; the default is its number. Pages that share an upload should
	/// share the phase. Call it before the page's first step.
	void set_page_phase(int page, int phase);
	/// Bodies that push plants in the next steps; invalid bodies are skipped. A pushed follower swings by itself until
	/// it comes to rest (DetachedFollowers).
	void set_bodies(const MovingBody *bodies, int count);

	/// Seconds since the start: the number of started steps, and of `more` steps, times their length.
	double time(int64_t more = 0) const {
		return static_cast<double>(next_step + more) * static_cast<double>(options.step);
	}
	/// Steps the prototypes and starts the next step. Call it on one thread. The first call simulates the prototypes'
	/// past, so that delays reach back into the same wind: about half a millisecond per species.
	void begin_step();
	/// Runs the present step of the due pages in [begin, end). Disjoint ranges may run on several threads at once.
	void step_pages(int begin, int end);
	/// Number of plants in the next step, prototypes included.
	int due_count() const;
	/// Of one page.
	int due_count(int page) const;
	/// begin_step() and step_pages() of all.
	void step();

	/// Pages of the present step, ascending; empty with prototypes.
	const std::vector<int> &due_pages() const { return stepping; }
	/// True if the present step changed the page's bends.
	bool has_stepped(int page) const { return beat(page).last_step == next_step - 1; }
	/// Number of steps so far.
	int64_t step_count() const { return next_step; }
	/// Interpolation weight from each plant's bend before to its bend after, `fraction` of a step after the present one
	/// started.
	float alpha(int page, float fraction) const;
	/// The drawn bend of a plant, `fraction` of a step after the present one started: the stereographic image of its
	/// direction (motion/bend_encoding.hpp): the same as undergrowth_shown() in the shader.
	glm::vec2 shown_bend(int page, int index, float fraction) const { return shown_way(page, index, fraction).bend; }
	/// Input of part_bend() for the same plant, without the clock, in the axes of the field. Equal to the vertex
	/// shader's.
	StemMotion shown_stem(int page, int index, float fraction) const;
	/// Rest direction of a plant (unit); for a follower that of its prototype.
	glm::vec3 rest(int page, int index) const;
	/// The same as a stereographic image, rounded to half floats.
	glm::vec2 rest_bend(int page, int index) const;
	/// True if plants of the page have parts.
	bool has_parts(int page) const { return kinds[static_cast<std::size_t>(at(page).page.species())].has_parts; }
	/// Divisor (s) that turns the change between the two bends of a plant into the rate for its parts: the time between
	/// them, times its number of steps. The rate jumps between pairs of bends, more for longer intervals; the factor
	/// makes parts move as evenly as at every step.
	float rate_time(int page) const {
		const auto steps = static_cast<float>(models.empty() ? beat(page).interval : 1);
		return steps * steps * options.step;
	}
	/// Changes whenever rate_time() or MotionPage::has_second_bends() of a page changes.
	int64_t rates_version() const { return rates_changed; }
	/// The same as a unit direction.
	glm::vec3 shown_direction(int page, int index, float fraction) const {
		return from_stereographic(shown_bend(page, index, fraction));
	}
	/// A drawn point on a plant (m), from its root (share 0) to its tip (1).
	glm::vec3 shown_point(int page, int index, float share, float fraction) const;
	/// State at the end of the page's last step. For a follower: the drawn state at the end of the present one.
	MotionState motion(int page, int index) const;
	TipState state(int page, int index) const { return motion(page, index).tip; }
	/// Like MotionPage::set_state(), for simulated plants. A moving second mode makes the page step it.
	void set_state(int page, int index, const TipState &state, const StemSecond &second);
	/// As MotionPage::lasting_bend(); 0 for followers, which have none.
	glm::vec2 lasting_bend(int page, int index) const { return at(page).page.lasting_bend(index); }
	void set_lasting_bend(int page, int index, const glm::vec2 &bend) { at(page).page.set_lasting_bend(index, bend); }
	/// A blow on the tip (N·s): changes the velocity by impulse/mass.
	void apply_impulse(int page, int index, const glm::vec3 &impulse);

	/// Transfers the motion of a plant of another simulation, of the same species. A pushed follower continues to swing
	/// by itself.
	void transfer_motion(int page, int index, const FieldSimulation &from, int from_page, int from_index);

	/// Sets all plants to rest, including prototypes and their history.
	void settle();

	/// Null if every plant of the species is simulated.
	const Prototypes *prototypes(int species) const;
	/// Prototype and delay of a follower. The total delay is its own plus that of follow_delays() at its root.
	const Follower &follower(int page, int index) const { return at(page).followers[static_cast<std::size_t>(index)]; }
	/// Followers of a species that swing by themselves after a push; null if every plant is simulated.
	const DetachedFollowers *detached_followers(int species) const;
	/// Pages with followers that started or stopped swinging by themselves or changed their prototype, and pages with a
	/// new number of modes, since forget_changed_pages(). No duplicates.
	const std::vector<int> &changed_pages() const { return changed; }
	void forget_changed_pages();
	/// Time by which prototypes are ahead of the wind (s), so that plants upwind of the origin have a positive delay.
	float prototype_lead() const { return lead; }
	const FollowDelays &follow_delays() const { return delays; }

	/// True if a point is within `margin` (m) of a plant's line from root to tip, thickened by its collision radius, in
	/// the pose at the end of the present step.
	bool is_point_in_plants(const glm::vec3 &point, float margin) const;

	/// Speed (m/s) of the wind at the middle of the field now, at the tops of a species, without sources.
	float air_speed(int species) const;
	/// Velocity (m/s, x and z of the field) of the air now at a plant of `height` metres at `root` that does not belong
	/// to the field, sheltered by its plants, with sources. The wind is in m/s.
	glm::vec2 air_around(const glm::vec3 &root, float height) const;
	/// Speed (m/s) of the strongest source that reaches the field; 0: none.
	float stirred_speed() const;
	/// As CanopyGrid::around(). Any thread, also during steps.
	PlantCanopy canopy_around(const glm::vec3 &place, float height, int species) const {
		return canopy.around(place, height, species);
	}

	/// Heap bytes (capacity) divided by plants; 0 without plants.
	double bytes_per_plant() const;

private:
	struct Entry {
		MotionPage page;
		std::vector<Follower> followers; ///< Empty if the plants are simulated.
		bool is_changed = false; ///< Is in changed_pages().
		bool is_free = false; ///< Reusable by add_page().
	};

	/// Schedule of a page. Separate from the pages, which other threads write, so that a loop over all is cheap.
	struct Beat {
		int64_t last_step = -1;
		int interval = 1; ///< Interval of the last step, in steps.
		int multiple = 1;
		int phase = 0;
		bool is_near = false;
		int64_t last_push = NEVER; ///< Step of the last push.
		int64_t last_near = NEVER; ///< Last step at which a camera was near.
		int64_t two_since = NEVER; ///< Step at which it started to step two modes.
		int64_t canopy_version = -1; ///< Of the canopy that shelters it.
		int64_t canopy_step = NEVER; ///< Step at which that was read.
	};
	static constexpr int64_t NEVER = -(int64_t(1) << 40);

	FieldSettings options;
	FieldWind blowing;
	PlantWinds along = {};
	std::vector<MotionSpecies> kinds;
	std::vector<Prototypes> models; ///< One per species, or empty.
	std::vector<DetachedFollowers> detached; ///< As many.
	std::vector<SpeedHistogram> stirred; ///< The same size; for the present round of steps.
	int stir_turn = -1; ///< Of the next step within the round; -1: not counted since sources exist.
	std::vector<Entry> entries;
	std::vector<Beat> beats; ///< As many.
	std::vector<int64_t> due_at; ///< As many: the next step of each page. A step reads only these of most pages.
	std::vector<int> stepping; ///< Pages of the present step.
	std::vector<int> changed;
	int free_pages = 0;
	int plant_rows = 0; ///< Rows of all pages when the box was computed.
	std::vector<MovingBody> pushing;
	std::vector<AirSource> stirring;
	AirDrift drift;
	CanopyGrid canopy;
	int64_t canopy_of_models = -1; ///< Version of the canopy that shelters the prototypes.
	glm::vec3 box_low = { 0.0f, 0.0f, 0.0f };
	glm::vec3 box_high = { 0.0f, 0.0f, 0.0f };
	float lead = 0.0f; ///< s.
	FollowDelays delays;
	int64_t next_step = 0;
	int64_t rates_changed = 0;

	const Entry &at(int page) const { return entries[static_cast<std::size_t>(page)]; }
	Entry &at(int page) { return entries[static_cast<std::size_t>(page)]; }
	const Beat &beat(int page) const { return beats[static_cast<std::size_t>(page)]; }
	Beat &beat(int page) { return beats[static_cast<std::size_t>(page)]; }
	void grow_box(const MotionPage &page, bool is_first);
	void update_box();
	void take_in(Entry &entry, const MotionPlant *plants, int count);
	void step_prototypes(int64_t number);
	void add_to_canopy(const MotionPage &page, int begin, int end, float sign);
	void rebuild_canopy();
	void shelter_page(int page);
	void shelter_prototypes();
	void set_due(int page);
	/// In the next step.
	bool is_due(int page) const { return due_at[static_cast<std::size_t>(page)] == next_step; }
	void begin_pages();
	void step_page(int page);
	int64_t steps_in(float seconds) const { return static_cast<int64_t>(seconds / options.step); }
	void choose_modes(int page);
	float ease_of(int page) const;
	void show_modes(int page, int count);
	void wake(int page);
	void update_delays();
	Follower pick(const MotionPlant &plant, int species) const;
	DetachedFollowers &detached_of(const Entry &entry);
	int number_of(const Entry &entry) const { return static_cast<int>(&entry - entries.data()); }
	void follower_changed(Entry &entry);
	int count_of_species(int species) const;
	glm::vec3 nearest_on_plant(int page, int index, const glm::vec3 &point) const;
	/// True if the second mode has bends of its own.
	bool shows_seconds(const Entry &entry) const;
	BendWay shown_way(int page, int index, float fraction) const;
	BendWay mode_way(int mode, int page, int index, float fraction) const;
	BendWay followed_way(int mode, const Entry &entry, int index, float fraction) const;
	ModeBends shown_modes(int page, int index, float fraction) const;
	ModeBends followed_modes(const Entry &entry, int index) const;
	void push_follower(Entry &entry, int index, const MotionState &state);
	void follow_again(Entry &entry, int index);
	void step_detached();
	void push_followers(int page, const MovingBody &body);
	template <class Visit> void for_each_stirred(int first, int stride, const Visit &visit);
	void choose_stirred();
	void stir_followers();
};

} // namespace undergrowth
