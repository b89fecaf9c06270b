#pragma once
/// Autocorrelation of the heights, and what it says of orientation and size.
///
///   R(s, t) = <z(x, y) z(x + s, y + t)>/Rq^2     over the part of the patch that overlaps itself
///
/// Correlation length of a direction: the distance at which R has fallen to 0.5 (Patir and Cheng's
/// lambda_0.5). Peklenik's gamma is that along the motion over that across. The lay is the
/// direction of the longest one. Lengths beyond half the patch are not known: the half is then a
/// lower bound, and the lay that of them in which R is highest there. Textbook.
///
/// Independent areas. The relative standard error of Rq is sqrt((Rku - 1)/(4 N)), 1/sqrt(2 N) of
/// Gaussian heights (and no less: a small patch tells a smaller Rku than it has), N = A/int R^2 dA;
/// with R
/// that falls to a half at lambda, int R^2 dA = k lambda_long lambda_short: k = 2.27 for
/// R = exp(-ln2 (r/lambda)^2), 3.27 for exp(-ln2 r/lambda). The first is used: N is then an
/// estimate, good to a factor of 1.5, and at most the number of points.
#include <array>

#include "surface/height_map.hpp"

namespace shellback::surface {

struct CorrelationLength {
  double length = 0.0;    ///< [m]
  bool at_least = false;  ///< the patch is too short: a lower bound
  double R = 0.5;         ///< there [-]
};

struct Correlation {
  CorrelationLength along, across;  ///< of the motion
  double gamma = 1.0;               ///< along over across [-]
  CorrelationLength longest, shortest;
  double lay = 0.0;          ///< angle of the longest from the motion, (-pi/2, pi/2] [rad]
  double independent = 0.0;  ///< N, number of independent areas [-]

  /// Relative standard error of Rq that the size of the patch leaves, heights of `kurtosis` Rku
  /// [-].
  [[nodiscard]] double error_of_Rq(double kurtosis) const;
  /// gamma is only known from above or below.
  [[nodiscard]] bool bounded() const { return along.at_least || across.at_least; }
};

/// Of a map without holes.
[[nodiscard]] Correlation correlation_of(const HeightMap& map);

/// Number of independent areas for a relative standard error of Rq, heights of `kurtosis` Rku.
[[nodiscard]] double independent_areas_for(double error_of_Rq, double kurtosis);

/// Sides of a patch, in correlation lengths, that holds so many independent areas.
[[nodiscard]] double lengths_for(double independent);

}  // namespace shellback::surface
