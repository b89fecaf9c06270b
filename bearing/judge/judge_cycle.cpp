/// A load cycle as it stands in a case, whoever filled it; part of judge_case.hpp.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bearing/judge/judge_parts.hpp"
#include "bearing/judge/value_check.hpp"
#include "bearing/load_cycle.hpp"
#include "bearing/over_time/cycle_endings.hpp"
#include "bearing/over_time/cycle_numbers.hpp"
#include "bearing/row_gaps.hpp"
#include "core/constants.hpp"
#include "core/round_off.hpp"
#include "core/step_control.hpp"

namespace shellback::bearing {
namespace {

/// In degrees of the crank where the cycle is told in them, in seconds elsewhere.
std::string shown_instant(const LoadCycle& c, double t) {
  return c.crank_speed > 0.0 ? fmt::format("{:.6g} deg", t * c.crank_speed * 180.0 / kPi)
                             : fmt::format("{:.6g} s", t);
}

constexpr std::size_t kFewestRows = 2;        ///< one is a steady load
constexpr std::size_t kFewestSplineRows = 3;  ///< two cannot tell a period's shape
constexpr int kRowsOfAJump = 2;               ///< before and after it
constexpr double kFewestGiven = 24.0;         ///< steps of a period, of second order from there on

/// Rows as many as times, of numbers; what follows relies on it.
bool judge_rows(const LoadCycle& c, const ValueCheck& cycle) {
  const bool fit = c.x.size() == c.t.size() && c.y.size() == c.t.size() &&
                   (c.omega.empty() || c.omega.size() == c.t.size());
  if (!fit) {
    cycle.refuse("file", fmt::format("{} times, {} and {} loads and {} speeds make no table",
                                     c.t.size(), c.x.size(), c.y.size(), c.omega.size()));
    return false;
  }
  if (c.t.size() < kFewestRows) {
    const bool none = c.t.empty();
    cycle.refuse("file", none ? "no row makes no load cycle" : "one row makes no load cycle",
                 "give two or more (a last one that repeats the first counts as the first), or a "
                 "steady load as operation.load");
    return false;
  }
  for (const auto* column : {&c.t, &c.x, &c.y, &c.omega}) {
    for (std::size_t k = 0; k < column->size(); ++k) {
      if (std::isfinite((*column)[k])) continue;
      cycle.refuse("file", fmt::format("row {} holds a number that is not finite", k));
      return false;
    }
  }
  return true;
}

/// Times from 0 on within the period, not falling; no more than two at once.
void judge_times(const LoadCycle& c, const ValueCheck& cycle) {
  int at_once = 1;
  for (std::size_t k = 1; k < c.t.size(); ++k) {
    at_once = c.t[k] == c.t[k - 1] ? at_once + 1 : 1;
    if (c.t[k] < c.t[k - 1]) {
      return cycle.refuse("file", fmt::format("row {} lies before the one above it", k),
                          "sort the rows by time");
    }
    if (at_once > kRowsOfAJump) {
      return cycle.refuse("file", fmt::format("row {} is the third at one time", k),
                          "a jump has two: what holds before it, what holds after it");
    }
    if (at_once > 1 && c.interpolation == LoadInterpolation::periodic_spline) {
      return cycle.refuse("interpolation", "a spline is smooth and has no jumps",
                          "write \"linear\", or give each time once");
    }
  }
  if (c.t.front() < 0.0 || (c.repeats() && c.t.back() >= c.period)) {
    cycle.refuse("file",
                 fmt::format("the rows reach from {} to {}, out of the period of {}",
                             shown_instant(c, c.t.front()), shown_instant(c, c.t.back()),
                             shown_instant(c, c.period)),
                 "begin at 0; the end of the period is the first row again");
  }
  if (!c.repeats() && !(c.t.back() > c.t.front())) {
    cycle.refuse("file", "the event takes no time", "give rows at two times or more");
  }
}

void judge_scalars(const LoadCycle& c, const ValueCheck& cycle) {
  if (!(c.period > 0.0)) {
    cycle.refuse("period", fmt::format("{} s is not possible (it must be positive)", c.period));
  }
  cycle.number("journal_mass", c.journal_mass, "", kNotNegative);
  cycle.number("crank_speed", c.crank_speed, "rad/s", kNotNegative);
  if (c.step) cycle.number("step", *c.step, "s", kPositive);
  for (const double t : c.fields_at) {
    if (t >= 0.0 && t <= c.length() * (1.0 + kRoundOff)) continue;
    cycle.refuse("fields_at",
                 fmt::format("{} lies outside the cycle, which takes {}", shown_instant(c, t),
                             shown_instant(c, c.length())),
                 "give instants from its beginning to its end");
  }
  if (c.interpolation == LoadInterpolation::linear) return;
  if (!c.repeats()) {
    cycle.refuse("interpolation", "a periodic spline needs a period",
                 "give load_cycle.period, or write interpolation = \"linear\"");
  }
  if (c.t.front() != 0.0) {
    cycle.refuse("file", "a periodic spline begins with a row at 0", "add it");
  }
  if (c.t.size() < kFewestSplineRows) {
    cycle.refuse("interpolation",
                 "a periodic spline needs three rows or more, that at the period's end not counted",
                 "write interpolation = \"linear\"");
  }
}

/// Whether load and speed in the rows are the same to as many digits as tables have.
bool stays(const LoadCycle& c, const RowGap& gap, double largest, double fastest) {
  const double load = std::hypot(c.x[gap.to] - c.x[gap.from], c.y[gap.to] - c.y[gap.from]);
  const double speed = c.omega.empty() ? 0.0 : std::abs(c.omega[gap.to] - c.omega[gap.from]);
  return load <= kVanishingLoad * largest && speed <= kVanishingLoad * fastest;
}

/// Long stretches without a row. Where both ends are alike the table says that the load stays.
void judge_gaps(const LoadCycle& c, const CycleNumbers& n, Findings& to) {
  for (const RowGap& gap : row_gaps(c.t, c.period)) {
    if (stays(c, gap, n.largest, n.largest_speed)) continue;
    const std::string problem = fmt::format(
        "from {} on no row tells the load for {}, {:.3g} times as far as rows stand apart "
        "elsewhere",
        shown_instant(c, c.t[gap.from]), shown_instant(c, gap.length), gap.times);
    const std::string cure = "add the rows; a straight line that is meant has a row half way";
    if (gap.times > kLineToRefuse) {
      to.refuse("load_cycle.file", problem, cure);
    } else {
      to.suspect("load_cycle.file", problem, cure);
    }
  }
}

/// Rows far apart: a spline may swing between them to loads that nobody gave.
void judge_swing(const LoadCycle& c, const ValueCheck& cycle) {
  constexpr double kMostSwing = 2.0;  // of the largest row: that is no interpolation any more [-]
  constexpr int kSamples = 8;         // between rows: a cubic has two extremes there
  if (c.interpolation != LoadInterpolation::periodic_spline) return;
  const LoadCourse course(c, 0.0);
  double largest = 0.0;  // row
  for (std::size_t k = 0; k < c.t.size(); ++k) {
    largest = std::max(largest, std::hypot(c.x[k], c.y[k]));
  }
  for (std::size_t k = 0; k < c.t.size(); ++k) {
    const double next = k + 1 < c.t.size() ? c.t[k + 1] : c.t.front() + c.period;
    for (int i = 1; i < kSamples; ++i) {
      const LoadNow w = course.at(c.t[k] + (next - c.t[k]) * i / kSamples);
      const double load = std::hypot(w.x, w.y);
      if (load <= kMostSwing * largest) continue;
      cycle.refuse("period",
                   fmt::format("between the row at {} and the next, {} later, the spline swings to "
                               "{:.4g} kN, {:.3g} times the largest row",
                               shown_instant(c, c.t[k]), shown_instant(c, next - c.t[k]),
                               1e-3 * load, load / largest),
                   "check the period and its unit, give rows in between, or write interpolation = "
                   "\"linear\"");
      return;
    }
  }
}

}  // namespace

void judge_cycle_values(const LoadCycle& c, Findings& to) {
  const ValueCheck cycle("load_cycle", to);
  if (!judge_rows(c, cycle)) return;
  judge_scalars(c, cycle);
  judge_times(c, cycle);
  if (to.refused()) return;
  const CycleNumbers n = cycle_numbers(c, 0.0);
  if (n.largest <= 0.0) {
    cycle.refuse("file", "the load is zero throughout",
                 "check the columns of the load (with [crank]: its masses and pressures)");
  }
  judge_gaps(c, n, to);
  judge_swing(c, cycle);
  if (c.step && *c.step > n.length) {
    cycle.refuse("step",
                 fmt::format("a step of {} is longer than the whole of {}",
                             shown_instant(c, *c.step), shown_instant(c, n.length)),
                 "check its unit");
  } else if (c.step && *c.step > n.length / kFewestGiven) {
    to.suspect(
        "load_cycle.step",
        fmt::format("{:.3g} steps make the whole of {}: their error does not fall with their "
                    "square yet, and the bars of time are too short",
                    n.length / *c.step, shown_instant(c, n.length)),
        "give a shorter one, or none: then steps are chosen by their error");
  }
  if (c.step && *c.step < kStepShortest * n.length) {
    cycle.refuse("step",
                 fmt::format("a step of {} is shorter than {:.0e} of the whole of {}",
                             shown_instant(c, *c.step), kStepShortest, shown_instant(c, n.length)),
                 "check its unit");
  }
}

/// A journal begins at rest in the middle. Free of any film, the mean load moves it by this way in
/// all cycles that a search takes: with less than the clearance, a load of 2e-7 of its weight at
/// cycles of 20 ms and 30 um, a unit is wrong. A mean load within the momentum that a cycle may
/// leave open needs no film.
void judge_mass(const Case& c, const CycleNumbers& n, Findings& to) {
  const double m = c.cycle->journal_mass;
  const double time = kMostCycles * c.cycle->length();
  const double way = 0.5 * n.net * time * time / (m * c.bearing.radial_clearance);
  if (!c.cycle->repeats() || n.net <= kClosed * n.mean || way >= 1.0) return;
  to.refuse("load_cycle.journal_mass",
            fmt::format("in the {} cycles of a search the mean load moves a free journal of {:.4g} "
                        "kg by {:.2g} of the clearance: too little to see what carries it",
                        kMostCycles, m, way),
            "check its unit; or give the load as a single event");
}

/// Surfaces drag oil into the film's wedge with (omega/2 - omega_load) R: none where the load turns
/// with half the speed of the journal (textbook: half-speed whirl). Told where a large load does so
/// for a turn of the journal, by then with a tenth of the wedge and less: only squeezing carries.
void judge_turning(const Case& c, Findings& to) {
  constexpr double kWedge = 0.1;  // of the speed with which a load that stands is carried [-]
  const LoadCourse course(*c.cycle, c.operation.omega);
  const LoadStretch follows =
      course.heavy_stretch([](const LoadNow& from, const LoadNow& to, double dt) {
        const double turn =
            std::atan2(from.x * to.y - from.y * to.x, from.x * to.x + from.y * to.y);
        const double half = 0.25 * (from.omega + to.omega) * dt;
        return std::abs(half - turn) < kWedge * std::abs(half);
      });
  if (!follows.always && follows.turned < 2.0 * kPi) return;
  const std::string when = follows.always ? "all the time"
                                          : fmt::format("while this makes {:.3g} revolutions",
                                                        follows.turned / (2.0 * kPi));
  to.suspect("load_cycle.file",
             fmt::format("the load turns with half the speed of the journal {}: no oil is dragged "
                         "under it, only squeezing carries",
                         when),
             "check direction and frame of the load, and the speed");
}

/// A journal that never turns drags no oil under its load: squeezing carries it, which takes a load
/// that lets go or goes round, or oil under more pressure than it.
void judge_standing(const Case& c, const CycleNumbers& n, Findings& to) {
  if (n.largest_speed > 0.0 || !c.cycle->repeats() || c.surfaces.contact) return;
  const LoadCycle cycle = as_lines(*c.cycle);
  double x = 0.0, y = 0.0, pressure = 0.0;
  for (std::size_t k = 0; k < cycle.t.size(); ++k) {
    x += cycle.x[k];
    y += cycle.y[k];
  }
  double least = INFINITY;
  const double size = std::hypot(x, y);
  if (!(size > 0.0)) return;
  for (std::size_t k = 0; k < cycle.t.size(); ++k) {
    const double along = (cycle.x[k] * x + cycle.y[k] * y) / size;
    const double aside = std::abs(cycle.y[k] * x - cycle.x[k] * y) / size;
    if (!(along >= aside)) return;  // all of them within a right angle
    least = std::min(least, along);
  }
  for (const Supply& s : c.supplies) pressure = std::max(pressure, s.pressure);
  const double lift = pressure * 2.0 * c.bearing.radius * c.bearing.width;  // at most
  if (!(least > lift)) return;
  to.suspect("operation.speed",
             fmt::format("the journal does not turn, and its load pushes to one side with {:.4g} N "
                         "or more all the time: hardly anything pushes smooth surfaces apart "
                         "again, they come nearer and nearer",
                         least),
             "give the speed, or surfaces with contact data, or take the load as a single event "
             "(without period)");
}

/// A table over crank angle with speeds of its own: then operation.speed only says how fast crank
/// angles pass, and that both agree in the mean is what a shaft with its crank has.
void judge_own_speed(const Case& c, const CycleNumbers& n, Findings& to) {
  constexpr double kApart = 0.01;  // of both: beyond it no trapezoid over the rows misses [-]
  const LoadCycle& cycle = *c.cycle;
  if (cycle.omega.empty() || !(cycle.crank_speed > 0.0)) return;
  const auto [slowest, fastest] = std::minmax_element(cycle.omega.begin(), cycle.omega.end());
  if (*slowest < 0.0 && *fastest > 0.0) return;  // swings to and fro beside the crank
  const double mean = std::abs(n.mean_speed);
  if (std::abs(mean - cycle.crank_speed) <= kApart * cycle.crank_speed) return;
  to.suspect("operation.speed",
             fmt::format("the table's column speed is the journal's, {:.4g} rpm in the mean; "
                         "operation.speed, {:.4g} rpm, only says how fast its crank angles pass",
                         mean / kRpm, cycle.crank_speed / kRpm),
             "make the two agree, or take the column away");
}

void judge_cycle(const Case& c, Findings& to) {
  const CycleNumbers n = cycle_numbers(*c.cycle, c.operation.omega);
  const double specific = n.largest / (2.0 * c.bearing.radius * c.bearing.width);
  const double u = n.largest_speed * c.bearing.radius;
  compare(to, "operation.speed", u, kBearingLimits.surface_speed,
          fmt::format("the largest surface speed is {:.4g} m/s", u),
          "check the unit of the speed (of the column speed, if the table has one)");
  compare(
      to, "load_cycle.file", specific, kBearingLimits.specific_load,
      fmt::format("the largest load over the projected area is {:.4g} MPa", 1e-6 * specific),
      "check the unit of the load (with [crank]: of its masses and pressures, and of the speed)");
  if (const auto* moment = std::get_if<MomentGiven>(&c.operation.alignment)) {
    const double lever = std::hypot(moment->about_x, moment->about_y) / n.largest;
    compare(to, "operation.moment", lever / c.bearing.width, kBearingLimits.lever,
            fmt::format("the moment is that of the largest load {} beside mid-width, {:.3g} of the "
                        "width",
                        shown(lever, "mm"), lever / c.bearing.width),
            "beyond 0.5 the load's line lies outside the bearing; check the unit of the moment");
  }
  judge_turning(c, to);
  judge_own_speed(c, n, to);
  judge_standing(c, n, to);
  if (c.cycle->journal_mass > 0.0) return judge_mass(c, n, to);
  if (const auto row = vanishing_load(*c.cycle)) {
    to.refuse(
        "load_cycle.journal_mass",
        fmt::format("at {} the load vanishes, or passes through zero before the next row, and "
                    "nothing tells where a journal without mass then is",
                    shown_instant(*c.cycle, c.cycle->t[*row])),
        "give journal_mass, the mass that the film carries");
  }
}

}  // namespace shellback::bearing
