#pragma once
/// Measured points, and their residuals: r of (1) in study/bounded_fit.hpp.
///
///   r = (computed - measured)/deviation,   noise^2 = <(accuracy computed/deviation)^2>
#include <limits>
#include <string>
#include <vector>

namespace shellback::study {

/// A measured quantity at a point, SI.
struct MeasuredValue {
  std::string quantity;  ///< of bearing/quantities.hpp
  double value = 0.0;
  double deviation = std::numeric_limits<double>::quiet_NaN();  ///< standard; NaN: not known
};

struct MeasuredPoint {
  std::string name;   ///< "data.csv:4, speed = 300 rpm"
  std::string curve;  ///< points that follow one another have one name here
  std::vector<MeasuredValue> values;
};

/// Values of every point, in the order of the measured ones; none of points that are left out.
using PointValues = std::vector<std::vector<double>>;

/// Deviation of every measured value; those that are not known are all the measured root mean
/// square, so that chi2 is of relative squares. Of all points, left out or not.
[[nodiscard]] PointValues deviations_of(const std::vector<MeasuredPoint>& measured);
[[nodiscard]] bool deviations_known(const std::vector<MeasuredPoint>& measured);

/// r, of the points that are used, one behind the other [-].
[[nodiscard]] std::vector<double> residuals_of(const std::vector<MeasuredPoint>& measured,
                                               const PointValues& deviations,
                                               const PointValues& computed);

/// What r is uncertain by because values are computed to a relative `accuracy`: root mean square
/// [-]; 0 if there are none.
[[nodiscard]] double noise_of(const PointValues& deviations, const PointValues& computed,
                              double accuracy);

}  // namespace shellback::study
