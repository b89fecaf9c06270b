#include "fidelity/grid_limit.hpp"

#include <algorithm>
#include <cmath>

namespace shellback::fidelity {
namespace {

constexpr double kFilmOrder = 1.3;    ///< [-]
constexpr double kSolidOrder = 2.0;   ///< [-]
constexpr double kFilmBar = 1.0;      ///< bar over the spread of film orders [-]
constexpr double kStepBar = 1.0;      ///< bar over the step of (2) [-]
constexpr double kSteadyBar = 1.0;    ///< the same in a sequence that closes in [-]
constexpr double kLeastPart = 0.35;   ///< of |L1 - L0| that a bar is reckoned from at least [-]
constexpr double kClosing = 2.0;      ///< a step before at least this much larger closes in [-]
constexpr double kLeastRatio = 1.25;  ///< a smaller ratio than this is no refinement [-]
constexpr double kMostStep = 0.3;  ///< a step of (2) beyond this part of L1 is no extrapolation [-]

}  // namespace

double onward(double m, double n, double end, double p) {
  const auto error = [p](double cells) { return std::pow(cells, -p); };
  if (n >= end || n <= m) return 0.0;
  return (error(n) - error(end)) / (error(m) - error(n));
}

GridLimit film_limit(double whole, double film, int cells, int film_cells) {
  if (!std::isfinite(film)) return {whole, 0.0, 0.0};
  const double step = film - whole;
  const auto to_fine = [&](double p) { return onward(cells, film_cells, kFineGrid[0], p); };
  const double middle = to_fine(kFilmOrder);
  const double spread = std::max(to_fine(1.0) - middle, middle - to_fine(2.0));
  const double all = onward(cells, film_cells, INFINITY, kFilmOrder);
  return {film + step * middle, kFilmBar * spread * std::abs(step), step * (all - middle)};
}

GridLimit grid_limit(const GridLimit& coarse, const GridLimit& fine, int b0, int b1,
                     double before) {
  const double step = fine.value - coarse.value;
  const bool closing = std::abs(before) > kClosing * std::abs(step);
  const bool refined = b1 >= kLeastRatio * b0;
  const double part = refined ? onward(b0, b1, kFineGrid[1], kSolidOrder) : 0.0;
  const double all = refined ? onward(b0, b1, INFINITY, kSolidOrder) : 0.0;
  GridLimit out = fine;
  out.bar += (closing ? kSteadyBar : kStepBar) * std::max(part, kLeastPart) * std::abs(step);
  if (std::abs(step * part) < kMostStep * std::abs(fine.value)) out.value += step * part;
  if (std::abs(step * all) < kMostStep * std::abs(fine.value)) out.beyond += step * (all - part);
  return out;
}

}  // namespace shellback::fidelity
