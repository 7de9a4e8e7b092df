#include "wind/air_profile.hpp"

#include "base/portable_math.hpp"

#include <algorithm>
#include <cmath>

namespace undergrowth {

namespace {

constexpr double KARMAN = 0.4;
constexpr double GUSTS_OF_FRICTION = 2.185; // σ_u/u*, from the integral of the spectrum.
constexpr double DISPLACEMENT = 0.7; // Of the canopy's height.
constexpr double CANOPY_ROUGHNESS = 0.1;
constexpr double SMOOTHEST = 1e-6; // m.
constexpr double ROUGHEST =
		0.5 * REFERENCE_HEIGHT / OpenGround::ROUGH_LAYER; // m: the rough layer stays below the reference.
constexpr double MIN_CANOPY = 1e-3; // m.
constexpr double MAX_CANOPY = 0.9 * REFERENCE_HEIGHT; // m.
constexpr double BEAUFORT = 0.836; // m/s.
constexpr int STRONGEST = 12;

double safe_roughness(double roughness) {
	return std::isfinite(roughness) ? std::clamp(roughness, SMOOTHEST, ROUGHEST) : SMOOTHEST;
}

double safe_height(double height) {
	return std::isfinite(height) ? std::max(height, 0.0) : 0.0;
}

} // namespace

OpenGround::OpenGround(double roughness) :
		rough(safe_roughness(roughness)), over_log(1.0 / portable_log(REFERENCE_HEIGHT / rough)) {}

/// Fraction of the rough layer below a height; 1 above it.
double OpenGround::share_of_layer(double height) const {
	return std::min(safe_height(height) / (ROUGH_LAYER * rough), 1.0);
}

double OpenGround::speed(double height) const {
	const double above = std::max(safe_height(height), ROUGH_LAYER * rough);
	return portable_log(above / rough) * over_log * share_of_layer(height);
}

double OpenGround::gusts(double height) const {
	return GUSTS_OF_FRICTION * KARMAN * over_log * share_of_layer(height);
}

double OpenGround::eddies(double height) const {
	const double above = std::max(safe_height(height), ROUGH_LAYER * rough);
	return std::clamp(EDDIES_AT_ONE + EDDIES_GROWTH * portable_log(above), 0.0, 1.0);
}

double open_ground_speed(double height, double roughness) {
	return OpenGround(roughness).speed(height);
}

double open_ground_gusts(double height, double roughness) {
	return OpenGround(roughness).gusts(height);
}

double open_ground_eddies(double height, double roughness) {
	return OpenGround(roughness).eddies(height);
}

double canopy_top_speed(double canopy_height) {
	return canopy_speed(canopy_height, canopy_height);
}

double canopy_speed(double height, double canopy_height, double extinction) {
	const double top = std::clamp(safe_height(canopy_height), MIN_CANOPY, MAX_CANOPY);
	const double above = std::max(safe_height(height), top);
	const double rough = CANOPY_ROUGHNESS * top;
	const double down = DISPLACEMENT * top;
	const double speed = portable_log((above - down) / rough) / portable_log((REFERENCE_HEIGHT - down) / rough);
	return speed * portable_exp(-extinction * (1.0 - std::min(safe_height(height) / top, 1.0)));
}

double canopy_gusts(double height, double canopy_height, double extinction) {
	const double top = std::clamp(safe_height(canopy_height), MIN_CANOPY, MAX_CANOPY);
	return CANOPY_GUSTS * canopy_speed(std::min(safe_height(height), top), canopy_height, extinction);
}

double beaufort_speed(int number) {
	const auto force = static_cast<double>(number);
	return BEAUFORT * force * std::sqrt(force);
}

int beaufort_of(double speed) {
	int number = 0;
	while (number < STRONGEST && speed >= 0.5 * (beaufort_speed(number) + beaufort_speed(number + 1))) {
		number++;
	}
	return number;
}

} // namespace undergrowth
