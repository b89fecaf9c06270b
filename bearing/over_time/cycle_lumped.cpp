#include "bearing/over_time/cycle_lumped.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/heat/film_heat.hpp"
#include "bearing/heat/heat_endings.hpp"
#include "core/bracketed_root.hpp"
#include "rheology/heat.hpp"
#include "rheology/viscosity.hpp"

namespace shellback::bearing {

Verdict settle_lumped_cycle(CycleSearch& search, const Case& c) {
  const auto [coldest, hottest] = supply_temperatures(c);
  Verdict last;
  const auto unbalanced = [](double T) -> Verdict {
    return {Status::iteration_limit, ending::AtTemperature{ending::Thermal::unbalanced_cycle, T}};
  };
  const auto residual = [&](double T) {
    if (const auto known = search.answers().next()) return known->front();
    if (!search.brought_back()) search.set_temperature(T);
    last = search.search(false);
    if (!last.good()) return double{NAN};
    const CycleMeans m = search.told().means();
    const OilFed fed = oil_fed(c, search.film().model().supply.touching, m.fed);
    if (!(m.side_mass_flow > 0.0 && fed.mass > 0.0)) {
      last = c.cycle->repeats()
                 ? Verdict{Status::no_steady_state, ending::Plain::no_oil_leaves}
                 : Verdict{Status::iteration_limit, ending::Plain::no_oil_over_event};
      return double{NAN};
    }
    const double cp = rheology::heat_capacity(c.oil, 0.5 * (T + fed.T)).cp;
    const double r = fed.T + m.power / (fed.mass * cp) - T;
    search.answers().add({r});
    return r;
  };
  KnownPoint low{coldest, residual(coldest)};
  if (std::isnan(low.f)) return last;
  if (low.f < -kCycleBalance) return unbalanced(coldest);  // the film would make cold
  const double by_T = -rheology::viscosity_slopes(c.oil, coldest, 0.0, 0.0).dln_dT;
  double slope = -1.0 - by_T * low.f;  // of heat over flow that goes with the viscosity
  while (low.f > kCycleBalance) {
    const double T = low.x - low.f / std::min(slope, -1.0);
    if (T - hottest > kHottestRise) return unbalanced(hottest + kHottestRise);
    const KnownPoint next{T, residual(T)};
    if (std::isnan(next.f)) return last;
    if (next.f < 0.0) {
      const BracketOptions options{kCycleBalance, kCycleBracket};
      const bool found = bracketed_root(residual, low, next, options).found;
      return found || !last.good() ? last : unbalanced(next.x);
    }
    slope = (next.f - low.f) / (next.x - low.x);
    low = next;
  }
  return last;
}

}  // namespace shellback::bearing
