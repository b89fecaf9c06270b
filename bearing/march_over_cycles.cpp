#include "bearing/march_over_cycles.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "bearing/step_control.hpp"
#include "core/largest.hpp"

namespace shellback::bearing {
namespace {

/// The bearing after the bodies' time and a cycle between the walls to which it has led.
Instant instant_after(const CycleSearch& search, const BodiesAnswer& bodies, double t, double dt) {
  const FilmGrid& g = search.film().model().domain.grid;
  CycleResult r;
  search.told().write(r);
  const double per_time = g.multiplicity() / search.heat().time();
  Instant i;
  i.t = t;
  i.dt = dt;
  i.torque = value_of(r, "friction_torque");
  i.h_min = value_of(r, "h_min");
  i.T_film_max = value_of(r, "T_film_max");
  i.T_shell_max = value_of(r, "T_shell_max");
  i.heat_in = search.heat().flows().work / search.heat().time();
  tell_bodies(g, bodies.solids, search.heat().flows().balance, per_time,
              bodies.walls.thermal_deformation, i);
  return i;
}

/// The film answers a wall that is warmer here and cooler there within two cycles, not at once, and
/// answers the walls before as well: taken at twice its strength the local answer does not
/// overshoot. Measured (big end, 48 x 5): once, a cell swings by 1.9 K for ever; twice, at rest
/// after 80 cycles.
thermal::WallResponse delayed(thermal::WallResponse r) {
  r.shell_local *= kCyclesOfAnswer;
  r.shell_ring *= kCyclesOfAnswer;
  r.shaft_ring *= kCyclesOfAnswer;
  return r;
}

Field difference(const Field& a, const Field& b) {
  Field d = a;
  for (std::size_t c = 0; c < d.size(); ++c) d[c] -= b[c];
  return d;
}

/// True if the bore moves back from where it came by the step before.
bool turns_back(const Field& before, const Field& now) {
  return !before.empty() &&
         std::inner_product(before.begin(), before.end(), now.begin(), 0.0) < 0.0;
}

double move_of(const WallMeans& a, const WallMeans& b) {
  return larger(largest_difference(a.shell, b.shell), largest_difference(a.shaft, b.shaft));
}

}  // namespace

Bodies uniform_bodies(const Solids& solids, double T) {
  Bodies b{solids.uniform_state(T), {}};
  const SolidTemperature cold = solids.at(b.state);
  b.walls = {cold.shell.surface, cold.shaft.temperature, Field(cold.shell.surface.size(), 0.0),
             cold.thermal_deformation};
  return b;
}

MarchEnd march_over_cycles(CycleSearch& search, const MarchSpan& span, CycleMarch& march,
                           const std::function<void(const Instant&)>& tell) {
  constexpr double kMost = 2.0;    // move of a wall until a cycle is passed again [K] (methods 3.5)
  constexpr double kStill = 0.05;  // what walls leave open where the cycle is periodic [K]
  const BearingModel& model = search.film().model();
  const Solids& solids = *model.solids;
  auto& [bodies, end, dt, moved] = march;
  const auto passed = [&] {
    if (!search.pass_between(bodies.walls)) end.verdict = search.verdict();
    return end.verdict.good();
  };
  if (dt == 0.0) {
    dt = span.first;
    if (!passed()) return end;
  }
  SolidStep last;
  while (end.t < span.duration && !(end.at_rest && span.until_rest)) {
    const int nodes = search.film().heat()->skin().nodes();
    BodiesAnswer next;
    SolidStep step;
    double move = 0.0;
    for (double length = std::min({dt, span.longest, span.duration - end.t});;
         length /= kStepLonger) {
      step = solids.step(length, bodies.state, &last);
      next = answer_of_bodies(model, bodies.walls, search.heat(), delayed(search.response()), nodes,
                              &step);
      move = move_of(next.walls, bodies.walls);
      dt = length;
      if (move <= kMost || length <= span.shortest) break;
    }
    bodies.state = solids.state(next.solids, &step);
    last = std::move(step);
    const Field move_now = difference(next.walls.shell, bodies.walls.shell);
    const bool back = turns_back(std::exchange(moved, move_now), move_now);
    bodies.walls = next.walls;
    end.t += dt;
    if (!passed() || (back && !passed())) return end;
    const Instant instant = instant_after(search, next, end.t, dt);
    end.at_rest = dt >= 0.4 * end.t && move < kStill;
    dt *= kStepLonger;  // halved again where it is too long: that costs no cycle
    tell(instant);
  }
  return end;
}

}  // namespace shellback::bearing
