#pragma once
/// Order of accuracy seen on refined grids, and the value they point to.
#include <cmath>

namespace shellback::test {

/// Order from the errors of two grids whose cell sizes differ by `ratio` (coarse over fine) [-].
[[nodiscard]] inline double order_of_errors(double coarse, double fine, double ratio = 2.0) {
  return std::log(std::abs(coarse / fine)) / std::log(ratio);
}

/// Order from the values of three grids, each `ratio` finer than the one before [-].
[[nodiscard]] inline double observed_order(double coarse, double medium, double fine,
                                           double ratio = 2.0) {
  return order_of_errors(coarse - medium, medium - fine, ratio);
}

/// Value at vanishing cell size from two grids if the error falls with `order` (Richardson).
[[nodiscard]] inline double richardson(double coarse, double fine, double order = 2.0,
                                       double ratio = 2.0) {
  return fine + (fine - coarse) / (std::pow(ratio, order) - 1.0);
}

}  // namespace shellback::test
