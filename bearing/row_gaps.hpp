#pragma once
/// Stretches of a table of rows over time or angle in which the table tells nothing.
///
/// Between rows straight lines are meant. Whether a long line is meant or rows are lost cannot be
/// known; what the table itself resolves can. The error of a line grows with the square of its
/// length (textbook: L^2/8 of the second derivative): one that is sqrt(10) times as long as rows
/// stand apart errs ten times as much as the rest of the table, one that is ten times as long a
/// hundred times, all that a table good to a hundredth has. A stretch counts as that long against
/// the median distance of rows and against both stretches beside it: traces that are digitised by
/// hand change their distances from row to row by less, tables of a few corners have a median of
/// the length of their lines, and a row half way says that a line is meant; one at the seam of two
/// periods says nothing, every table has it.
#include <cstddef>
#include <vector>

namespace shellback::bearing {

inline constexpr double kLineToTell = 3.1622776601683795;  ///< root of 10, see above [-]
inline constexpr double kLineToRefuse = 10.0;              ///< see above [-]

struct RowGap {
  std::size_t from = 0;  ///< row behind which it begins
  std::size_t to = 0;    ///< row at which it ends; 0: of the next period
  double length = 0.0;   ///< unit of t
  double times = 0.0;    ///< over the longest of both stretches beside it and the median [-]
};

/// Stretches of more than kLineToTell times. `t`: not falling, within one period; rows at one place
/// are a jump and no stretch; `period`: of the same unit, infinite: none, then nothing lies behind
/// the last row. Of an even number of stretches the median is the larger of the middle ones, so
/// that two are never told apart. Needs a row or more.
[[nodiscard]] std::vector<RowGap> row_gaps(const std::vector<double>& t, double period);

}  // namespace shellback::bearing
