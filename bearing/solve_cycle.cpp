#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "bearing/cycle.hpp"
#include "bearing/cycle_record.hpp"
#include "bearing/cycle_steps.hpp"
#include "bearing/film_heat.hpp"
#include "bearing/solve.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"

namespace shellback::bearing {
namespace {

constexpr double kClosure = 1e-4;            ///< two cycles agree: smallest film and torque [-]
constexpr int kMostCycles = 40;              ///< starved films gather their oil over ten and more
constexpr double kOfTolerance = 0.1;         ///< error of a step, of model.tolerance [-]
constexpr double kFewestSteps = 90.0;        ///< of a period: 8 degrees of two turns
constexpr double kAfterJump = 1.0 / 7200.0;  ///< of a period: 0.1 degrees of two turns (methods 4)
constexpr double kShortest = 1e-9;           ///< of a period

void expect_served([[maybe_unused]] const Case& c, Tier tier) {
  EXPECTS(c.cycle.has_value());
  if (tier == Tier::isothermal) return;
  throw InputError("model.tier",
                   fmt::format("load cycles are solved in tier isothermal; {} is not among what "
                               "cycles can do yet (--tier isothermal)",
                               to_string(tier)));
}

/// Length of what is told: a period, or the rows of an event.
double length_of(const LoadCycle& cycle) {
  return cycle.repeats() ? cycle.period : cycle.t.back() - cycle.t.front();
}

StepOptions step_options(const Case& c, double length) {
  StepOptions o;
  o.error = kOfTolerance * c.model.tolerance;
  o.longest = length / kFewestSteps;
  o.shortest = kShortest * length;
  o.after_jump = kAfterJump * length;
  o.fixed = c.cycle->step.value_or(0.0);
  return o;
}

/// In time a film need not be known better than the steps err; oil is conserved in any case.
EquilibriumOptions film_options(double error) {
  constexpr double kPart = 1e-2;  // of the error of a step
  EquilibriumOptions o;
  o.film_tolerance = o.load_tolerance = kPart * error;
  o.elastic_tolerance = o.viscosity_tolerance = kPart * error;
  return o;
}

Verdict not_closed(int cycles, double closure) {
  return {Status::iteration_limit,
          fmt::format("after {} cycles two of them still differ by {:.1e} in smallest film or "
                      "torque (1e-4 is asked for)",
                      cycles, closure),
          "",
          "tighten model.tolerance, or look at the orbit: it may repeat itself over several "
          "periods, as journals that whirl do"};
}

/// With the instant at which the step was not found.
Verdict at_instant(Verdict v, double t, double crank_speed) {
  const std::string when = crank_speed > 0.0
                               ? fmt::format("{:.4g} deg", t * crank_speed * 180.0 / kPi)
                               : fmt::format("{:.4g} s", t);
  v.reason = fmt::format("no step in time is found at {} of the cycle: {}", when, v.reason);
  return v;
}

}  // namespace

CycleResult solve_cycle(const Case& c, Tier tier, const SolveControl& control) {
  expect_served(c, tier);
  const auto begin = std::chrono::steady_clock::now();
  const double length = length_of(*c.cycle);
  const LoadCourse course(*c.cycle, c.operation.omega);
  const StepOptions steps = step_options(c, length);
  const BearingModel model = make_bearing(c, physics_of(c, tier), c.model.grid);
  FilmSteps film(model, course, c.cycle->journal_mass, film_options(steps.error));
  CycleSteps periods(film, course, length, steps);
  FilmInTime now = film.at_rest(equivalent_temperature(c));
  EquilibriumCost cost;
  CycleRecord last(film, course, length);
  double closure = NAN;
  Verdict verdict;
  int cycles = 0;
  PeriodEnd end;
  while (true) {
    CycleRecord record(film, course, length);
    record.begin(now);
    end = periods.pass(now, cost, control,
                       [&](const FilmStep& step, double dt) { record.add(step, dt, control); });
    verdict = end.verdict;
    const bool stopped = verdict.status == Status::interrupted && cycles > 0;
    if (stopped) break;  // the last whole cycle stands
    ++cycles;
    if (cycles > 1) closure = record.difference(last);
    last = std::move(record);
    if (!verdict.good()) {
      verdict = at_instant(verdict, last.told(), c.cycle->crank_speed);
      break;
    }
    if (!c.cycle->repeats() || closure <= kClosure) break;
    if (cycles == kMostCycles) {
      verdict = not_closed(cycles, closure);
      break;
    }
  }
  CycleResult r = last.result(now);
  r.verdict = verdict;
  r.tier = tier;
  r.cycles = cycles;
  r.closure = closure;
  r.steps = end.accepted;
  r.rejected_steps = end.rejected;
  r.cost.factorizations = cost.factorizations;
  r.cost.newton_iterations = cost.newton_iterations;
  r.cost.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (end.over > 0) {
    r.limiters.push_back({"steps in time longer than their error allows", end.over});
  }
  return r;
}

}  // namespace shellback::bearing
