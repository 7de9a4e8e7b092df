// The plants of a FieldSimulation that follow prototypes, and those of them that were pushed.

#include "field/field_simulation.hpp"

#include <glm/geometric.hpp>

#include <algorithm>

namespace undergrowth {

namespace {

constexpr int FOLLOWER_BLOCK = 256;
constexpr float MOST_STEPS = 1e9f; // Of a delay.

} // namespace

void FieldSimulation::update_lead() {
	const TravellingWind wind = wind_at_time(blowing, 0.0);
	const float x = wind.delay_x > 0.0f ? box_low.x : box_high.x;
	const float z = wind.delay_z > 0.0f ? box_low.z : box_high.z;
	lead = std::max(-(wind.delay_x * x + wind.delay_z * z), 0.0f);
}

int FieldSimulation::wanted_delay(const Follower &follower, float x, float z, const TravellingWind &wind) const {
	const float late = (lead + (wind.delay_x * x + wind.delay_z * z)) * (1.0f / options.step);
	const int steps = static_cast<int>(std::min(std::max(late, 0.0f), MOST_STEPS)) + follower.own_delay;
	return static_cast<int>(static_cast<uint32_t>(steps) % Prototypes::LONGEST_DELAY);
}

void FieldSimulation::show_followers(Entry &entry, int most_change) {
	const Prototypes &model = models[static_cast<std::size_t>(entry.page.species())];
	const TravellingWind wind = wind_at_time(blowing, 0.0); // For the delays, which are the same at all times.
	const float *__restrict x = entry.page.roots_x();
	const float *__restrict z = entry.page.roots_z();
	Follower *followers = entry.followers.data();
	const Bend *swinging = loose_of(entry).page().bends();
	Bend *pairs = entry.page.bends();
	int wanted[FOLLOWER_BLOCK];
	for (int begin = 0; begin < entry.page.size(); begin += FOLLOWER_BLOCK) {
		const int count = std::min(FOLLOWER_BLOCK, entry.page.size() - begin);
		for (int i = 0; i < count; i++) {
			wanted[i] = wanted_delay(followers[begin + i], x[begin + i], z[begin + i], wind);
		}
		for (int i = 0; i < count; i++) {
			Follower &follower = followers[begin + i];
			const int change = wanted[i] - follower.delay;
			follower.delay = static_cast<uint16_t>(follower.delay + std::clamp(change, -most_change, most_change));
			Bend *pair = pairs + 2 * (begin + i);
			pair[0] = pair[1];
			pair[1] = follower.loose > 0 ? swinging[2 * follower.loose - 1]
										 : model.bend(follower.prototype, follower.delay);
		}
	}
}

LoosePlants &FieldSimulation::loose_of(const Entry &entry) {
	return loose[static_cast<std::size_t>(entry.page.species())];
}

int FieldSimulation::count_of_species(int species) const {
	int plants = 0;
	for (const Entry &entry : entries) {
		plants += entry.page.species() == species ? entry.page.standing() : 0;
	}
	return plants;
}

/// What a follower shows, or showed `ago` steps before. Where its bend is not written, nobody keeps its delay.
Bend FieldSimulation::followed_bend(const Entry &entry, int index, int ago) const {
	const Follower &follower = entry.followers[static_cast<std::size_t>(index)];
	int delay = follower.delay;
	if (!options.write_followers) {
		const glm::vec3 root = entry.page.root(index);
		delay = wanted_delay(follower, root.x, root.z, wind_at_time(blowing, 0.0));
	}
	return models[static_cast<std::size_t>(entry.page.species())].bend(follower.prototype, delay + ago);
}

/// From now on it swings by itself; where too many do, it goes on following.
void FieldSimulation::push_follower(Entry &entry, int index, const TipState &state) {
	LoosePlants &some = loose_of(entry);
	Follower &follower = entry.followers[static_cast<std::size_t>(index)];
	if (follower.loose > 0) {
		some.push(follower.loose - 1, state);
		return;
	}
	if (some.is_full()) {
		return;
	}
	MotionPlant plant;
	plant.root = entry.page.root(index);
	plant.length = entry.page.length(index);
	plant.rest = models[static_cast<std::size_t>(entry.page.species())].rest(follower.prototype);
	const int page = static_cast<int>(&entry - entries.data());
	const int number = some.add(plant, page, index, state, followed_bend(entry, index, 1));
	follower.loose = static_cast<uint16_t>(number + 1);
	entry.loose_version++;
}

void FieldSimulation::follow_again(Entry &entry, int index) {
	Follower &follower = entry.followers[static_cast<std::size_t>(index)];
	if (follower.loose == 0) {
		return;
	}
	LoosePlants &some = loose_of(entry);
	const int number = follower.loose - 1;
	some.remove(number);
	follower.loose = 0;
	entry.loose_version++;
	if (number < some.count()) {
		Entry &moved = at(some.page_of(number));
		moved.followers[static_cast<std::size_t>(some.index_of(number))].loose = static_cast<uint16_t>(number + 1);
		moved.loose_version++;
	}
}

/// Those that swing by themselves step before bodies make more of them, so that each begins with what it showed.
void FieldSimulation::step_loose() {
	for (LoosePlants &some : loose) {
		if (some.count() == 0) {
			continue;
		}
		const double moment = static_cast<double>(next_step - 1) + some.page().wind_moment();
		some.step(wind_at_time(blowing, moment * static_cast<double>(options.step)), along);
		for (int number = some.count() - 1; number >= 0; number--) {
			Entry &entry = at(some.page_of(number));
			const int index = some.index_of(number);
			if (some.grow_older(number, followed_bend(entry, index, 0)) >= 1.0f) {
				follow_again(entry, index);
			}
		}
	}
	for (const FieldBody &body : pushing) {
		for (int page = 0; page < page_count() && !models.empty(); page++) {
			push_followers(page, body);
		}
	}
}

void FieldSimulation::push_followers(int page, const FieldBody &body) {
	Entry &entry = at(page);
	const float thickness = std::max(entry.page.collision_radius(), 0.0f);
	for_each_in_reach(entry.page, body, [&](int index) {
		TipState pushed = state(page, index);
		if (push_plant(pushed, entry.page.root(index), entry.page.length(index), thickness, body)) {
			push_follower(entry, index, pushed);
		}
	});
}

} // namespace undergrowth
