#include "bearing/warm_up.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/first_film.hpp"
#include "bearing/kept_run.hpp"
#include "bearing/march_members.hpp"
#include "core/contract.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

/// Film, heat and bodies at the start.
Verdict begin_warm_up(Solution& s, MarchStand& stand, double T, const SolveControl& control) {
  stand.bodies = s.model.solids->uniform_state(T);
  const SolidTemperature walls = s.model.solids->at(stand.bodies);
  s.heat = cold_heat(s.model, T);
  s.heat.T_shell = walls.shell.surface;
  s.heat.T_shaft = walls.shaft.temperature;
  if (s.model.physics.thermal_deformation) s.heat.thermal_deformation = walls.thermal_deformation;
  s.T_film = s.model.input.supplies.front().temperature;
  return first_film(s, s.T_film, control);
}

}  // namespace

double WarmUp::imbalance() const {
  double most = 0.0;
  for (const Instant& i : instants) {
    most = larger(most, std::abs(i.heat_in - i.heat_out - i.stored) / std::abs(i.heat_in));
  }
  return most;
}

WarmUp warm_up(const Case& c, Tier tier, const WarmUpOptions& o, const SolveControl& control) {
  if (tier != Tier::thd && tier != Tier::tehd) {
    throw InputError("model.tier",
                     "a transient follows the walls' temperatures, which only the tiers thd and "
                     "tehd have");
  }
  if (c.cycle) return warm_up_over_cycles(c, tier, o, control);
  WarmUp out;
  Solution& s = out.solution;
  const Physics physics = physics_of(c, tier);
  s.target = load_target(c);
  s.model = make_bearing(c, physics, c.model.grid);
  // Every harmonic computed: the march ends in the steady answer to round-off.
  const SolidEffects effects{physics.elastic, true, physics.thermal_deformation, true};
  s.model.solids = std::make_shared<const Solids>(c, s.model.scene.grid, effects);
  MarchStand stand;
  const auto members = [&](Tape& tape) { tape(out.instants, s, stand); };
  if (!take_up_noted(control.kept, members)) {
    out.end.verdict = begin_warm_up(s, stand, o.T_start, control);
    if (!out.end.verdict.good()) return out;
  }
  MarchOptions march;
  march.end = o.end;
  march.error = o.error;
  out.end = march_heat(s, stand, march, control, [&](const Instant& i) {
    out.instants.push_back(i);
    keep_between(control.kept, members);
  });
  keep_stopped(control.kept, out.end.verdict);
  s.verdict = out.end.verdict;
  return out;
}

}  // namespace shellback::bearing
