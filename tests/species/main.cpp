// Grows species at random, one for each seed, and tells what is wrong with each. Run by tests/suites/species.py.
//
//     species FIRST COUNT STEP    seeds FIRST, FIRST + STEP …, COUNT of them
//
// The last line is `done: N species, N grown, N failed, slowest SEED with N ms`. A species that fails is told by its
// seed in a line `FAILED seed N: why`; what a sanitizer ends or what takes too long is the last.

#include "try_species.hpp"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <thread>

namespace {

using Clock = std::chrono::steady_clock;

constexpr int64_t LONGEST = 30000; // ms of the processor for one species, under sanitizers.
constexpr int64_t REPORTED = 10000; // ms between two words of how far it is.

std::atomic<uint64_t> present_seed{ 0 };
Stage present_stage{ "" };
std::atomic<int64_t> begun{ 0 }; // ms of the processor, however busy the machine is.
std::atomic<uint64_t> tried{ 0 };

int64_t now() {
	return std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now().time_since_epoch()).count();
}

int64_t spent() {
	return static_cast<int64_t>(1000.0 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC);
}

void tell(uint64_t seed, const char *what) {
	std::printf("FAILED seed %llu: %s\n", static_cast<unsigned long long>(seed), what);
	std::fflush(stdout);
}

/// Tells how far it is and ends the program where a species does not end.
[[noreturn]] void watch() {
	for (int64_t told = now();;) {
		std::this_thread::sleep_for(std::chrono::milliseconds(200));
		const int64_t time = now();
		if (spent() - begun > LONGEST) {
			tell(present_seed, (std::string("still ") + present_stage.load() + " after 30 s").c_str());
			std::_Exit(1);
		}
		if (time - told > REPORTED) {
			std::printf("%llu species\n", static_cast<unsigned long long>(tried.load()));
			std::fflush(stdout);
			told = time;
		}
	}
}

/// All sanitizers end the program so, as SANITIZER_OPTIONS of tests/suites say.
void write_end(int) {
	tell(present_seed, (std::string("ended by a sanitizer while ") + present_stage.load()).c_str());
	std::_Exit(1);
}

} // namespace

int main(int argument_count, char **arguments) {
	const auto number = [&](int i, uint64_t usual) {
		return argument_count > i ? std::strtoull(arguments[i], nullptr, 10) : usual;
	};
	const uint64_t first = number(1, 0);
	const uint64_t count = number(2, 1000);
	const uint64_t step = number(3, 1);
	std::signal(SIGABRT, write_end);
	begun = spent();
	std::thread(watch).detach();
	uint64_t grown = 0, failed = 0, slowest = first;
	int64_t longest = 0;
	for (uint64_t i = 0; i < count; i++) {
		const uint64_t seed = first + i * step;
		present_seed = seed;
		begun = spent();
		bool is_grown = false;
		const std::string problem = try_species(seed, present_stage, is_grown);
		if (!problem.empty()) {
			tell(seed, problem.c_str());
			failed++;
		}
		grown += is_grown ? 1 : 0;
		tried++;
		const int64_t taken = spent() - begun;
		if (taken > longest) {
			longest = taken;
			slowest = seed;
		}
	}
	std::printf("done: %llu species, %llu grown, %llu failed, slowest %llu with %lld ms\n",
			static_cast<unsigned long long>(count), static_cast<unsigned long long>(grown),
			static_cast<unsigned long long>(failed), static_cast<unsigned long long>(slowest),
			static_cast<long long>(longest));
	std::fflush(stdout);
	std::_Exit(failed > 0 ? 1 : 0); // The one that watches still runs.
}
