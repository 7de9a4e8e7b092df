#pragma once

namespace undergrowth {

/// What the columns of a MotionPage hold; private to its own files.
namespace motion_page_columns {

/// Columns of every page.
enum Column : int {
	ROOT_X,
	ROOT_Y,
	ROOT_Z,
	LENGTH,
	STILL_COLUMNS,
};

/// Further columns of a page of the elasticity law; the last ones only where it keeps directions.
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

} // namespace motion_page_columns

} // namespace undergrowth
