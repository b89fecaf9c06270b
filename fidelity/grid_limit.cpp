#include "fidelity/grid_limit.hpp"

#include <algorithm>
#include <cmath>

namespace shellback::fidelity {
namespace {

constexpr double kFilmOrder = 1.5;   ///< [-]
constexpr double kSolidOrder = 2.0;  ///< [-]
constexpr double kFilmBar = 1.5;     ///< bar over the spread of film orders [-]
constexpr double kFirstBar = 1.0;    ///< bar over |L1 - L0| of the first two grids [-]
constexpr double kStepBar = 0.7;     ///< the same of later ones [-]
constexpr double kMemory = 0.1;      ///< part of the step before that a bar still holds [-]
/// Between grids closer than this, what the cells happen to hold of edges and supplies changes as
/// much as what they resolve: their step has no direction to be led on in [-].
constexpr double kLeastRatio = 1.9;
constexpr double kMostStep = 0.3;  ///< a step of (2) beyond this part of L1 is no extrapolation [-]
/// Bar over what is told to lie beyond the fine grid: that is itself an extrapolation [-].
constexpr double kBeyondBar = 1.6;

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

GridLimit fine_limit(double coarse, double whole, int cells) {
  return {whole, 0.0, (whole - coarse) * onward(cells, kFineGrid[0], INFINITY, kFilmOrder)};
}

double full_bar(const GridLimit& l) { return l.bar + kBeyondBar * std::abs(l.beyond); }

GridLimit grid_limit(const GridLimit& coarse, const GridLimit& fine, int b0, int b1,
                     double before) {
  const double step = fine.value - coarse.value;
  const bool first = !std::isfinite(before);
  const double part = first ? kFirstBar : kStepBar;
  GridLimit out = fine;
  out.bar += part * std::abs(step) + (first ? 0.0 : kMemory * std::abs(before));
  if (b1 < kLeastRatio * b0) return out;
  const double to_fine = onward(b0, b1, kFineGrid[1], kSolidOrder);
  const double all = onward(b0, b1, INFINITY, kSolidOrder);
  if (std::abs(step * all) > kMostStep * std::abs(fine.value)) return out;
  out.value += step * to_fine;
  out.beyond += step * (all - to_fine);
  return out;
}

}  // namespace shellback::fidelity
