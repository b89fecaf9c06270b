#pragma once
/// Length of the next step in time from the error of the last one:
///   next/last = 0.9 (allowed/error)^(1/n), between 1/4 and 2                                  (1)
/// n the order of the error of one step. Where nothing is known but that a step was not found it is
/// a quarter as long; where steps must be powers of two, for factorised operators to serve again,
/// it is halved or doubled. Source: textbook (elementary step
/// control of one-step methods).
#include <algorithm>
#include <cmath>

namespace shellback {

inline constexpr double kStepLonger = 2.0;     ///< at most, over the last one [-]
inline constexpr double kStepShorter = 0.25;   ///< at least, and where a step is not found [-]
inline constexpr double kStepSafety = 0.9;     ///< of the length that the error allows [-]
inline constexpr double kStepOrder = 3.0;      ///< n of a method of second order [-]
inline constexpr double kStepOrderAnew = 2.0;  ///< n of first order: backward Euler, and a step of
                                               ///< the former that knows no slope before [-]
/// A step this part of the first one or of a period: below, nothing moves any more [-].
inline constexpr double kStepShortest = 1e-7;
/// Steps of a period or between two instants: a hundred times what a long cycle takes.
inline constexpr int kMostStepsInTime = 200000;

/// (1) of a step that was found; `anew`: it knew no slope before. Without an error: at most longer.
[[nodiscard]] inline double step_growth(double allowed, double error, bool anew) {
  if (!(error > 0.0)) return kStepLonger;
  const double part =
      kStepSafety * std::pow(allowed / error, 1.0 / (anew ? kStepOrderAnew : kStepOrder));
  return std::clamp(part, kStepShorter, kStepLonger);
}

}  // namespace shellback
