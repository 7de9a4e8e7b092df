// Runs one kernel on plants that are all different, and prints a hash of the bits that it wrote.
//
//   kernel_counts                      prints the names of the kernels, one a line
//   kernel_counts LEVEL KERNEL TIMES   LEVEL: baseline or avx2. Runs the kernel TIMES times over PLANTS plants
//
// `./run bench parts=instructions` starts it with an emulator that counts instructions. The hash is of the first run,
// which every start performs, so that starts with different TIMES differ by the kernel's instructions only.

#include "../core/motion/stem_plants.hpp"
#include "base/random.hpp"
#include "motion/joint_constants.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>

using namespace undergrowth;

namespace {

constexpr int PLANTS = 4096;
constexpr int AT_ONCE = 512;
constexpr float STEP = 1.0f / 60.0f;

/// PLANTS numbers around `middle`.
std::vector<float> numbers(uint64_t which, float middle, float deviation) {
	std::vector<float> made;
	for (uint64_t i = 0; i < PLANTS; i++) {
		made.push_back(middle + deviation * signed_noise(which, i));
	}
	return made;
}

/// What a kernel reads and writes: columns of floats, and packed words.
struct Bench {
	SimdLevel level;
	std::vector<std::vector<float>> columns;
	std::vector<uint32_t> words;
	std::vector<uint64_t> cells;
	std::unique_ptr<StemPlants> stems = nullptr;
	std::function<void(int begin, int count)> run = nullptr;

	float *at(int column, int begin) { return columns[static_cast<std::size_t>(column)].data() + begin; }
	void run_all() const {
		for (int begin = 0; begin < PLANTS; begin += AT_ONCE) {
			run(begin, AT_ONCE);
		}
	}
	uint64_t hash() const {
		GoldenHash made;
		for (const std::vector<float> &column : columns) {
			made.add(column);
		}
		const uint64_t of_stems = stems ? stems->hash() : 0;
		return made.add(words).add(&of_stems, 1).value();
	}
};

void prepare_elasticity(Bench &bench) {
	const Joint joint = safe_joint({});
	bench.columns = { numbers(1, 0.0f, 0.4f), numbers(2, 0.9f, 0.05f), numbers(3, 0.0f, 0.4f), numbers(4, 0.0f, 0.01f),
		numbers(5, 0.0f, 0.01f), numbers(6, 0.0f, 0.01f), numbers(7, 0.0f, 0.0f), numbers(8, 2.0f, 1.0f) };
	const std::vector<float> lengths = numbers(9, 1.0f, 0.5f);
	elasticity_weights(joint, STEP, lengths.data(), PLANTS, bench.at(6, 0));
	const ElasticityConstants made = elasticity_constants(joint, STEP);
	bench.run = [&bench, made](int begin, int count) {
		kernels(bench.level)
				.step_elasticity({ bench.at(0, begin), bench.at(1, begin), bench.at(2, begin), bench.at(3, begin),
										 bench.at(4, begin), bench.at(5, begin), bench.at(6, begin), made.lift_share,
										 made.wind_share, made.keep, made.lowest_y },
						count, { bench.at(7, begin), 0.8f, 0.6f });
	};
}

void prepare_spring(Bench &bench) {
	bench.columns = { numbers(1, 0.0f, 0.4f), numbers(2, 0.0f, 0.4f), numbers(3, 0.0f, 1.0f), numbers(4, 0.0f, 1.0f),
		numbers(5, 0.0f, 0.2f), numbers(6, 0.0f, 0.2f), numbers(7, 0.0f, 0.0f), numbers(8, 2.0f, 1.0f) };
	const std::vector<float> lengths = numbers(9, 1.0f, 0.5f);
	const SpringConstants made = spring_constants(safe_joint({}), STEP);
	spring_gains(made, lengths.data(), PLANTS, bench.at(6, 0));
	bench.run = [&bench, made](int begin, int count) {
		kernels(bench.level)
				.step_spring({ bench.at(0, begin), bench.at(1, begin), bench.at(2, begin), bench.at(3, begin),
									 bench.at(4, begin), bench.at(5, begin), bench.at(6, begin), made.place_from_place,
									 made.place_from_rate, made.rate_from_place, made.rate_from_rate, MAX_GNOMONIC },
						count, { bench.at(7, begin), 0.8f, 0.6f });
	};
}

/// The plants of `page` from `begin` on.
StemPage part_of(StemPage page, int begin) {
	for (int mode = 0; mode < page.step.modes; mode++) {
		page.x[mode] += begin;
		page.z[mode] += begin;
		page.rate_x[mode] += begin;
		page.rate_z[mode] += begin;
	}
	page.rest_x += begin;
	page.rest_z += begin;
	page.scale += begin;
	return page;
}

/// Leaning stems of `modes` modes, which the bench owns.
StemPage make_stems(Bench &bench, int modes) {
	bench.columns = { numbers(1, 0.0f, 0.3f), numbers(2, 0.0f, 0.3f), numbers(3, 0.0f, 0.1f), numbers(4, 4.0f, 2.0f) };
	bench.stems = std::make_unique<StemPlants>(
			modes == 1 ? simple_stem(1.5, 0.1) : stem_of_two_modes(1.5, 0.1), PLANTS, STEP);
	for (int i = 0; i < PLANTS; i++) {
		bench.stems->set_place(i, { *bench.at(0, i), *bench.at(1, i) });
		bench.stems->set_rest(i, { *bench.at(2, i), -*bench.at(2, i) });
	}
	return bench.stems->page();
}

void prepare_stem(Bench &bench, int modes) {
	bench.run = [&bench, page = make_stems(bench, modes)](int begin, int count) {
		PlantAir air;
		air.x = bench.at(3, begin);
		air.z = bench.at(2, begin);
		kernels(bench.level).step_stem(part_of(page, begin), count, { nullptr, 1.0f, 0.0f }, air);
	};
}

void prepare_stem_bends(Bench &bench) {
	bench.words.resize(2 * PLANTS);
	bench.run = [&bench, page = make_stems(bench, 1)](int begin, int count) {
		kernels(bench.level).encode_stem(part_of(page, begin), count, bench.words.data() + 2 * begin, nullptr);
	};
}

void prepare_bends(Bench &bench) {
	bench.columns = { numbers(1, 0.0f, 1.5f), numbers(2, 0.0f, 1e-4f) };
	bench.words.resize(2 * PLANTS);
	bench.run = [&bench](int begin, int count) {
		kernels(bench.level)
				.encode_spring(bench.at(0, begin), bench.at(1, begin), count, bench.words.data() + 2 * begin);
	};
}

/// A map of noise, which the bench owns.
AirMap noise_map(Bench &bench, int cells) {
	for (uint64_t i = 0; i < static_cast<uint64_t>(cells); i++) {
		bench.cells.push_back(mix_bits(mix_bits(7) ^ i));
	}
	AirMap map;
	map.cells = bench.cells.data();
	map.s = 1e5f;
	map.s_x = 9000.0f;
	map.s_z = 5000.0f;
	map.n_x = -5000.0f;
	map.n_z = 9000.0f;
	map.sway = 3000.0f;
	map.turn_x = 0.05f;
	return map;
}

void prepare_turbulence(Bench &bench) {
	bench.columns = { numbers(1, 0.0f, 20.0f), numbers(2, 0.0f, 20.0f), numbers(3, 0.0f, 0.0f),
		numbers(4, 0.0f, 0.0f) };
	bench.run = [&bench, map = noise_map(bench, 2 * 1024 * 256)](int begin, int count) {
		wind_kernels(bench.level)
				.sample_turbulence(
						map, bench.at(0, begin), bench.at(1, begin), count, bench.at(2, begin), bench.at(3, begin));
	};
}

void prepare_waves(Bench &bench) {
	bench.columns = { numbers(1, 0.0f, 20.0f), numbers(2, 0.0f, 20.0f), numbers(3, 0.0f, 1.0f),
		numbers(4, 0.0f, 0.0f) };
	bench.run = [&bench, map = noise_map(bench, 256 * 128)](int begin, int count) {
		wind_kernels(bench.level)
				.sample_waves(map, 800.0f, bench.at(2, begin), bench.at(0, begin), bench.at(1, begin), count,
						bench.at(3, begin));
	};
}

void prepare_velocities(Bench &bench) {
	bench.columns = { numbers(1, 0.0f, 1.0f), numbers(2, 0.0f, 1.0f), numbers(3, 0.0f, 1.0f), numbers(4, 0.0f, 1.0f),
		numbers(5, 0.0f, 1.0f) };
	AirMoments moments = { 5.0f, 1.2f, 0.9f, 0.1f, 0.8f, 0.6f, -0.6f, 0.8f };
	moments.eddies = moments.waves = moments.side_eddies = 0.5f;
	bench.run = [&bench, moments](int begin, int count) {
		wind_kernels(bench.level)
				.make_velocities(moments, { bench.at(2, begin), bench.at(3, begin), bench.at(4, begin) }, count,
						bench.at(0, begin), bench.at(1, begin));
	};
}

void prepare_samples(Bench &bench, bool is_kept) {
	bench.columns = { numbers(1, 0.0f, 9.0f), numbers(2, 0.0f, 9.0f) };
	for (uint64_t i = 0; i < 4 * PLANTS; i++) {
		bench.words.push_back(static_cast<uint32_t>(mix_bits(mix_bits(9) ^ i)));
	}
	const AirWeights weights = { (4096u - 900u) << 16 | 300u, 200u << 16 | 800u, 4.0f, 0.5f };
	bench.run = [&bench, weights, is_kept](int begin, int count) {
		uint32_t *groups = bench.words.data() + 4 * begin;
		if (is_kept) {
			wind_kernels(bench.level).keep_samples(bench.at(0, begin), bench.at(1, begin), count, groups);
		} else {
			wind_kernels(bench.level).between_samples(groups, weights, count, bench.at(0, begin), bench.at(1, begin));
		}
	};
}

struct Kernel {
	const char *name;
	void (*prepare)(Bench &bench);
};
constexpr Kernel KERNELS[] = {
	{ "step_elasticity", prepare_elasticity },
	{ "step_spring", prepare_spring },
	{ "step_stem", [](Bench &bench) { prepare_stem(bench, 1); } },
	{ "step_stem_two_modes", [](Bench &bench) { prepare_stem(bench, 2); } },
	{ "air_turbulence", prepare_turbulence },
	{ "air_waves", prepare_waves },
	{ "air_velocities", prepare_velocities },
	{ "air_keep_samples", [](Bench &bench) { prepare_samples(bench, true); } },
	{ "air_between_samples", [](Bench &bench) { prepare_samples(bench, false); } },
	{ "bends_spring", prepare_bends },
	{ "bends_stem", prepare_stem_bends },
};

int run_kernel(const char *level, const char *name, int times) {
	for (const Kernel &kernel : KERNELS) {
		if (std::strcmp(kernel.name, name) == 0) {
			Bench bench;
			bench.level = std::strcmp(level, "avx2") == 0 ? SimdLevel::avx2 : SimdLevel::baseline;
			if (bench.level > best_simd_level()) {
				std::fprintf(stderr, "This processor has no %s\n", level);
				return 1;
			}
			kernel.prepare(bench);
			bench.run_all();
			std::printf("%016llx\n", static_cast<unsigned long long>(bench.hash()));
			for (int i = 0; i < times; i++) {
				bench.run_all();
			}
			return 0;
		}
	}
	std::fprintf(stderr, "There is no kernel %s\n", name);
	return 1;
}

} // namespace

int main(int count, char **words) {
	if (count == 4) {
		return run_kernel(words[1], words[2], std::atoi(words[3]));
	}
	for (const Kernel &kernel : KERNELS) {
		std::puts(kernel.name);
	}
	return 0;
}
