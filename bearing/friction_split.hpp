#pragma once
/// What steady bearings and load cycles share when friction of two solutions is compared.
#include <cmath>
#include <functional>
#include <vector>

#include "bearing/result.hpp"
#include "core/bracketed_root.hpp"

namespace shellback::bearing {

/// Friction torque by its origin [N m]; NaN: not known.
struct Torque {
  double viscous = NAN;
  double asperity = NAN;
  [[nodiscard]] double total() const { return viscous + asperity; }
};

/// Closes the steps of viscous torque from `start` to `end` by the share of asperities. Where one
/// of them is not known (it has no steady state, or its cycle was not found) only what is known
/// stays: all of them together.
void close_split(const Torque& start, const Torque& end, FrictionSplit& split);

/// From the guess of the calibrated temperature, to either side [K].
inline constexpr double kCalibrationReach = 32.0;

/// Film temperature at which the isothermal `torque` [N m] (of a film temperature [K]; NaN: no film
/// was found) is the `wanted` one, searched from `guess` within kCalibrationReach, first where a
/// full film has the friction that is wanted; none if there is none, or `torque` is NaN on the way.
[[nodiscard]] Calibration calibrate(const std::function<double(double)>& torque, double wanted,
                                    double guess, const BracketOptions& options);

}  // namespace shellback::bearing
