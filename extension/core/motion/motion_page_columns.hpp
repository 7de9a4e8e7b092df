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

/// Further columns of a page of the elasticity law.
enum ElasticityColumn : int {
	X = STILL_COLUMNS,
	Y,
	Z,
	TURN_X,
	TURN_Y,
	TURN_Z,
	WEIGHT,
	SWINGING_COLUMNS,
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
};

} // namespace motion_page_columns

} // namespace undergrowth
