#include <algorithm>
#include <cmath>

#include "bearing/cycle_search.hpp"
#include "bearing/warm_up.hpp"
#include "core/contract.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

/// The bearing after a cycle and the bodies' time behind it.
Instant instant_after(const CycleSearch& search, const BodiesAnswer& bodies, double t, double dt) {
  const FilmGrid& g = search.film().model().scene.grid;
  CycleResult r;
  search.told().write(r);
  const thermal::EnergyBalance& film = search.heat().flows().balance;
  const double per_time = g.multiplicity() / search.heat().time();
  Instant i;
  i.t = t;
  i.dt = dt;
  i.torque = value_of(r, "friction_torque");
  i.h_min = value_of(r, "h_min");
  i.T_film_max = value_of(r, "T_film_max");
  i.T_shell_max = value_of(r, "T_shell_max");
  i.T_shell_back = area_mean(g, bodies.solids.shell.back);
  for (int j = 0; j < g.nz; ++j) i.T_shaft += bodies.walls.shaft[j] * g.dz[j];
  i.T_shaft /= g.z_face.back() - g.z_face.front();
  i.heat_in = search.heat().flows().work / search.heat().time();
  i.heat_out = per_time * (film.carried_out - film.carried_in) + bodies.solids.shell.heat_back +
               bodies.solids.shell.heat_ends + bodies.solids.shaft.heat_out;
  i.stored = bodies.solids.shell.stored + bodies.solids.shaft.stored + per_time * film.stored;
  if (!bodies.walls.thermal_deformation.empty())
    i.deformation = area_mean(g, bodies.walls.thermal_deformation);
  return i;
}

/// The film answers a wall that is warmer here and cooler there within two cycles, not at once, and
/// answers the walls before as well: taken at twice its strength the local answer does not
/// overshoot. Measured (big end, 48 x 5): once, a cell swings by 1.9 K for ever; twice, at rest
/// after 80 cycles.
thermal::WallResponse delayed(thermal::WallResponse r) {
  constexpr double kCycles = 2.0;
  r.shell_local *= kCycles;
  r.shell_ring *= kCycles;
  r.shaft_ring *= kCycles;
  return r;
}

double move_of(const WallMeans& a, const WallMeans& b) {
  return larger(largest_difference(a.shell, b.shell), largest_difference(a.shaft, b.shaft));
}

}  // namespace

WarmUp warm_up_over_cycles(const Case& c, Tier tier, const WarmUpOptions& o,
                           const SolveControl& control) {
  constexpr double kMost = 2.0;    // move of a wall until a cycle is passed again [K] (methods 3.5)
  constexpr double kStill = 0.05;  // what walls leave open where the cycle is periodic [K]
  constexpr double kLonger = 2.0;  // lengths are powers of two: operators serve again
  if (!c.cycle->repeats()) {
    throw InputError("load_cycle.period",
                     "a warm-up passes many cycles, and the case has a single event; give its "
                     "period");
  }
  WarmUp out;
  CycleSearch search(c, tier, control);
  search.begin(c.supplies.front().temperature);
  const BearingModel& model = search.film().model();
  out.solution.model = model;
  const Solids& solids = *model.solids;
  SolidState state = solids.uniform_state(o.T_start);
  const SolidTemperature cold = solids.at(state);
  WallMeans walls{cold.shell.surface, cold.shaft.temperature, Field(cold.shell.surface.size(), 0.0),
                  cold.thermal_deformation};
  const double shortest = c.cycle->length();
  double dt = shortest;
  SolidStep last;
  while (out.end.t < o.end) {
    if (!search.pass_between(walls)) {
      out.end.verdict = search.verdict();
      break;
    }
    const int nodes = search.film().heat()->skin().nodes();
    BodiesAnswer next;
    SolidStep step;
    double move = 0.0;
    for (double length = std::min(dt, o.end - out.end.t);; length /= kLonger) {
      step = solids.step(length, state, &last);
      next =
          answer_of_bodies(model, walls, search.heat(), delayed(search.response()), nodes, &step);
      move = move_of(next.walls, walls);
      dt = length;
      if (move <= kMost || length <= shortest) break;
    }
    state = solids.state(next.solids, &step);
    last = std::move(step);
    walls = next.walls;
    out.end.t += dt;
    out.instants.push_back(instant_after(search, next, out.end.t, dt));
    out.end.at_rest = dt >= 0.4 * out.end.t && move < kStill;
    if (out.end.at_rest) break;
    dt *= kLonger;  // halved again where it is too long: that costs no cycle
  }
  out.solution.verdict = out.end.verdict;
  return out;
}

}  // namespace shellback::bearing
