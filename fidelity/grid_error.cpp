#include "fidelity/grid_error.hpp"

#include <algorithm>
#include <cmath>

#include "core/bracketed_root.hpp"
#include "core/round_off.hpp"
#include "fidelity/grid_sequence.hpp"

namespace shellback::fidelity {
namespace {

/// F of (4).
double safety(double h) { return kSafety * std::sqrt(std::max(1.0, h * std::sqrt(200.0 * 25.0))); }

/// Part of the change between the two coarser of three grids that the next change is.
double next_change(const GridValue& f3, const GridValue& f2, const GridValue& f1, double p) {
  return onward(1.0 / f3.h, 1.0 / f2.h, 1.0 / f1.h, p);
}

/// Whether three values move on in one direction with steps that fall slower than with kSlowOrder.
/// Grids that are nearer to each other than halved ones cannot tell that from chance.
bool moves_on(const GridValue& f3, const GridValue& f2, const GridValue& f1) {
  const double halved = std::sqrt(2.0 * kRefinement);  // between the refinements there are
  if (f2.h < halved * f1.h || f3.h < halved * f2.h) return false;
  const double before = f3.value - f2.value, last = f2.value - f1.value;
  return last / before > next_change(f3, f2, f1, kSlowOrder);
}

}  // namespace

double onward(double m, double n, double end, double p) {
  const auto error = [p](double cells) { return std::pow(cells, -p); };
  if (n >= end || n <= m) return 0.0;
  return (error(n) - error(end)) / (error(m) - error(n));
}

double observed_order(const std::vector<GridValue>& v) {
  if (v.size() < 3) return NAN;
  const GridValue &f3 = v[v.size() - 3], &f2 = v[v.size() - 2], &f1 = v[v.size() - 1];
  const double before = f3.value - f2.value, last = f2.value - f1.value;
  if (last == 0.0) return kMostOrder;
  const auto short_of = [&](double p) { return next_change(f3, f2, f1, p) - last / before; };
  if (!(last / before >= 0.0) || short_of(kSlowOrder) < 0.0) return NAN;
  if (short_of(kLeastOrder) <= 0.0) return kLeastOrder;
  if (short_of(kMostOrder) >= 0.0) return kMostOrder;
  return root_between(short_of, kLeastOrder, kMostOrder, kRoundOff);
}

GridBar grid_bar(const std::vector<GridValue>& v, double h) {
  if (v.size() < 2) return {NAN, NAN, NAN};
  const GridValue &f2 = v[v.size() - 2], &f1 = v[v.size() - 1];
  double d = std::abs(f2.value - f1.value);
  const auto rest = [&](double p) {
    return d * onward(1.0 / f2.h, 1.0 / f1.h, INFINITY, p) * std::pow(h / f1.h, p);
  };
  double slow = 0.0;
  if (v.size() > 2) {
    const GridValue& f3 = v[v.size() - 3];
    d = std::max(d, std::abs(f3.value - f2.value) * next_change(f3, f2, f1, kMostOrder));
    if (moves_on(f3, f2, f1)) slow = kSafety * rest(kSlowOrder);
  }
  const double observed = observed_order(v);
  const double p = std::isfinite(observed) ? observed : kLeastOrder;
  const double limit =
      v.size() == 2 || std::isfinite(observed)
          ? f1.value + (f1.value - f2.value) * onward(1.0 / f2.h, 1.0 / f1.h, INFINITY, kMostOrder)
          : NAN;
  return {std::max(safety(h) * rest(p), slow) + f1.noise, observed, limit};
}

void share_bars(const std::vector<BarOfSize>& bars) {
  constexpr double kShare = 0.2;  // [-]
  std::vector<double> relative;
  for (const auto& [bar, size, part] : bars) {
    if (!part && std::isfinite(*bar / size)) relative.push_back(*bar / size);
  }
  if (relative.empty()) return;
  const auto middle = relative.begin() + static_cast<long>(relative.size() / 2);
  std::nth_element(relative.begin(), middle, relative.end());
  for (const auto& [bar, size, part] : bars) {
    if (std::isfinite(*bar)) *bar = std::max(*bar, kShare * *middle * size);
  }
}

GridLimit film_limit(double whole, double film, int cells, int film_cells) {
  if (!std::isfinite(film)) return {whole, 0.0, 0.0};
  const double step = film - whole;
  const double slow = onward(cells, film_cells, kFineGrid[0], kLeastOrder);
  const double fast = onward(cells, film_cells, kFineGrid[0], kMostOrder);
  const double all = onward(cells, film_cells, INFINITY, kLeastOrder);
  return {film + 0.5 * (slow + fast) * step, (slow - fast) * std::abs(step),
          (all - slow) * std::abs(step)};
}

GridLimit grid_limit(const GridLimit& coarse, const GridLimit& fine, int b0, int b1) {
  const double step = fine.value - coarse.value;
  const double slow = onward(b0, b1, kFineGrid[1], kLeastOrder);
  const double fast = onward(b0, b1, kFineGrid[1], kMostOrder);
  const double all = onward(b0, b1, INFINITY, kLeastOrder);
  return {fine.value + fast * step, fine.bar + (1.0 + fast) * std::abs(step),
          fine.beyond + (all - slow) * std::abs(step)};
}

}  // namespace shellback::fidelity
