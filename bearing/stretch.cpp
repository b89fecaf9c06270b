#include "bearing/stretch.hpp"

#include <algorithm>

#include "bearing/first_film.hpp"

namespace shellback::bearing {
namespace {

MarchEnd over_cycles(const Case& c, Tier tier, const WarmUpOptions& o, StretchEnd ends,
                     const SolveControl& control, CarriedOver& carried, Solution& last,
                     const std::function<void(const Instant&)>& tell) {
  constexpr double kSteps = 16.0;  // of a stretch at least: see the header
  CycleSearch search(c, tier, control);
  search.begin(c.supplies.front().temperature);
  last.model = search.film().model();
  if (!carried.bodies) carried.bodies = uniform_bodies(*last.model.solids, o.T_start);
  MarchSpan span;
  span.duration = o.end;
  span.first = span.shortest = c.cycle->length();
  span.until_rest = ends == StretchEnd::at_rest;
  if (!span.until_rest) span.longest = std::max(span.shortest, o.end / kSteps);
  // The orbit is found before its heat counts.
  MarchEnd end;
  if (!search.pass_between(carried.bodies->walls)) {
    end.verdict = search.verdict();
    return end;
  }
  return march_over_cycles(search, span, *carried.bodies, tell);
}

MarchEnd steadily_loaded(const Case& c, Tier tier, const WarmUpOptions& o,
                         const SolveControl& control, CarriedOver& carried, Solution& s,
                         const std::function<void(const Instant&)>& tell) {
  const Physics physics = physics_of(c, tier);
  s.target = load_target(c);
  s.model = make_bearing(c, physics, c.model.grid);
  if (!carried.solids) {
    // Every harmonic computed: a march ends in the steady answer to round-off.
    const SolidEffects effects{physics.elastic, true, physics.thermal_deformation, true};
    carried.solids = std::make_shared<const Solids>(c, s.model.scene.grid, effects);
    carried.bodies = uniform_bodies(*carried.solids, o.T_start);
  }
  s.model.solids = carried.solids;
  const SolidTemperature walls = s.model.solids->at(carried.bodies->state);
  s.heat = cold_heat(s.model, o.T_start);
  s.heat.T_shell = walls.shell.surface;
  s.heat.T_shaft = walls.shaft.temperature;
  if (physics.thermal_deformation) s.heat.thermal_deformation = walls.thermal_deformation;
  s.T_film = c.supplies.front().temperature;
  MarchEnd end;
  end.verdict = first_film(s, s.T_film, control);
  if (!end.verdict.good()) return end;
  MarchOptions march;
  march.end = o.end;
  march.error = o.error;
  return march_heat(s, carried.bodies->state, march, control, tell);
}

}  // namespace

MarchEnd pass_stretch(const Case& c, Tier tier, const WarmUpOptions& options, StretchEnd ends,
                      const SolveControl& control, CarriedOver& carried, Solution& last,
                      const std::function<void(const Instant&)>& tell) {
  return c.cycle ? over_cycles(c, tier, options, ends, control, carried, last, tell)
                 : steadily_loaded(c, tier, options, control, carried, last, tell);
}

}  // namespace shellback::bearing
