#include "air_series.hpp"

#include "conventions.hpp"
#include "wind/fourier.hpp"

#include "figures.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace undergrowth;

namespace {

constexpr float CARRIED = 3.0f; // m/s at 1 m.
constexpr double STEP = 1.0 / 16.0; // s.
constexpr int TEN_MINUTES = 9600; // Samples.
constexpr int SPECTRUM = 8192; // Number of samples used: a power of two.
constexpr int PLACES = 48;
constexpr float WIDE = 2048.0f; // m, half the length of the map of eddies.
constexpr double VARIANCE_TOLERANCE = 0.05;
constexpr double STEP_OF_BANDS = 1.189207; // A quarter of an octave.
constexpr double SLOPE = -1.571; // Of Kaimal's spectrum there.
constexpr double SLOPE_TOLERANCE = 0.1;
constexpr double GUST_TOLERANCE = 0.05;
constexpr double COHERENCE_TOLERANCE = 0.1;
constexpr double LENGTH_TOLERANCE = 0.2;
constexpr double KAIMAL_LENGTH = 5.5; // Heights: S(0)·U/(4σ²).
constexpr double MIN_SPECTRUM = 0.7; // Of Kaimal's.
constexpr double MAX_SPECTRUM = 1.4;
constexpr double MAX_CORRELATION = 0.1; // From 40 s to an hour.
constexpr double MIN_PATCH = 0.45; // Standard deviations that the mean of 30 × 30 m keeps.
constexpr double MAX_SWIRL = -0.3;
constexpr float HEIGHTS[] = { 1.0f, 2.0f, 10.0f }; // m.
constexpr float SPEEDS[] = { 3.0f, 5.0f, 9.3f, 19.0f }; // m/s at 10 m.

Air open_air(float speed) {
	Air air = plain_air(1.0f);
	air.speed = speed;
	return air;
}

double speed_at(const Air &air, float height) {
	return static_cast<double>(air.speed) *
			open_ground_speed(static_cast<double>(height), static_cast<double>(air.roughness));
}

/// Ten minutes at distant positions.
const std::vector<Series> &ten_minutes() {
	static const std::vector<Series> all =
			WindAt(plain_air(CARRIED), 1.0f, scattered(1, PLACES, WIDE), scattered(2, PLACES, WIDE))
					.series(TEN_MINUTES, STEP);
	return all;
}

/// Kaimal's spectrum along the wind, f·S/σ², by the reduced frequency.
double kaimal(double reduced) {
	return 22.0 * reduced * std::pow(1.0 + 33.0 * reduced, -5.0 / 3.0);
}

/// The expected strongest mean of three seconds within ten minutes, above their mean, in standard deviations: Davenport
/// (1964) on Kaimal's spectrum.
double davenport_gust(double speed, double height) {
	constexpr double MEAN = 3.0; // s.
	constexpr double WHOLE = 600.0;
	constexpr double OCTAVE_PART = 0.01;
	double variance = 0.0, crossings = 0.0;
	for (double log_f = std::log(1e-5); log_f < std::log(20.0); log_f += OCTAVE_PART) {
		const double f = std::exp(log_f);
		const double fast = std::sin(PI * f * MEAN) / (PI * f * MEAN);
		const double slow = std::sin(PI * f * WHOLE) / (PI * f * WHOLE);
		const double power = kaimal(f * height / speed) * fast * fast * (1.0 - slow * slow) * OCTAVE_PART;
		variance += power;
		crossings += f * f * power;
	}
	const double peaks = std::sqrt(2.0 * std::log(std::sqrt(crossings / variance) * WHOLE));
	return (peaks + 0.5772 / peaks) * std::sqrt(variance);
}

std::vector<double> periodogram(const std::vector<float> &values) {
	ComplexGrid line(SPECTRUM, 1);
	for (std::size_t i = 0; i < SPECTRUM; i++) {
		// Hann's window: leakage from the strong slow waves would flatten the slope.
		const double window = 1.0 - std::cos(2.0 * PI * static_cast<double>(i) / SPECTRUM);
		line.real[i] = window * static_cast<double>(values[i]);
	}
	sum_waves(line);
	std::vector<double> power;
	for (std::size_t i = 0; i < SPECTRUM / 2; i++) {
		power.push_back(line.real[i] * line.real[i] + line.imaginary[i] * line.imaginary[i]);
	}
	return power;
}

/// Slope of the line through logarithms of `power` between two frequencies (Hz), with equal weight for each octave.
double slope_of(const std::vector<double> &power, double from, double to) {
	double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, count = 0.0;
	for (double f = from; f * STEP_OF_BANDS < to * 1.01; f *= STEP_OF_BANDS) {
		double sum = 0.0;
		int bins = 0;
		const double bins_per_hertz = SPECTRUM * STEP;
		const double last = f * STEP_OF_BANDS * bins_per_hertz;
		for (auto i = static_cast<std::size_t>(f * bins_per_hertz); static_cast<double>(i) < last; i++) {
			sum += power[i];
			bins++;
		}
		const double log_f = std::log(f);
		const double log_power = std::log(sum / bins);
		x += log_f;
		y += log_power;
		xx += log_f * log_f;
		xy += log_f * log_power;
		count += 1.0;
	}
	return (count * xy - x * y) / (count * xx - x * x);
}

double greatest_mean(const std::vector<float> &values, std::size_t length) {
	double sum = 0.0, greatest = -1e30;
	for (std::size_t i = 0; i < values.size(); i++) {
		sum += static_cast<double>(values[i]);
		if (i >= length) {
			sum -= static_cast<double>(values[i - length]);
			greatest = std::max(greatest, sum / static_cast<double>(length));
		}
	}
	return greatest;
}

/// Lines of the map along the wind, between its texels, `across` metres apart.
struct Line {
	std::vector<float> along = std::vector<float>(AirTiles::WIDTH);
	std::vector<float> across = std::vector<float>(AirTiles::WIDTH);
};

Line read_line(float side) {
	AirMap map;
	map.cells = shared_tiles().turbulence.data();
	map.s_x = map.n_z = AirMap::PARTS;
	std::vector<float> x, z;
	for (int i = 0; i < AirTiles::WIDTH; i++) {
		x.push_back(static_cast<float>(i) + 0.37f);
		z.push_back(side / static_cast<float>(AirTiles::SIDE_STEP));
	}
	Line line;
	baseline_wind_kernels()->sample_turbulence(
			map, x.data(), z.data(), AirTiles::WIDTH, line.along.data(), line.across.data());
	return line;
}

/// Coherence of waves around `wave` per map length, at positions `distance` metres apart.
double coherence(int wave, float distance) {
	double both = 0.0, own = 0.0;
	for (int i = 0; i < 96; i++) {
		const float side = 1.3331f * static_cast<float>(i);
		ComplexGrid a(AirTiles::WIDTH, 1), b(AirTiles::WIDTH, 1);
		const Line here = read_line(side), there = read_line(side + distance);
		std::copy(here.along.begin(), here.along.end(), a.real.begin());
		std::copy(there.along.begin(), there.along.end(), b.real.begin());
		sum_waves(a);
		sum_waves(b);
		for (int k = wave - 1; k <= wave + 1; k++) {
			const auto n = static_cast<std::size_t>(k);
			both += a.real[n] * b.real[n] + a.imaginary[n] * b.imaginary[n];
			own += a.real[n] * a.real[n] + a.imaginary[n] * a.imaginary[n];
		}
	}
	return both / own;
}

/// Metres: the integral over time of the correlation with the present, up to its end, times the speed.
double integral_length(float height) {
	const Air air = open_air(5.0f);
	const WindAt wind(air, height, scattered(3, 16384, WIDE), scattered(4, 16384, WIDE));
	const Series now = wind.at(0.0);
	const double variance = product(now.along, now.along, 0);
	double sum = 0.0, before = 1.0;
	double distance = 0.0; // Heights.
	for (double step = 0.1; distance < 200.0; step *= 1.02) {
		distance += step;
		const Series later = wind.at(distance * static_cast<double>(height) / speed_at(air, height));
		const double correlation = product(now.along, later.along, 0) / variance;
		if (correlation < 0.0) {
			break;
		}
		sum += 0.5 * step * (before + correlation);
		before = correlation;
	}
	return sum * static_cast<double>(height);
}

} // namespace

TEST_CASE("ten minutes of turbulence have the expected variance") {
	double along = 0.0, across = 0.0;
	for (const Series &series : ten_minutes()) {
		along += product(series.along, series.along, 0) / PLACES;
		across += product(series.across, series.across, 0) / PLACES;
	}
	figures::record(figures::WIND, "variance of ten minutes, along the wind", 1.0, along, 3);
	figures::record(figures::WIND, "across it", 1.0, across, 3);
	CHECK(std::fabs(along - 1.0) < VARIANCE_TOLERANCE);
	CHECK(std::fabs(across - 1.0) < VARIANCE_TOLERANCE);
}

TEST_CASE("the spectrum falls from 0.5 to 4 Hz as Kaimal's") {
	std::vector<double> power(SPECTRUM / 2);
	for (const Series &series : ten_minutes()) {
		const std::vector<double> own = periodogram(series.along);
		for (std::size_t i = 0; i < power.size(); i++) {
			power[i] += own[i];
		}
	}
	const double slope = slope_of(power, 0.5, 4.0);
	figures::record(figures::WIND, "slope of the spectrum from 0.5 to 4 Hz (Kaimal)", SLOPE, slope, 2);
	CHECK(std::fabs(slope - SLOPE) < SLOPE_TOLERANCE);
}

TEST_CASE("at 10 m the gust of three seconds is as strong as Davenport's") {
	constexpr int MANY = 96;
	constexpr double TENTH = 0.1; // s.
	const double intensity = open_ground_gusts(10.0, 0.03) / open_ground_speed(10.0, 0.03);
	for (const float speed : SPEEDS) {
		double gust = 0.0;
		for (const Series &series : WindAt(open_air(speed), 10.0f, scattered(5, MANY, WIDE), scattered(6, MANY, WIDE))
						.series(6000, TENTH)) {
			gust += (greatest_mean(series.along, 30) - mean_of(series.along)) / MANY;
		}
		const double factor = 1.0 + intensity * gust;
		const double expected = 1.0 + intensity * davenport_gust(static_cast<double>(speed), 10.0);
		MESSAGE("gust factor at " << speed << " m/s: " << factor << ", Davenport " << expected);
		CHECK(std::fabs(factor / expected - 1.0) < GUST_TOLERANCE);
		if (speed == 9.3f) {
			figures::record(
					figures::WIND, "gust factor of three seconds at 10 m, 9.3 m/s (Davenport)", expected, factor, 2);
		}
	}
}

TEST_CASE("neighbouring positions have the same slow waves, with less coherence at larger distances") {
	const double f = 5.0 / 256.0; // 1/m.
	for (const float distance : { 1.0f, 4.0f }) {
		const double law =
				std::exp(-10.0 * static_cast<double>(distance) * std::sqrt(f * f + std::pow(0.12 / 56.7, 2.0)));
		const double found = coherence(5, distance);
		figures::record(figures::WIND,
				distance < 2.0f ? "coherence of slow waves of small turbulence, a metre apart (IEC 61400-1)"
								: "four metres apart",
				law, found, 2);
		CHECK(std::fabs(found / law - 1.0) < COHERENCE_TOLERANCE);
	}
}

TEST_CASE("gusts have the lengths of Kaimal's spectrum at each height") {
	for (const float height : HEIGHTS) {
		const double expected = KAIMAL_LENGTH * static_cast<double>(height);
		const double length = integral_length(height);
		MESSAGE(height << " m: " << length / expected);
		CHECK(std::fabs(length / expected - 1.0) < LENGTH_TOLERANCE);
		figures::record(figures::WIND,
				height < 2.0f			? "integral length at 1 m (Kaimal)"
						: height < 3.0f ? "at 2 m"
										: "at 10 m",
				expected, length, 1, " m");
	}
}

TEST_CASE("the spectrum at each height is Kaimal's") {
	constexpr int MANY = 128;
	constexpr double HEIGHTS_PER_SAMPLE = 0.2;
	constexpr double BAND = 1.333521; // An eighth of a decade.
	double least = 10.0, greatest = 0.0;
	for (const float height : HEIGHTS) {
		const Air air = open_air(5.0f); // Patterns are frozen: the speed has no effect on reduced frequencies.
		const double step = HEIGHTS_PER_SAMPLE * static_cast<double>(height) / speed_at(air, height);
		std::vector<double> power(SPECTRUM / 2);
		for (const Series &series :
				WindAt(air, height, scattered(7, MANY, WIDE), scattered(8, MANY, WIDE)).series(SPECTRUM, step)) {
			const std::vector<double> own = periodogram(series.along);
			for (std::size_t i = 0; i < power.size(); i++) {
				power[i] += own[i] * 2.0 / (1.5 * SPECTRUM * MANY); // Per sample's frequency; 1.5: of the window.
			}
		}
		for (double reduced = 0.01; reduced < 1.01; reduced *= BAND) {
			double found = 0.0, law = 0.0;
			for (std::size_t i = 1; i < power.size(); i++) {
				const double own = static_cast<double>(i) / SPECTRUM / HEIGHTS_PER_SAMPLE;
				if (own > reduced / std::sqrt(BAND) && own < reduced * std::sqrt(BAND)) {
					found += power[i];
					law += kaimal(own) / own / HEIGHTS_PER_SAMPLE;
				}
			}
			least = std::min(least, found / law);
			greatest = std::max(greatest, found / law);
			CHECK(found / law > MIN_SPECTRUM);
			CHECK(found / law < MAX_SPECTRUM);
		}
	}
	figures::record(figures::WIND, "least of its spectrum over Kaimal's, 1 to 10 m, reduced frequencies 0.01 to 1",
			MIN_SPECTRUM, least, 2);
	figures::record(figures::WIND, "greatest", MAX_SPECTRUM, greatest, 2);
}

TEST_CASE("at three metres per second turbulence arrives a second later three metres downwind") {
	const std::vector<Series> both =
			WindAt(plain_air(CARRIED), 1.0f, { 0.0f, 0.0f }, { 0.0f, 3.0f }).series(4000, 0.02);
	const std::vector<float> &here = both[0].along, &there = both[1].along;
	std::size_t best = 0;
	for (std::size_t lag = 0; lag < 150; lag++) {
		best = product(here, there, lag) > product(here, there, best) ? lag : best;
	}
	const double seconds = 0.02 * static_cast<double>(best);
	CHECK(std::fabs(seconds - 1.0) < 0.05);
	figures::record(figures::WIND, "from a place to one 3 m downwind at 3 m/s (Taylor)", 1.0, seconds, 2, " s");
}

TEST_CASE("the wind at a position does not repeat within an hour") {
	constexpr int MANY = 8192;
	const double error = 4.0 / std::sqrt(static_cast<double>(MANY)); // Four standard deviations of a mean product.
	double worst = -1.0;
	for (const float height : HEIGHTS) {
		for (const float speed : SPEEDS) {
			const Air air = open_air(speed);
			const WindAt wind(air, height, scattered(9, MANY, WIDE), scattered(10, MANY, WIDE));
			const Series now = wind.at(0.0);
			const double variance = product(now.along, now.along, 0);
			std::vector<double> lags;
			for (double lag = 40.0; lag < 3600.0; lag += 40.0) {
				lags.push_back(lag);
			}
			// Where the maps repeat.
			for (const auto &[length, carried] :
					{ std::pair{ AirTiles::WIDTH * AirTiles::LENGTH_STEP, turbulence_speed(air) },
							std::pair{ AirTiles::WIDTH * AirTiles::EDDY_LENGTH_STEP, eddies_speed(air) } }) {
				for (double lag = length / carried; lag < 3600.0; lag += length / carried) {
					lags.push_back(lag);
				}
			}
			for (const double lag : lags) {
				const double correlation = product(now.along, wind.at(lag).along, 0) / variance;
				worst = lag < 40.0 ? worst : std::max(worst, correlation);
			}
		}
	}
	MESSAGE("largest correlation " << worst);
	figures::record_error(
			figures::WIND, "likeness of the wind at a place and 40 s to an hour later", MAX_CORRELATION, worst);
	CHECK(worst < MAX_CORRELATION + error);
}

TEST_CASE("gusts cross a meadow as a whole") {
	constexpr int MANY = 3000;
	constexpr int SIDE = 12; // Positions.
	constexpr float PATCH = 30.0f; // m.
	const std::vector<float> east = scattered(11, MANY, WIDE), south = scattered(12, MANY, WIDE);
	for (const float height : HEIGHTS) {
		double squares = 0.0;
		for (std::size_t k = 0; k < MANY; k++) {
			std::vector<float> x, z;
			for (int i = 0; i < SIDE * SIDE; i++) {
				x.push_back(east[k] + PATCH * (static_cast<float>(i % SIDE) + 0.5f) / SIDE);
				z.push_back(south[k] + PATCH * (static_cast<float>(i / SIDE) + 0.5f) / SIDE);
			}
			squares += std::pow(mean_of(WindAt(open_air(5.0f), height, x, z).at(0.0).along), 2.0) / MANY;
		}
		MESSAGE(height << " m: " << std::sqrt(squares));
		CHECK(std::sqrt(squares) > MIN_PATCH);
		if (height == 1.0f) {
			figures::record(figures::WIND, "standard deviations that the mean over 30 × 30 m keeps, 1 m, at least",
					MIN_PATCH, std::sqrt(squares), 2);
		}
	}
}

TEST_CASE("large eddies are swirls") {
	constexpr int MANY = 20000;
	constexpr float APART = 6.0f; // m, along; 16 m across.
	const AirSnapshot now = air_at_time(open_air(5.0f), {}, &shared_tiles(), 0.0);
	const auto eddies = [&](float right, float on) {
		std::vector<float> x = scattered(13, MANY, WIDE), z = scattered(14, MANY, WIDE);
		for (std::size_t i = 0; i < x.size(); i++) {
			x[i] += right;
			z[i] += on;
		}
		Series series = { std::vector<float>(MANY), std::vector<float>(MANY) };
		baseline_wind_kernels()->sample_turbulence(
				now.open.eddies, x.data(), z.data(), MANY, series.along.data(), series.across.data());
		return series;
	};
	const Series here = eddies(0.0f, 0.0f), on = eddies(0.0f, APART), right = eddies(2.0f * APART, 0.0f);
	double both = 0.0, along = 0.0, across = 0.0, stress = 0.0;
	for (std::size_t i = 0; i < MANY; i++) {
		const auto du = static_cast<double>(on.along[i] - here.along[i]);
		const auto dv = static_cast<double>(right.across[i] - here.across[i]);
		both += du * dv;
		along += du * du;
		across += dv * dv;
		stress += static_cast<double>(here.along[i] * here.across[i]) / MANY;
	}
	const double correlation = both / std::sqrt(along * across);
	figures::record(
			figures::WIND, "correlation of du/dx and dv/dy of large eddies, at most", MAX_SWIRL, correlation, 2);
	CHECK(correlation < MAX_SWIRL);
	CHECK(std::fabs(stress) < 0.1);
}
