#pragma once

#include <string>

/// Figures that tests measure and hold to what was asked, for the tables in README (tools/figures.py): where the
/// environment names a file as FIGURES, it holds them after the run, a line each.
namespace figures {

/// A number beside the one that was asked for, with so many digits after the point. Of one that is told again the last
/// counts.
void tell(const std::string &table, const std::string &what, double asked, double measured, int digits,
		const char *unit = "");
/// How far off something is at most, as a share; the largest of those that are told under the same name counts. Where
/// it is far less than `most`, the figure says only that, so that it is the same on every machine.
void tell_error(const std::string &table, const std::string &what, double most, double error);

inline const char *const STEMS = "stems"; ///< That stand.
inline const char *const SWINGS = "swings"; ///< Stems that move.
inline const char *const WIND = "wind";

} // namespace figures
