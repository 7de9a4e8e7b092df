#pragma once

#include <string>

/// Figures that tests measure and compare with a goal, for the tables in README (tools/figures.py). If the environment
/// variable FIGURES names a file, it contains them after the run, one per line.
namespace figures {

/// Records a number beside its goal, with `digits` digits after the point. If it is recorded again, the last value
/// counts.
void record(const std::string &table, const std::string &what, double expected, double measured, int digits,
		const char *unit = "");
/// Records the largest error, as a fraction. Under the same name the largest one counts. If it is far below `max`, the
/// figure states only that, so it is the same on every machine.
void record_error(const std::string &table, const std::string &what, double max, double error);

inline const char *const STEMS = "stems"; ///< Stems at rest.
inline const char *const SWINGS = "swings"; ///< Stems in motion.
inline const char *const WIND = "wind";

} // namespace figures
