#include "air_series.hpp"

#include "conventions.hpp"
#include "wind/fourier.hpp"

#include "figures.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace undergrowth;

namespace {

constexpr float CARRIED = 3.0f; // m/s.
constexpr double STEP = 1.0 / 16.0; // s.
constexpr int TEN_MINUTES = 9600; // Samples.
constexpr int SPECTRUM = 8192; // Number of samples used: a power of two.
constexpr int PLACES = 24;
constexpr double VARIANCE_TOLERANCE = 0.05;
constexpr double STEP_OF_BANDS = 1.189207; // A quarter of an octave.
constexpr double SLOPE = -1.571; // Of Kaimal's spectrum there.
constexpr double SLOPE_TOLERANCE = 0.1;
constexpr double THREE_SECOND_GUST = 2.12; // Standard deviations: Davenport's formula on Kaimal's spectrum.
constexpr double GUST_TOLERANCE = 0.08;
constexpr double COHERENCE_TOLERANCE = 0.1;
constexpr double SCALE_TOLERANCE = 0.1;
constexpr double MAX_CORRELATION = 0.15; // Correlation with any later quarter of an hour, statistical error included.

/// Ten minutes at distant positions.
const std::vector<Series> &ten_minutes() {
	static const std::vector<Series> all = [] {
		std::vector<Series> made;
		for (int i = 0; i < PLACES; i++) {
			made.push_back(turbulence_at(plain_air(CARRIED), 5.17f * static_cast<float>(i), 0.0f, TEN_MINUTES, STEP));
		}
		return made;
	}();
	return all;
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

/// Metres: the integral of the correlation along the wind, up to its end.
double integral_scale(std::vector<float> Line::*component) {
	std::vector<double> correlation(200);
	for (int i = 0; i < 96; i++) {
		const Line line = read_line(1.3331f * static_cast<float>(i));
		const std::vector<float> &values = line.*component;
		for (std::size_t lag = 0; lag < correlation.size(); lag++) {
			for (std::size_t k = 0; k < values.size(); k += 3) {
				correlation[lag] += static_cast<double>(values[k] * values[(k + lag) % values.size()]);
			}
		}
	}
	double sum = 0.5;
	for (std::size_t lag = 1; lag < correlation.size() && correlation[lag] > 0.0; lag++) {
		sum += correlation[lag] / correlation[0];
	}
	return sum * AirTiles::LENGTH_STEP;
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

TEST_CASE("the gust of three seconds is as strong as Davenport's") {
	double gust = 0.0;
	for (const Series &series : ten_minutes()) {
		gust += greatest_mean(series.along, 48) / PLACES;
	}
	figures::record(
			figures::WIND, "gust of three seconds, standard deviations (Davenport)", THREE_SECOND_GUST, gust, 2);
	CHECK(std::fabs(gust / THREE_SECOND_GUST - 1.0) < GUST_TOLERANCE);
}

TEST_CASE("neighbouring positions have the same slow waves, with less coherence at larger distances") {
	const double near = coherence(5, 1.0f), far = coherence(5, 4.0f); // f = 5/256 ≈ 0.02.
	figures::record(figures::WIND, "coherence of slow waves a metre apart (IEC 61400-1)", 0.70, near, 2);
	figures::record(figures::WIND, "four metres apart", 0.25, far, 2);
	CHECK(std::fabs(near / 0.70 - 1.0) < COHERENCE_TOLERANCE);
	CHECK(std::fabs(far / 0.25 - 1.0) < COHERENCE_TOLERANCE);
}

TEST_CASE("gusts have the lengths of the integral scales") {
	const double along = integral_scale(&Line::along), across = integral_scale(&Line::across);
	figures::record(figures::WIND, "integral scale along the wind", 3.6, along, 1, " m");
	figures::record(figures::WIND, "of what blows across it", 1.5, across, 1, " m");
	CHECK(std::fabs(along / 3.6 - 1.0) < SCALE_TOLERANCE);
	CHECK(std::fabs(across / 1.5 - 1.0) < SCALE_TOLERANCE);
}

TEST_CASE("at three metres per second turbulence arrives a second later three metres downwind") {
	const Air air = plain_air(CARRIED);
	const Series here = turbulence_at(air, 0.0f, 0.0f, 4000, 0.02), there = turbulence_at(air, 0.0f, 3.0f, 4000, 0.02);
	std::size_t best = 0;
	for (std::size_t lag = 0; lag < 150; lag++) {
		best = product(here.along, there.along, lag) > product(here.along, there.along, best) ? lag : best;
	}
	const double seconds = 0.02 * static_cast<double>(best);
	CHECK(std::fabs(seconds - 1.0) < 0.05);
	figures::record(figures::WIND, "from a place to one 3 m downwind at 3 m/s (Taylor)", 1.0, seconds, 2, " s");
}

TEST_CASE("turbulence at a position does not repeat within half an hour") {
	const Series series = turbulence_at(plain_air(CARRIED), 0.0f, 0.0f, 1800 * 4, 0.25);
	const double own = product(series.along, series.along, 0);
	double worst = 0.0;
	for (std::size_t lag = 60 * 4; lag < 1200 * 4; lag++) {
		worst = std::max(worst, product(series.along, series.along, lag) / own);
	}
	figures::record_error(figures::WIND, "likeness of any two times within half an hour", MAX_CORRELATION, worst);
	CHECK(worst < MAX_CORRELATION);
}
