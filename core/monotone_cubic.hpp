#pragma once
/// Piecewise cubic through given points that rises and falls only where they do.
///
/// Slopes at inner points are Fritsch and Butland's weighted harmonic means of the neighbouring
/// secants, 0 at a turn; an end's slope is given, or else the secant, and is limited to three
/// times the secant, within which the piece is monotone (Fritsch and Carlson). Value and slope are
/// continuous. Textbook.
#include <optional>
#include <vector>

namespace shellback {

/// A value and its derivative.
struct ValueAndSlope {
  double value;
  double slope;
};

class MonotoneCubic {
 public:
  MonotoneCubic() = default;
  /// `x` rises strictly; two or more points. `first` and `last`: slopes at the ends, if known.
  MonotoneCubic(std::vector<double> x, std::vector<double> y, std::optional<double> first = {},
                std::optional<double> last = {});

  /// Between the first and the last x; outside, the end piece is continued.
  [[nodiscard]] ValueAndSlope at(double x) const;

 private:
  std::vector<double> x_, y_, slope_;
};

}  // namespace shellback
