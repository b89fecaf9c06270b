#include "bearing/warm_up.hpp"

#include <algorithm>
#include <cmath>

#include "bearing/first_film.hpp"
#include "core/contract.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {

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
  SolidState state = s.model.solids->uniform_state(o.T_start);
  const SolidTemperature walls = s.model.solids->at(state);
  s.heat = cold_heat(s.model, o.T_start);
  s.heat.T_shell = walls.shell.surface;
  s.heat.T_shaft = walls.shaft.temperature;
  if (physics.thermal_deformation) s.heat.thermal_deformation = walls.thermal_deformation;
  s.T_film = c.supplies.front().temperature;
  out.end.verdict = first_film(s, s.T_film, control);
  if (!out.end.verdict.good()) return out;
  MarchOptions march;
  march.end = o.end;
  march.error = o.error;
  out.end =
      march_heat(s, state, march, control, [&](const Instant& i) { out.instants.push_back(i); });
  s.verdict = out.end.verdict;
  return out;
}

}  // namespace shellback::bearing
