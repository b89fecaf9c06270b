#include "app/reading/load_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bearing/over_time/cycle_numbers.hpp"
#include "bearing/row_gaps.hpp"
#include "core/constants.hpp"
#include "core/range.hpp"

namespace shellback::app {
namespace {

using bearing::LoadCycle;
using bearing::LoadInterpolation;

constexpr double kSameTime = 1e-9;  ///< of the period: times closer than this are one [-]
constexpr double kSameLoad = 1e-6;  ///< of the largest: as much as tables have [-]
constexpr int kRowsOfAJump = 2;     ///< before and after it
constexpr const char* kLoadExample = "angle [deg], load_x [N], load_y [N]";

}  // namespace

LoadTable::LoadTable(const std::string& path)
    : table_(path,
             {{"angle", kAngle},
              {"time", kTime},
              {"load_x", kForce},
              {"load_y", kForce},
              {"load", kForce},
              {"direction", kAngle},
              {"speed", kSpeed}},
             kLoadExample),
      angle_(table_.has("angle")),
      when_(angle_ ? "angle" : "time") {
  expect_columns();
  if (table_.rows() < 2) {
    table_.fail_header(fmt::format(
        "there {} below this line, and a load cycle needs two or more; a steady load is given as "
        "operation.load",
        table_.rows() == 0 ? "is no row" : "is one row"));
  }
}

LoadCycle LoadTable::cycle(double speed, double period, LoadInterpolation interpolation) {
  make_rows(speed);
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    expect_within(k, period);
  }
  expect_order(interpolation);
  judge_gaps(period);
  judge_directions(interpolation);
  if (period < kInfinite) close(period, interpolation);
  LoadCycle c;
  c.period = period;
  c.interpolation = interpolation;
  for (const Row& row : rows_) {
    c.t.push_back(row.t);
    c.x.push_back(row.load.x);
    c.y.push_back(row.load.y);
    if (table_.has("speed")) c.omega.push_back(row.load.omega);
  }
  return c;
}

void LoadTable::expect_mass(const LoadCycle& c) const {
  if (c.journal_mass > 0.0) return;
  const auto row = bearing::vanishing_load(c);
  if (!row) return;
  table_.fail(rows_[*row].line, when_,
              fmt::format("at {} the load vanishes, or passes through zero before the next row, "
                          "and nothing tells where a journal without mass then is; give "
                          "load_cycle.journal_mass, the mass that the film carries",
                          table_.written(rows_[*row].line, when_)));
}

void LoadTable::expect_columns() const {
  const bool polar = table_.has("load") || table_.has("direction");
  const bool cartesian = table_.has("load_x") || table_.has("load_y");
  if (angle_ && table_.has("time")) {
    table_.fail_header("the rows have both angle and time; keep one of the columns");
  }
  if (polar && cartesian) {
    table_.fail_header("the load is given twice; keep load_x and load_y, or load and direction");
  }
  if (!table_.has(when_)) {
    table_.fail_header(
        fmt::format("there is no column angle or time; the first line names "
                    "columns and units, for example {}",
                    kLoadExample));
  }
  static_cast<void>(table_.column(polar ? "load" : "load_x"));
  static_cast<void>(table_.column(polar ? "direction" : "load_y"));
}

void LoadTable::make_rows(double speed) {
  const bool polar = table_.has("load");
  const auto& a = table_.column(polar ? "load" : "load_x");
  const auto& b = table_.column(polar ? "direction" : "load_y");
  const auto& when = table_.column(when_);
  for (std::size_t k = 0; k < table_.rows(); ++k) {
    if (polar && a[k] < 0.0) {
      table_.fail(k, "load",
                  "a magnitude is not negative; turn its direction by 180 deg, or give load_x and "
                  "load_y");
    }
    Row row;
    row.t = when[k] / speed;
    row.line = k;
    row.load.x = polar ? a[k] * std::cos(b[k]) : a[k];
    row.load.y = polar ? a[k] * std::sin(b[k]) : b[k];
    if (table_.has("speed")) row.load.omega = table_.column("speed")[k];
    rows_.push_back(row);
  }
}

void LoadTable::expect_within(std::size_t k, double period) const {
  const bool event = period == kInfinite;
  if (!event && rows_[k].t < 0.0) {
    table_.fail(k, when_,
                fmt::format("{} lies before the period, which begins at 0; add one period to the "
                            "rows before 0 and put them at the end",
                            table_.written(k, when_)));
  }
  if (rows_[k].t > period * (1.0 + kSameTime)) {
    table_.fail(k, when_,
                fmt::format("{} lies out of the period, which begins at 0; give one "
                            "period, or correct load_cycle.period",
                            table_.written(k, when_)));
  }
  if (k == 0 && event && rows_[k].t != 0.0) {
    table_.fail(0, when_,
                fmt::format("a single event begins at 0, not at {}; shift the column, or "
                            "give load_cycle.period",
                            table_.written(0, when_)));
  }
}

void LoadTable::expect_order(LoadInterpolation interpolation) const {
  int at_once = 1;
  for (std::size_t k = 1; k < rows_.size(); ++k) {
    const std::string here = table_.written(k, when_);
    if (rows_[k].t < rows_[k - 1].t) {
      table_.fail(k, when_,
                  fmt::format("{} comes after {}; sort the rows by {}", here,
                              table_.written(k - 1, when_), when_));
    }
    at_once = rows_[k].t == rows_[k - 1].t ? at_once + 1 : 1;
    if (at_once > kRowsOfAJump) {
      table_.fail(k, when_,
                  fmt::format("{} stands here for the third time; a jump has two rows: "
                              "what holds before it, what holds after it",
                              here));
    }
    if (at_once > 1 && interpolation == LoadInterpolation::periodic_spline) {
      table_.fail(k, when_,
                  fmt::format("{} stands here for the second time: a jump, and a "
                              "spline is smooth; write interpolation = \"linear\", or "
                              "give each {} once",
                              here, when_));
    }
  }
}

/// Rows from 0 on to before the end of the period, which is the first row again.
void LoadTable::close(double period, LoadInterpolation interpolation) {
  const bool from_zero = rows_.front().t <= kSameTime * period;
  const auto at_end = [&] { return rows_.back().t >= period * (1.0 - kSameTime); };
  if (from_zero) rows_.front().t = 0.0;
  if (at_end()) {
    const auto is_jump = [&](const Row& a, const Row& b) {
      return b.t - a.t <= kSameTime * period;
    };
    const std::size_t n = rows_.size();
    const bool told_twice =
        from_zero && n >= 4 && is_jump(rows_[0], rows_[1]) && is_jump(rows_[n - 2], rows_[n - 1]);
    if (told_twice) {  // the same jump at either end
      const Change before = change(rows_[0], rows_[n - 2]), after = change(rows_[1], rows_[n - 1]);
      if (!before.any() && !after.any()) rows_.resize(n - 2);
    }
    if (from_zero && at_end()) {
      expect_periodic();
      rows_.pop_back();
    }
    while (at_end()) move_to_front();  // of a jump there, what holds before it last
  } else if (!from_zero) {
    begin_at_zero(period, interpolation);
  }
}

LoadTable::Change LoadTable::change(const Row& a, const Row& b) const {
  double load = 0.0;
  double speed = 0.0;
  for (const Row& row : rows_) {
    load = std::max(load, std::hypot(row.load.x, row.load.y));
    speed = std::max(speed, std::abs(row.load.omega));
  }
  Change c;
  c.load = std::hypot(a.load.x - b.load.x, a.load.y - b.load.y);
  c.speed = std::abs(a.load.omega - b.load.omega);
  c.of_load = c.load > kSameLoad * load;
  c.of_speed = c.speed > kSameLoad * speed;
  return c;
}

/// A long stretch between two rows that are alike says that the load stays; behind the last row of
/// a period it may as well be that the period is wrong.
void LoadTable::judge_gaps(double period) {
  std::vector<double> t;
  for (const Row& row : rows_) t.push_back(row.t);
  for (const bearing::RowGap& gap : bearing::row_gaps(t, period)) {
    const Change c = change(rows_[gap.from], rows_[gap.to]);
    const bool changes = c.of_load || c.of_speed;
    const bool last = gap.to == 0;
    if (!last && !changes) continue;
    const std::string problem = fmt::format(
        "from {} to {}{} no row tells the load, {:.3g} times as far as rows stand "
        "apart elsewhere; add the rows{}; a straight line that is meant has a row half "
        "way",
        table_.written(gap.from, when_), table_.written(gap.to, when_),
        last ? " of the next period" : "", gap.times, last ? ", or correct load_cycle.period" : "");
    if (gap.times > bearing::kLineToRefuse) table_.fail(gap.from, when_, problem);
    // The rows as the cycle has them (judge_cycle.cpp) tell the others.
    if (last && (!changes || rows_.front().t > 0.0)) doubts_.push_back(problem);
  }
}

/// Both components go along straight lines: between directions that are far apart the load falls.
void LoadTable::judge_directions(LoadInterpolation interpolation) {
  constexpr double kFalls = 0.8;  // of the smaller of both rows: 74 degrees [-]
  if (!table_.has("direction")) return;
  const std::vector<double>& direction = table_.column("direction");
  const auto told = [&](std::size_t k) {
    return fmt::format("from {} to {}", table_.written(rows_[k].line, when_),
                       table_.written(rows_[k + 1].line, when_));
  };
  for (std::size_t k = 0; k + 1 < rows_.size(); ++k) {
    if (!(rows_[k + 1].t > rows_[k].t)) continue;
    const double turn =
        std::abs(direction[rows_[k + 1].line] - direction[rows_[k].line]) * 180.0 / kPi;
    if (turn > 360.0 * (1.0 + 1e-9)) {
      doubts_.push_back(
          fmt::format("{} the direction moves by {:.4g} deg, more than once round; "
                      "check its unit in the first line",
                      told(k), turn));
      return;
    }
    const double between = std::cos(0.5 * std::abs(std::remainder(turn, 360.0)) * kPi / 180.0);
    const double a = std::hypot(rows_[k].load.x, rows_[k].load.y);
    const double b = std::hypot(rows_[k + 1].load.x, rows_[k + 1].load.y);
    const bool alike = std::min(a, b) > 0.5 * std::max(a, b);  // else it falls, or rises, anyway
    const bool reverses = between < 1e-3;                      // through zero, as it may be meant
    if (!alike || reverses || between >= kFalls) continue;
    if (interpolation == LoadInterpolation::periodic_spline) continue;
    doubts_.push_back(
        fmt::format("{} the direction turns by {:.3g} deg; both components of the "
                    "load go along straight lines, on which it falls to {:.2g} of "
                    "what it is in rows alike; add rows between",
                    told(k), std::abs(std::remainder(turn, 360.0)), between));
    return;
  }
}

void LoadTable::expect_periodic() const {
  const Row& a = rows_.front();
  const Row& b = rows_.back();
  const Change c = change(a, b);
  if (!c.of_load && !c.of_speed) return;
  const std::string what = c.of_load ? fmt::format("the load jumps by {:.4g} N", c.load)
                                     : fmt::format("the speed jumps by {:.4g} rpm", c.speed / kRpm);
  table_.fail(b.line, when_,
              fmt::format("the table is not periodic: from {} back to {} {}; make the last row "
                          "equal to the first, or leave it out; a jump that is meant has two "
                          "rows at 0",
                          table_.written(b.line, when_), table_.written(a.line, when_), what));
}

/// A row at the end of the period holds at its beginning, before all others there.
void LoadTable::move_to_front() {
  Row row = rows_.back();
  row.t = 0.0;
  rows_.pop_back();
  rows_.insert(rows_.begin(), row);
}

/// Adds the row at 0 that lies on the straight line from the last row to the first.
void LoadTable::begin_at_zero(double period, LoadInterpolation interpolation) {
  if (interpolation == LoadInterpolation::periodic_spline) {
    table_.fail(0, when_, "a periodic spline begins with a row at 0; add it");
  }
  const Row& a = rows_.back();
  const Row& b = rows_.front();
  const double part = (period - a.t) / (period - a.t + b.t);
  const auto between = [&](double from, double to) { return from + part * (to - from); };
  Row row;
  row.load = {between(a.load.x, b.load.x), between(a.load.y, b.load.y),
              between(a.load.omega, b.load.omega)};
  row.line = a.line;
  rows_.insert(rows_.begin(), row);
}

}  // namespace shellback::app
