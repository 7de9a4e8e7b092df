#pragma once

namespace undergrowth {

/// Columns of a MotionPage; private to its own files.
namespace motion_page_columns {

/// Columns of every page.
enum Column : int {
	ROOT_X,
	ROOT_Y,
	ROOT_Z,
	LENGTH,
	STILL_COLUMNS,
};

/// Further columns of a page of the elasticity law; the last ones only in pages with directions.
enum ElasticityColumn : int {
	X = STILL_COLUMNS,
	Y,
	Z,
	TURN_X,
	TURN_Y,
	TURN_Z,
	WEIGHT,
	SWINGING_COLUMNS,
	LAST_X = SWINGING_COLUMNS,
	LAST_Y,
	LAST_Z,
	REMEMBERING_COLUMNS,
};

/// Further columns of a page of the spring law, as many.
enum SpringColumn : int {
	FLAT_X = STILL_COLUMNS,
	FLAT_Z,
	FLAT_RATE_X,
	FLAT_RATE_Z,
	REST_X,
	REST_Z,
	WIND_GAIN,
	FLAT_LAST_X = SWINGING_COLUMNS,
	FLAT_LAST_Z,
};

/// Further columns of a page of the stem law: those of mode 0, those of mode 1 if there is one, and in pages with
/// directions the amplitudes of each before the last step.
enum StemColumn : int {
	PLACE_X = STILL_COLUMNS,
	PLACE_Z,
	RATE_X,
	RATE_Z,
	STEM_REST_X, ///< Stereographic.
	STEM_REST_Z,
	LOAD_SCALE, ///< The reference length over the plant's own.
	SECOND_PLACE_X = SWINGING_COLUMNS,
	SECOND_PLACE_Z,
	SECOND_RATE_X,
	SECOND_RATE_Z,
	TWO_MODES_COLUMNS,
};

/// First of the four consecutive columns of a mode: amplitudes x and z, and their rates.
constexpr int first_of_mode(int mode) {
	return mode == 0 ? static_cast<int>(PLACE_X) : static_cast<int>(SECOND_PLACE_X);
}

/// First column of the amplitudes before the last step, in a page of `modes`.
constexpr int last_of_mode(int modes, int mode) {
	return (modes == 1 ? static_cast<int>(SWINGING_COLUMNS) : static_cast<int>(TWO_MODES_COLUMNS)) + 2 * mode;
}

constexpr int stem_columns(int modes, bool keeps_directions) {
	return last_of_mode(modes, keeps_directions ? modes : 0);
}

/// Number of columns after these for stems with own frequencies: the factors of both loads, and four per mode.
constexpr int graded_columns(int modes) {
	return 2 + 4 * modes;
}

} // namespace motion_page_columns

} // namespace undergrowth
