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
constexpr double kShortest = 1e-7;           ///< of a period

void expect_served([[maybe_unused]] const Case& c, Tier tier) {
  EXPECTS(c.cycle.has_value());
  if (tier == Tier::isothermal) return;
  throw InputError("model.tier",
                   fmt::format("load cycles are solved in tier isothermal; {} is not among what "
                               "cycles can do yet (--tier isothermal)",
                               to_string(tier)));
}

/// All lengths go with the error allowed, as steps do that it chooses.
StepOptions step_options(const Case& c, const LoadCourse& course, double length) {
  constexpr double kUsual = 0.01;          // model.tolerance for which lengths are meant
  constexpr double kDegrees = kPi / 1800;  // 0.1 degrees of the journal's turn
  const double longer = std::cbrt(c.model.tolerance / kUsual);
  StepOptions o;
  o.error = kOfTolerance * c.model.tolerance;
  o.longest = longer * length / kFewestSteps;
  o.shortest = kShortest * length;
  o.after_jump = longer * kAfterJump * length;
  if (course.largest_speed() > 0.0) {
    o.after_jump = std::min(o.after_jump, longer * kDegrees / course.largest_speed());
  }
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
          "repeat the load several times in a longer period (oil of a starved film gathers over "
          "more than 40 short ones), or look at the orbit: it may repeat itself over several "
          "periods, as journals that whirl do"};
}

/// With the instant at which the step was not found.
Verdict at_instant(Verdict v, double t, double crank_speed) {
  const std::string when = crank_speed > 0.0
                               ? fmt::format("{:.4g} deg", t * crank_speed * 180.0 / kPi)
                               : fmt::format("{:.4g} s", t);
  const bool defect = v.status == Status::invalid_number;  // to be reported, nothing physical
  if (v.status == Status::interrupted || defect) return v;
  v.status = Status::iteration_limit;
  v.reason = fmt::format("no step in time is found at {} of the cycle: {}", when, v.reason);
  v.cure =
      "give load_cycle.journal_mass (a journal without mass may have to leap), elastic "
      "deformation, a lower load, or a finer grid";
  return v;
}

constexpr const char* kFromSteady = "the event begins in the steady state of its first row";
constexpr const char* kFromRest =
    "the event begins with the journal at rest in the middle of a full film: no steady state of "
    "its "
    "first row was found";
constexpr const char* kOverLong = "steps in time that err by more than they may";

/// How cycles draw near to the periodic state: where the change falls by the ratio rho from cycle
/// to cycle, rho/(1 - rho) of the last one is still to come.
struct Closure {
  double last = NAN;    ///< difference of the last two cycles [-]
  double before = NAN;  ///< of the two before [-]
  void add(double difference) {
    before = last;
    last = difference;
  }
  [[nodiscard]] bool closed() const {
    constexpr double kSlowest = 0.99;  // slower is not seen from noise
    const double rho = std::isfinite(before) ? std::min(last / before, kSlowest) : 0.0;
    return last * std::max(1.0, rho / (1.0 - rho)) <= kClosure;
  }
};

}  // namespace

CycleResult solve_cycle(const Case& c, Tier tier, const SolveControl& control) {
  expect_served(c, tier);
  const auto begin = std::chrono::steady_clock::now();
  const double length = c.cycle->length();
  const LoadCourse course(*c.cycle, c.operation.omega);
  const StepOptions steps = step_options(c, course, length);
  FilmSteps film(make_bearing(c, physics_of(c, tier), c.model.grid), course, c.cycle->journal_mass,
                 film_options(steps.error));
  CycleSteps periods(film, course, length, steps);
  EquilibriumCost cost;
  const double T = equivalent_temperature(c);
  std::optional<FilmInTime> begun;
  if (!c.cycle->repeats()) begun = film.steady(T, cost, control.stop);
  const bool from_rest = !begun.has_value();
  FilmInTime now = begun ? *std::move(begun) : film.at_rest(T);
  CycleRecord told(film, course, length);
  Closure closure;
  CycleResult r;
  while (true) {
    CycleRecord record(film, course, length);
    record.begin(now);
    const PeriodEnd end = periods.pass(now, cost, control, [&](const FilmStep& step, double dt) {
      record.add(step, dt, control);
    });
    r.verdict = end.verdict;
    if (end.verdict.status == Status::interrupted && r.cycles > 0) break;  // a whole one stands
    if (end.verdict.good() && r.cycles > 0) closure.add(record.difference(told));
    ++r.cycles;
    r.steps = end.accepted;
    r.rejected_steps = end.rejected;
    r.limiters.clear();
    if (end.over > 0) r.limiters.push_back({kOverLong, end.over});
    told = std::move(record);
    if (!r.verdict.good()) r.verdict = at_instant(r.verdict, told.told(), c.cycle->crank_speed);
    if (!r.verdict.good() || !c.cycle->repeats() || closure.closed()) break;
    if (r.cycles == kMostCycles) r.verdict = not_closed(r.cycles, closure.last);
    if (!r.verdict.good()) break;
  }
  told.write(r);
  if (!c.cycle->repeats()) r.assumptions.push_back(from_rest ? kFromRest : kFromSteady);
  r.tier = tier;
  r.closure = closure.last;
  r.cost.factorizations = cost.factorizations;
  r.cost.newton_iterations = cost.newton_iterations;
  r.cost.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return r;
}

}  // namespace shellback::bearing
