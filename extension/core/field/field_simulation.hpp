#pragma once

#include "field/field_settings.hpp"
#include "field/follow_delays.hpp"
#include "field/loose_plants.hpp"
#include "field/prototypes.hpp"
#include "field/speed_counts.hpp"
#include "motion/bodies.hpp"
#include "motion/motion_page.hpp"
#include "motion/part_bend.hpp"
#include "wind/air_drift.hpp"
#include "wind/air_sources.hpp"
#include "wind/travelling_wind.hpp"

#include <cstdint>
#include <vector>

namespace undergrowth {

/// The motion of all plants of a field, in pages that any number of threads may step.
///
/// A step is begin_step(), then step_pages() once for every page, in any split and on any threads: the bits are the
/// same. Step n covers the time from n·step to (n + interval)·step, by one step of that length under the wind at its
/// MotionPage::wind_moment(), so that what is shown, the way from the bend before to the bend after (alpha()), is never
/// late. A page whose interval is k steps at steps n with n % k == phase % k: never all pages in one step (thesis,
/// section 5.3.1). Nothing allocates between begin_step() and the next change of the field.
///
/// Plants are named by page and index, which stay theirs.
class FieldSimulation {
public:
	explicit FieldSimulation(const FieldSettings &settings);

	const FieldSettings &settings() const { return options; }
	/// Tells the species' index.
	int add_species(const MotionSpecies &species);
	/// The motion goes on.
	void set_species(int index, const MotionSpecies &species);
	/// Other directions in calm air (unit, y > 0) of `count` plants of a page from `first` on, of the spring law: after
	/// set_species() with another law or lean. Their motion goes on; followers show prototypes that lean so from now
	/// on.
	void set_rests(int page, int first, const glm::vec3 *rests, int count);
	int species_count() const { return static_cast<int>(kinds.size()); }

	/// A page of `count` plants of one species, up to MotionPage::PAGE_PLANTS; tells its number, which is the lowest
	/// one that remove_page() freed, if any. Where a plant is not valid, the species is unknown or they are too many,
	/// nothing is added and it tells -1.
	int add_page(int species, const MotionPlant *plants, int count);
	/// The same of a page that was made elsewhere, of this simulation's settings, from these plants.
	int add_page(MotionPage &&page, const MotionPlant *plants);
	/// Appends plants of its species to a page that has room for them; their indices follow those that are there.
	/// Tells false, and adds nothing, where a plant is not valid or there is no room.
	bool add_to_page(int page, const MotionPlant *plants, int count);
	/// Takes a plant away; all others keep their index. Its row stays, and no body, blow, contact or question finds it.
	void drop(int page, int index);
	/// Takes a page with all its plants away; other pages keep their numbers. Until add_page() gives the number anew,
	/// it names a page without plants.
	void remove_page(int page);
	/// Page numbers are below it, also those that are free.
	int page_count() const { return static_cast<int>(entries.size()); }
	int plant_count() const;
	/// Plants that are stepped, prototypes included.
	int simulated_count() const;
	const MotionPage &page(int index) const { return at(index).page; }
	MotionPage &page(int index) { return at(index).page; }

	/// Any change of the wind takes effect at each page's next step, at no cost: nothing is kept per plant. Followers
	/// go over to new delays within a second (FollowDelays).
	void set_wind(const FieldWind &wind);
	const FieldWind &wind() const { return blowing; }
	/// What stirs the air in the coming steps, in the axes of the field. Followers that feel it swing by themselves
	/// meanwhile, and until they have rung down (LoosePlants); where these are too many, those that feel it most.
	void set_air_sources(const std::vector<AirSource> &sources);
	/// How the field moves through the air in the coming steps, in its own axes. Prototypes move as its origin does.
	void set_drift(const AirDrift &of_field) { drift = of_field; }
	/// Takes effect at each page's next step.
	void set_update_interval(int steps);
	/// The page's interval becomes `multiple` (1, 2, 4 ... 32) times the field's, 64 steps at most, as soon as the step
	/// that it has done is over.
	void set_page_multiple(int page, int multiple);
	int page_interval(int page) const;
	/// Whether somebody looks at a page from near. Stems of two modes (StemConstants::modes) step both while that is
	/// so, and while bodies, blows or contact push plants of their page, and LoosePlants::ALONE after it; then they go
	/// back, within LoosePlants::GOING_BACK, to the one that is half the work. Who is pushed has the second at once,
	/// who is seen from near bit by bit. Followers show as many as their stems have.
	void set_page_near(int page, bool is_near) { beat(page).is_near = is_near; }
	/// In which of the steps of its interval a page is due; its number, unless this says otherwise. Pages whose poses
	/// are sent together are best due together. Before the page's first step.
	void set_page_phase(int page, int phase) { beat(page).phase = phase; }
	/// What pushes plants in the coming steps; bodies that are not valid are left out. A follower that is pushed swings
	/// by itself until it has rung down (LoosePlants).
	void set_bodies(const MovingBody *bodies, int count);

	/// Seconds since the start: the number of steps that were begun, times their length.
	double time() const { return static_cast<double>(next_step) * static_cast<double>(options.step); }
	/// Moves the prototypes on and makes the next step the present one. On one thread. The first one simulates what
	/// prototypes did before the start, so that delays reach back into the same wind: about half a millisecond a
	/// species.
	void begin_step();
	/// The present step of pages [begin, end) that are due in it. Disjoint ranges may run on several threads at once.
	void step_pages(int begin, int end);
	/// Plants that the next step will step, prototypes included.
	int due_count() const;
	/// Of one page.
	int due_count(int page) const;
	/// begin_step() and step_pages() of all.
	void step();

	/// Whether the present step changed the page's bends.
	bool has_stepped(int page) const { return beat(page).last_step == next_step - 1; }
	/// How far to go from each plant's bend before to its bend after, `fraction` of a step after the present one began.
	float alpha(int page, float fraction) const;
	/// What is drawn of a plant, `fraction` of a step after the present one began, as a stereographic image of its
	/// direction (motion/bend_encoding.hpp): the same as undergrowth_shown() in the shader.
	glm::vec2 shown_bend(int page, int index, float fraction) const { return shown_way(page, index, fraction).bend; }
	/// What part_bend() needs of the same plant; all but the clock, in the axes of the field. As the vertex shader has
	/// it.
	StemMotion shown_stem(int page, int index, float fraction) const;
	/// Unit: where a plant points in calm air; of a follower whom it follows.
	glm::vec3 rest(int page, int index) const;
	/// The same as half floats know it as a stereographic image.
	glm::vec2 rest_bend(int page, int index) const;
	/// Whether plants of a page are of parts.
	bool has_parts(int page) const { return kinds[static_cast<std::size_t>(at(page).page.species())].has_parts; }
	/// What the change from a plant's bend before to its bend after is divided by to be the rate that its parts lag
	/// behind (s): the time between both, times how many steps that is. The rate jumps from each pair of bends to the
	/// next, the farther the more steps there are between them, and parts are to go as evenly as at every step.
	float rate_time(int page) const {
		const auto steps = static_cast<float>(models.empty() ? beat(page).interval : 1);
		return steps * steps * options.step;
	}
	/// The same as a unit direction.
	glm::vec3 shown_direction(int page, int index, float fraction) const {
		return from_stereographic(shown_bend(page, index, fraction));
	}
	/// A place on a plant as it is drawn (m), from its root (share 0) to its tip (1).
	glm::vec3 shown_point(int page, int index, float share, float fraction) const;
	/// At the end of its page's last step. Of a follower: what it shows at the end of the present one.
	MotionState motion(int page, int index) const;
	TipState state(int page, int index) const { return motion(page, index).tip; }
	/// As MotionPage::set_state(), of plants that swing; with a second mode that moves, their page steps it.
	void set_state(int page, int index, const TipState &state, const StemSecond &second);
	/// A blow on the tip (N·s): changes the velocity by impulse/mass.
	void apply_impulse(int page, int index, const glm::vec3 &impulse);

	/// A plant of another simulation, of the same species, goes on here; a follower that was pushed swings on by
	/// itself.
	void take_motion(int page, int index, const FieldSimulation &from, int from_page, int from_index);

	/// Puts all plants into their rest directions, without velocity, prototypes and what they did before included.
	void settle();

	/// Null where every plant of the species is simulated.
	const Prototypes *prototypes(int species) const;
	/// Whose motion a plant of a page that follows shows, and how long after the wind comes to it. Its delay is its own
	/// and that of follow_delays() at its root.
	const Follower &follower(int page, int index) const { return at(page).followers[static_cast<std::size_t>(index)]; }
	/// Followers of a species that were pushed and swing by themselves, for a while; null where every plant does.
	const LoosePlants *loose_plants(int species) const;
	/// Pages of which followers began or ended to swing by themselves, or follow others, or whose stems show more modes
	/// or fewer, since forget_changed_pages(); each once.
	const std::vector<int> &changed_pages() const { return changed; }
	void forget_changed_pages();
	/// How long before their own time prototypes feel the wind (s), so that plants upwind of the origin have a delay,
	/// too.
	float prototype_lead() const { return lead; }
	const FollowDelays &follow_delays() const { return delays; }

	/// Whether a point lies within `margin` (m) of a plant's line from root to tip, thickened by its collision
	/// radius, as it is drawn at the end of the present step.
	bool is_point_in_plants(const glm::vec3 &point, float margin) const;

	/// Bytes on the heap, by capacity, over plants. 0 where there are none.
	double bytes_per_plant() const;

private:
	struct Entry {
		MotionPage page;
		std::vector<Follower> followers; ///< Empty where plants swing by themselves.
		bool is_changed = false; ///< It is one of changed_pages().
		bool is_free = false; ///< Nobody's, for the next add_page().
	};

	/// When a page steps. Beside the pages, which other threads write to, so that going through all costs little.
	struct Beat {
		int64_t last_step = -1;
		int interval = 1; ///< Of the last step, in steps.
		int multiple = 1;
		int phase = 0;
		bool is_near = false;
		int64_t last_push = NEVER; ///< The step when plants were pushed last.
		int64_t last_near = NEVER; ///< The same of somebody who was near.
		int64_t two_since = NEVER; ///< When they began to step two modes.
	};
	static constexpr int64_t NEVER = -(int64_t(1) << 40);

	FieldSettings options;
	FieldWind blowing;
	PlantWinds along = {};
	std::vector<MotionSpecies> kinds;
	std::vector<Prototypes> models; ///< One for each species, or none.
	std::vector<LoosePlants> loose; ///< As many.
	std::vector<SpeedCounts> stirred; ///< As many; of the present round of steps.
	int stir_turn = -1; ///< Of the round, the next step's; -1: none was counted since sources came.
	std::vector<Entry> entries;
	std::vector<Beat> beats; ///< As many.
	std::vector<int> changed;
	int free_pages = 0;
	int plant_rows = 0; ///< Of all pages: the box is that of so many.
	std::vector<MovingBody> pushing;
	std::vector<AirSource> stirring;
	AirDrift drift;
	glm::vec3 box_low = { 0.0f, 0.0f, 0.0f };
	glm::vec3 box_high = { 0.0f, 0.0f, 0.0f };
	float lead = 0.0f; ///< s.
	FollowDelays delays;
	int64_t next_step = 0;

	const Entry &at(int page) const { return entries[static_cast<std::size_t>(page)]; }
	Entry &at(int page) { return entries[static_cast<std::size_t>(page)]; }
	const Beat &beat(int page) const { return beats[static_cast<std::size_t>(page)]; }
	Beat &beat(int page) { return beats[static_cast<std::size_t>(page)]; }
	void grow_box(const MotionPage &page, bool is_first);
	void update_box();
	void take_in(Entry &entry, const MotionPlant *plants, int count);
	void step_prototypes(int64_t number);
	bool is_due(int page, int64_t number) const;
	void step_page(int page);
	int64_t steps_in(float seconds) const { return static_cast<int64_t>(seconds / options.step); }
	void choose_modes();
	float ease_of(int page) const;
	void show_modes(int page, int count);
	void wake(int page);
	void update_delays();
	Follower pick(const MotionPlant &plant, int species) const;
	LoosePlants &loose_of(const Entry &entry);
	int number_of(const Entry &entry) const { return static_cast<int>(&entry - entries.data()); }
	void follower_changed(Entry &entry);
	int count_of_species(int species) const;
	glm::vec3 nearest_on_plant(int page, int index, const glm::vec3 &point) const;
	/// Whether a second mode of its stems has bends of its own.
	bool shows_seconds(const Entry &entry) const;
	BendWay shown_way(int page, int index, float fraction) const;
	BendWay mode_way(int mode, int page, int index, float fraction) const;
	BendWay followed_way(int mode, const Entry &entry, int index, float fraction) const;
	ModeBends shown_modes(int page, int index, float fraction) const;
	ModeBends followed_modes(const Entry &entry, int index) const;
	void push_follower(Entry &entry, int index, const MotionState &state);
	void follow_again(Entry &entry, int index);
	void step_loose();
	void push_followers(int page, const MovingBody &body);
	template <class Visit> void for_each_stirred(int first, int stride, const Visit &visit);
	void choose_stirred();
	void stir_followers();
};

} // namespace undergrowth
