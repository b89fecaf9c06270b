#include "bearing/over_time/stretch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bearing/case_limits.hpp"
#include "bearing/over_time/kept_run.hpp"
#include "bearing/over_time/solution_members.hpp"
#include "bearing/steady/first_film.hpp"
#include "bearing/steady/told_limits.hpp"
#include "core/contract.hpp"
#include "core/round_off.hpp"

namespace shellback::bearing {
namespace {

MarchEnd over_cycles(const Case& c, Tier tier, const WarmUpOptions& o, StretchEnd ends,
                     const SolveControl& control, CarriedOver& carried, Solution& last,
                     const TellStretch& tell) {
  constexpr double kSteps = 16.0;  // of a stretch at least: see the header
  SolveControl within = control;   // of each cycle; kept is what lies between them
  within.kept = nullptr;
  CyclePasses passes(c, tier, physics_of(c, tier), within);
  last.model = passes.film().model();
  CycleMarch march;
  const auto members = [&](Tape& tape) {
    tape(march);
    passes.members(tape);
  };
  MarchSpan span;
  span.duration = o.end;
  span.move = o.move * c.model.tolerance;
  span.steps = o.steps;
  span.shortest = c.cycle->length();
  span.until_rest = ends == StretchEnd::at_rest;
  if (!span.until_rest) span.longest = std::max(span.shortest, o.end / kSteps);
  if (!take_up_noted(control.kept, members)) {
    passes.begin(mean_supply_temperature(c));
    march.bodies = carried.bodies ? *carried.bodies : uniform_bodies(*last.model.solids, o.T_start);
    // The orbit is found before its heat counts.
    if (!passes.pass_between(march.bodies.walls)) return {passes.verdict()};
  }
  MarchEnd end =
      march_over_cycles(passes, span, march, [&](const Instant& i) { tell(i, members); });
  last.model = passes.film().model();
  carried.bodies = std::move(march.bodies);
  if (!end.verdict.good()) return end;
  end.warnings = passes.result().warnings;
  const auto own = std::min(c.warnings.size(), end.warnings.size());  // those of the case are first
  end.warnings.erase(end.warnings.begin(), end.warnings.begin() + static_cast<std::ptrdiff_t>(own));
  return end;
}

/// Between the bodies as they stand, in oil of `T_oil`.
Verdict begin_film(const SolidState& bodies, double T_cold, double T_oil,
                   const SolveControl& control, Solution& s) {
  const SolidTemperature walls = s.model.solids->at(bodies);
  s.heat = cold_heat(s.model, T_cold);
  s.heat.T_shell = walls.shell.surface;
  s.heat.T_shaft = walls.shaft.temperature;
  if (s.model.physics.thermal_deformation) s.heat.thermal_deformation = walls.thermal_deformation;
  s.T_film = T_oil;
  const Verdict film = first_film(s, s.T_film, control);
  if (film.good() || s.heat.thermal_deformation.empty()) return film;
  const double widening = area_mean(s.model.domain.grid, s.heat.thermal_deformation);
  const bool closed = widening <= -s.model.clearance;
  return closed ? Verdict{Status::iteration_limit,
                          ending::NoClearance{widening, s.model.clearance,
                                              ending::NoClearance::At::start, T_cold}}
                : film;
}

MarchEnd steadily_loaded(const Case& c, Tier tier, const WarmUpOptions& o,
                         const SolveControl& control, CarriedOver& carried, Solution& s,
                         const TellStretch& tell) {
  const Physics physics = physics_of(c, tier);
  s.model = make_bearing(c, physics, c.model.grid);
  s.point = operating_point(s.model);
  if (!carried.solids) {
    // Every harmonic computed: a march ends in the steady answer to round-off.
    const SolidEffects effects{physics.elastic, true, physics.thermal_deformation, true};
    carried.solids = std::make_shared<const Solids>(c, s.model.domain.grid, effects);
    carried.bodies = uniform_bodies(*carried.solids, o.T_start);
  }
  s.model.solids = carried.solids;
  MarchStand stand{carried.bodies->state};
  const auto members = [&](Tape& tape) { tape(s, stand); };
  const bool taken_up = take_up_noted(control.kept, members);
  MarchOptions march;
  march.end = o.end;
  march.error = o.error * c.model.tolerance;
  march.steps = o.steps;
  bool told = false;
  const auto go_on = [&] {
    return march_heat(s, stand, march, control, [&](const Instant& i) {
      told = true;
      tell(i, members);
    });
  };
  const auto begin = [&](double T_oil) {
    const Verdict film = begin_film(stand.bodies, o.T_start, T_oil, control, s);
    return film.good() ? go_on() : MarchEnd{film};
  };
  const double T_fed = mean_supply_temperature(c);
  MarchEnd end = taken_up ? go_on() : begin(T_fed);
  // A thin film of warm oil may have no way to the one that cold walls make of it; a thick one has.
  const bool stopped = end.verdict.status == Status::interrupted;
  if (!end.verdict.good() && !stopped && !taken_up && !told) {
    stand = MarchStand{carried.bodies->state};
    const Field walls = s.model.solids->at(stand.bodies).shell.surface;
    const double T_walls = *std::min_element(walls.begin(), walls.end());
    if (T_walls < T_fed) end = begin(T_walls);
  }
  carried.bodies->state = std::move(stand.bodies);
  if (end.verdict.good()) end.warnings = warnings_of(s);
  return end;
}

/// Options that are no march in time. InputError.
void expect_options(const WarmUpOptions& o) {
  const auto positive = [](const char* name, double value) {
    if (value > 0.0) return;
    throw InputError(fmt::format("WarmUpOptions::{}", name),
                     fmt::format("{:.6g} is not possible (it must be positive)", value));
  };
  positive("end", o.end);
  positive("error", o.error);
  positive("move", o.move);
  if (const Range& can = kValueRanges.temperature; !can.holds(o.T_start)) {
    throw InputError("WarmUpOptions::T_start",
                     fmt::format("{:.6g} K is not possible (it must {})", o.T_start, can.words));
  }
  if (o.steps.empty()) return;
  double sum = 0.0;
  for (const double dt : o.steps) {
    positive("steps", dt);
    sum += dt;
  }
  if (!(std::abs(sum - o.end) <= kRoundOff * o.end)) {
    throw InputError("WarmUpOptions::steps",
                     fmt::format("they add up to {:.6g} s, and `end` is {:.6g} s", sum, o.end));
  }
}

}  // namespace

MarchEnd pass_stretch(const Case& c, Tier tier, const WarmUpOptions& options, StretchEnd ends,
                      const SolveControl& control, CarriedOver& carried, Solution& last,
                      const TellStretch& tell) {
  expect_options(options);
  return c.cycle ? over_cycles(c, tier, options, ends, control, carried, last, tell)
                 : steadily_loaded(c, tier, options, control, carried, last, tell);
}

}  // namespace shellback::bearing
