#include "bearing/over_time/compare_cycles.hpp"

#include <cmath>

#include "bearing/friction_split.hpp"
#include "bearing/over_time/cycle_endings.hpp"
#include "bearing/over_time/cycle_lumped.hpp"

namespace shellback::bearing {
namespace {

Torque torque_of(const CycleResult& r) {
  const double asperity = value_of(r, "friction_torque_asperity");
  return {value_of(r, "friction_torque") - asperity, asperity};
}

Torque torque_of(const CycleSearch& s) {
  if (!s.verdict().good()) return {};
  const CycleMeans m = s.told().means();
  return {m.torque - m.torque_asperity, m.torque_asperity};
}

/// Film temperatures solved between walls that are held.
Torque between_walls(const Case& c, Tier tier, bool thermal_deformation, bool elastic,
                     const WallMeans& walls, double T, const SolveControl& control) {
  Physics physics = physics_of(c, tier);
  physics.elastic = elastic;
  physics.thermal_deformation = thermal_deformation;
  WallMeans held = walls;
  if (!thermal_deformation) held.thermal_deformation.clear();
  CycleSearch search(c, tier, physics, control);
  search.begin_between(held, T);
  search.search(false);
  return torque_of(search);
}

void split_friction(const Case& c, const CycleResult& isothermal, const CycleResult& full,
                    CycleSearch& at_one_temperature, const SolveControl& control,
                    FrictionSplit& split) {
  const Torque start = torque_of(isothermal);
  const Torque end = torque_of(full);
  split.from = start.total();
  split.to = end.total();
  const double T = value_of(full, "T_film_mean");
  at_one_temperature.set_temperature(T);
  at_one_temperature.search(false);
  const Torque level = torque_of(at_one_temperature);
  const bool elastic = physics_of(c, Tier::isothermal).elastic;
  const Physics whole = physics_of(c, full.tier);
  const Torque variation = between_walls(c, full.tier, false, elastic, *full.walls, T, control);
  const bool last = elastic == whole.elastic;  // thermal deformation is all that is left
  const Torque clearance =
      !whole.thermal_deformation ? variation
      : last                     ? end
             : between_walls(c, full.tier, true, elastic, *full.walls, T, control);
  split.steps = {{"viscosity level", level.viscous - start.viscous},
                 {"viscosity variation", variation.viscous - level.viscous},
                 {"clearance", clearance.viscous - variation.viscous}};
  if (!last) split.steps.push_back({"elasticity", end.viscous - clearance.viscous});
  close_split(start, end, split);
}

/// The film temperature at which the mean torque of isothermal cycles is `wanted`.
Calibration calibrate_cycles(CycleSearch& search, double wanted, double guess) {
  const auto torque = [&](double T) {
    search.set_temperature(T);
    return search.search(false).good() ? search.told().means().torque : double{NAN};
  };
  // No better than cycles close.
  return calibrate(torque, wanted, guess, {kClosed * std::abs(wanted), kCycleBracket});
}

}  // namespace

CycleComparison compare_cycles(const Case& c, const std::vector<Tier>& tiers,
                               const SolveControl& control, const SolveCycle& solve) {
  CycleComparison out;
  std::optional<CycleResult> isothermal, full;
  for (const Tier tier : tiers) {
    Case one = c;
    one.model.tier = tier;
    CycleResult r = solve(one);
    out.sums.results.push_back(as_result(r));
    const bool good = r.verdict.good();
    const bool interrupted = r.verdict.status == Status::interrupted;
    if (good && tier == Tier::isothermal) isothermal = r;
    if (good && r.walls) full = r;
    out.cycles.push_back(std::move(r));
    if (interrupted) return out;  // what is finished is kept
  }
  if (!isothermal || !full) return out;
  const double T = value_of(*full, "T_film_mean");
  CycleSearch one(c, Tier::isothermal, control);
  one.begin(T);
  split_friction(c, *isothermal, *full, one, control, out.sums.split);
  out.sums.calibration = calibrate_cycles(one, out.sums.split.to, T);
  return out;
}

}  // namespace shellback::bearing
