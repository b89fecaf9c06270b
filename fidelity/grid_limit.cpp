#include "fidelity/grid_limit.hpp"

#include <algorithm>
#include <cmath>

namespace shellback::fidelity {
namespace {

constexpr double kFilmOrder = 1.3;    ///< [-]
constexpr double kSolidOrder = 2.0;   ///< [-]
constexpr double kStepBar = 1.6;      ///< bar over the step of (2) [-]
constexpr double kSteadyBar = 1.0;    ///< the same in a sequence that closes in [-]
constexpr double kClosing = 1.3;      ///< a step before at least this much larger closes in [-]
constexpr double kLeastRatio = 1.25;  ///< a smaller ratio than this is no refinement [-]
constexpr double kMostStep = 0.3;  ///< a step of (2) beyond this part of L1 is no extrapolation [-]

double gain(double ratio, double order) { return 1.0 / (std::pow(ratio, order) - 1.0); }

}  // namespace

GridLimit film_limit(double whole, double film, double ratio) {
  if (!std::isfinite(film)) return {whole, 0.0};
  const double step = film - whole;
  const double middle = gain(ratio, kFilmOrder);
  const double spread = std::max(gain(ratio, 1.0) - middle, middle - gain(ratio, 2.0));
  return {film + step * middle, spread * std::abs(step)};
}

GridLimit grid_limit(const GridLimit& coarse, const GridLimit& fine, double ratio, double before) {
  const double step = fine.value - coarse.value;
  const bool closing = step * before > 0.0 && std::abs(before) > kClosing * std::abs(step);
  const double further = step * gain(std::max(ratio, kLeastRatio), kSolidOrder);
  GridLimit out{fine.value, fine.bar + (closing ? kSteadyBar : kStepBar) * std::abs(further)};
  if (ratio >= kLeastRatio && std::abs(further) < kMostStep * std::abs(fine.value)) {
    out.value += further;
  }
  return out;
}

}  // namespace shellback::fidelity
