#include "bearing/cycle_lumped.hpp"

#include <cmath>

#include "bearing/bracketed_root.hpp"
#include "bearing/heat_endings.hpp"
#include "rheology/heat.hpp"

namespace shellback::bearing {

Verdict settle_lumped_cycle(CycleSearch& search, const Case& c) {
  constexpr double kFirstRise = 5.0;  // of the search upwards, doubled from try to try [K]
  const double T_supply = c.supplies.front().temperature;
  Verdict last;
  const auto unbalanced = [](double hottest) -> Verdict {
    return {Status::iteration_limit,
            ending::AtTemperature{ending::Thermal::unbalanced_cycle, hottest}};
  };
  const auto residual = [&](double T) {
    if (const auto known = search.remembered()) return known->front();
    if (!search.brought_back()) search.set_temperature(T);
    last = search.search(false);
    if (!last.good()) return double{NAN};
    const CycleMeans m = search.told().means();
    const double cp = rheology::heat_capacity(c.oil, 0.5 * (T + T_supply)).cp;
    const double r = T_supply + m.power / (m.side_mass_flow * cp) - T;
    search.remember({r});
    return r;
  };
  KnownPoint low{T_supply, residual(T_supply)};
  if (std::isnan(low.f)) return last;
  for (double rise = kFirstRise; std::abs(low.f) > kCycleBalance; rise *= 2.0) {
    if (rise > kHottestRise) return unbalanced(T_supply + kHottestRise);
    const KnownPoint high{T_supply + rise, residual(T_supply + rise)};
    if (std::isnan(high.f)) return last;
    if (high.f > 0.0) {
      low = high;
      continue;
    }
    if (!bracketed_root(residual, low, high, {kCycleBalance, kCycleBracket}).found && last.good()) {
      return unbalanced(high.x);
    }
    break;
  }
  return last;
}

}  // namespace shellback::bearing
