#include "bearing/over_time/march_over_cycles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/largest.hpp"
#include "core/step_control.hpp"

namespace shellback::bearing {
namespace {

/// The bearing after the bodies' time and a cycle between the walls to which it has led.
Instant instant_after(const CyclePasses& passes, const BodiesAnswer& bodies, double t, double dt) {
  const FilmGrid& g = passes.film().model().domain.grid;
  CycleResult r;
  passes.told().write(r);
  const double per_time = g.multiplicity() / passes.heat().time();
  Instant i;
  i.t = t;
  i.dt = dt;
  i.torque = value_of(r, "friction_torque");
  i.h_min = value_of(r, "h_min");
  i.T_film_max = value_of(r, "T_film_max");
  i.T_shell_max = value_of(r, "T_shell_max");
  i.heat_in = passes.heat().flows().work / passes.heat().time();
  tell_bodies(g, bodies.solids, passes.heat().flows().balance, per_time,
              bodies.walls.thermal_deformation, i);
  return i;
}

/// Cycles between walls that have moved, until what the film stores over one is a small part of the
/// heat that it makes: oil that still warms with its walls keeps heat from them; counted where in
/// the last one that is no small part of what is told as stored. False, with the verdict: one did
/// not end.
bool let_film_follow(CyclePasses& passes, const WallMeans& walls, MarchEnd& end) {
  constexpr double kFollowed = 0.0002;  // of the heat made: else walls swing about the film's lag
  constexpr double kCounted = 0.005;    // of it
  constexpr int kPasses = 4;            // oil that gathers slowly is the cycle's own [-]
  const double sides = passes.film().model().domain.grid.multiplicity();
  double stored = INFINITY;  // of the heat made [-]
  for (int k = 0; k < kPasses && stored > kFollowed; ++k) {
    if (!passes.pass_between(walls)) {
      end.verdict = passes.verdict();
      return false;
    }
    const HeatFlows& flows = passes.heat().flows();
    stored = sides * std::abs(flows.balance.stored / flows.work);
  }
  if (stored > kCounted) ++end.unfollowed;
  return true;
}

/// To the surroundings [W].
HeatTaken lost_by(const SolidTemperature& solids) {
  return {solids.shell.heat_back + solids.shell.heat_ends, solids.shaft.heat_out};
}

/// What a body is owed more after a step of dt, which has taken `made` from a gain that was `begin`
/// and now is `end` [W]; where it has left little of that the body has forgotten the rest.
void add_owed(double dt, double begin, double made, double end, double& owed) {
  owed += dt * (mean_that_dies_away(begin, end) - made);
  owed *= begin != 0.0 ? std::clamp(made / begin, 0.0, 1.0) : 0.0;
}

/// Debts of shell and shaft after a step of dt between cycles that gave them `before` and `after`
/// [W].
void keep_accounts(double dt, const HeatTaken& before, const HeatTaken& after,
                   const SolidTemperature& solids, CycleMarch& march) {
  const HeatTaken lost = lost_by(solids);
  const bool begins = !std::isfinite(march.lost.shell);
  const HeatTaken was = begins ? lost : march.lost;
  const double shell = solids.shell.heat_in - lost.shell, shaft = solids.shaft.heat_in - lost.shaft;
  add_owed(dt, begins ? shell : before.shell - was.shell, shell, after.shell - lost.shell,
           march.owed.shell);
  add_owed(dt, begins ? shaft : before.shaft - was.shaft, shaft, after.shaft - lost.shaft,
           march.owed.shaft);
  march.lost = lost;
}

double move_of(const WallMeans& a, const WallMeans& b) {
  return larger(largest_difference(a.shell, b.shell), largest_difference(a.shaft, b.shaft));
}

/// By how much the heat of the last cycle, for ever, would move a wall [K]. Of oil that thinned as
/// far as that it would be no measure of rest: such walls are off by 1/|d ln eta/dT| from the first
/// cycle on, which grows as oil warms.
double move_for_ever(const CyclePasses& passes, const WallMeans& walls) {
  const int nodes = passes.film().heat()->skin().nodes();
  const BodiesAnswer then =
      answer_of_bodies(passes.film().model(), walls, passes.heat(), passes.response(), nodes,
                       nullptr, {}, OilAnswers::not_at_all);
  return then.left + move_of(then.walls, walls);
}

/// A step of the bodies.
struct BodiesStep {
  double length = 0.0;  ///< [s]
  SolidStep step;
  BodiesAnswer answer;
  double move = 0.0;  ///< of a wall [K]
};

/// The step of `length` or, where that may be, halves of it until no wall moves too far.
BodiesStep take_step(const CyclePasses& passes, const MarchSpan& span, const CycleMarch& march,
                     const SolidStep& last, double length) {
  const BearingModel& model = passes.film().model();
  const int nodes = passes.film().heat()->skin().nodes();
  const double pays = march.dt / kStepLonger;  // the step before: what it owes is paid no faster
  for (;; length /= kStepLonger) {
    BodiesStep taken{length, model.solids->step(length, march.bodies.state, &last), {}, 0.0};
    taken.answer = answer_of_bodies(
        model, march.bodies.walls, passes.heat(), passes.response(), nodes, &taken.step,
        {march.owed.shell / std::max(length, pays), march.owed.shaft / std::max(length, pays)},
        OilAnswers::not_at_all);
    taken.move = move_of(taken.answer.walls, march.bodies.walls);
    if (!span.steps.empty() || taken.move <= span.move || length <= span.shortest) return taken;
  }
}

/// Twice the step, which is halved again where it is too long: that costs no cycle. Half of it
/// where it has left more than it found: it was too long for the cycle's heat to stand over it.
/// True where such steps do not lead to rest.
bool change_step(double left, const MarchSpan& span, CycleMarch& march) {
  constexpr int kMostRises = 20;  // of what is left
  const bool rose = left > march.left;
  if (rose) ++march.rises;
  const bool lost = march.dt > kEndless || march.rises > kMostRises;
  march.left = left;
  march.dt = rose ? std::max(span.shortest, march.dt / kStepLonger) : kStepLonger * march.dt;
  return lost;
}

}  // namespace

double mean_that_dies_away(double begin, double end) {
  if (!(begin * end > 0.0)) return end;
  const double x = begin / end - 1.0;
  return x > 0.0 ? begin * -std::expm1(-x) / x : 0.5 * (begin + end);
}

Bodies uniform_bodies(const Solids& solids, double T) {
  Bodies b{solids.uniform_state(T), {}};
  const SolidTemperature cold = solids.at(b.state);
  b.walls = {cold.shell.surface, cold.shaft.temperature, Field(cold.shell.surface.size(), 0.0),
             cold.thermal_deformation};
  return b;
}

MarchEnd march_over_cycles(CyclePasses& passes, const MarchSpan& span, CycleMarch& march,
                           const std::function<void(const Instant&)>& tell) {
  constexpr double kStill = 0.05;  // what walls leave open where the cycle is periodic [K]
  const Solids& solids = *passes.film().model().solids;
  const bool given = !span.steps.empty();
  Bodies& bodies = march.bodies;
  MarchEnd& end = march.end;
  double& dt = march.dt;
  if (dt == 0.0) {
    dt = span.shortest;
    if (!let_film_follow(passes, bodies.walls, end)) return end;
  }
  SolidStep last;
  const auto goes_on = [&](std::size_t k) {
    return given ? k < span.steps.size()
                 : end.t < span.duration && !(end.at_rest && span.until_rest);
  };
  for (std::size_t k = 0; goes_on(k); ++k) {
    const HeatTaken before = passes.told().heat_taken();
    BodiesStep taken =
        take_step(passes, span, march, last,
                  given ? span.steps[k] : std::min({dt, span.longest, span.duration - end.t}));
    const BodiesAnswer& next = taken.answer;
    dt = taken.length;
    bodies.state = solids.state(next.solids, &taken.step);
    last = std::move(taken.step);
    bodies.walls = next.walls;
    end.t += dt;
    if (!let_film_follow(passes, bodies.walls, end)) return end;
    keep_accounts(dt, before, passes.told().heat_taken(), next.solids, march);
    const Instant instant = instant_after(passes, next, end.t, dt);
    const double left = move_for_ever(passes, bodies.walls);
    end.at_rest = taken.move < kStill && left < kStill;
    const bool lost = change_step(left, span, march);
    const bool endless = lost && !given && span.until_rest && !end.at_rest;
    tell(instant);
    if (endless) {
      end.verdict = {Status::iteration_limit,
                     ending::Unsettled{ending::Iteration::walls_of_cycles, passes.passed(), left}};
      return end;
    }
  }
  return end;
}

}  // namespace shellback::bearing
