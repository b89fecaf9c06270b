/// [load_cycle]: a table of loads over time or crank angle, or the load of a big end.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/csv_table.hpp"
#include "app/did_you_mean.hpp"
#include "app/sections.hpp"
#include "bearing/cycle_numbers.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

using namespace bearing;

constexpr double kSameTime = 1e-9;  ///< of the period: times closer than this are one [-]
constexpr double kSameLoad = 1e-6;  ///< of the largest: as much as tables have [-]
constexpr int kRowsOfAJump = 2;     ///< before and after it
constexpr const char* kExample = "angle [deg], load_x [N], load_y [N]";

/// A length of the cycle: crank angle [rad] or time [s].
struct Extent {
  double value = 0.0;
  bool angle = false;
};

Extent read_extent(const Section& section, const std::string& key) {
  const std::string text = section.text(key);
  Extent extent;
  try {
    extent.value = parse_quantity(text, kTime);
  } catch (const UnitError&) {
    try {
      extent = {parse_quantity(text, kAngle), true};
    } catch (const UnitError&) {
      section.fail(key, fmt::format("{} is neither a crank angle nor a time; write for example {} "
                                    "= \"1 deg\" or {} = \"0.1 ms\"",
                                    in_quotes(text), key, key));
    }
  }
  if (!(extent.value > 0.0)) {
    section.fail(key, fmt::format("{} is not possible (it must be positive)", in_quotes(text)));
  }
  return extent;
}

std::optional<Extent> maybe_extent(const Section& section, const std::string& key) {
  if (!section.has(key)) return std::nullopt;
  return read_extent(section, key);
}

/// The crank's speed, which turns `what` into time. Fails if it stands still.
double crank_speed(const Section& file, double omega, const std::string& what) {
  if (omega != 0.0) return std::abs(omega);
  throw error_at(file.reader().place("operation.speed"), "operation.speed",
                 fmt::format("{}, which the speed of the crank turns into time, but the speed is "
                             "zero; give the crank's speed, or tell the cycle in time (ms)",
                             what));
}

struct Row {
  double t = 0.0;
  LoadNow load;
  std::size_t line = 0;  ///< row of the table that it comes from
};

/// A table of loads while its rows become a cycle.
class LoadTable {
 public:
  explicit LoadTable(const std::string& path)
      : table_(path,
               {{"angle", kAngle},
                {"time", kTime},
                {"load_x", kForce},
                {"load_y", kForce},
                {"load", kForce},
                {"direction", kAngle},
                {"speed", kSpeed}},
               kExample),
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

  [[nodiscard]] bool told_in_angle() const { return angle_; }

  /// `scale`: time per unit of the first column; `period`: infinite of a single event [s].
  [[nodiscard]] LoadCycle cycle(double scale, double period, LoadInterpolation interpolation) {
    make_rows(scale);
    expect_order(period, interpolation);
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

  void expect_mass(const LoadCycle& c) const {
    if (c.journal_mass > 0.0) return;
    const auto row = vanishing_load(c);
    if (!row) return;
    table_.fail(rows_[*row].line, when_,
                fmt::format("at {} the load vanishes, or passes through zero before the next row, "
                            "and nothing tells where a journal without mass then is; give "
                            "load_cycle.journal_mass, the mass that the film carries",
                            table_.written(rows_[*row].line, when_)));
  }

 private:
  void expect_columns() const {
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
                      kExample));
    }
    static_cast<void>(table_.column(polar ? "load" : "load_x"));
    static_cast<void>(table_.column(polar ? "direction" : "load_y"));
  }

  void make_rows(double scale) {
    const bool polar = table_.has("load");
    const auto& a = table_.column(polar ? "load" : "load_x");
    const auto& b = table_.column(polar ? "direction" : "load_y");
    const auto& when = table_.column(when_);
    for (std::size_t k = 0; k < table_.rows(); ++k) {
      Row row;
      row.t = when[k] * scale;
      row.line = k;
      row.load.x = polar ? a[k] * std::cos(b[k]) : a[k];
      row.load.y = polar ? a[k] * std::sin(b[k]) : b[k];
      if (table_.has("speed")) row.load.omega = table_.column("speed")[k];
      rows_.push_back(row);
    }
  }

  void expect_order(double period, LoadInterpolation interpolation) const {
    int at_once = 1;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const std::string here = table_.written(k, when_);
      if (rows_[k].t < 0.0 || rows_[k].t > period * (1.0 + kSameTime)) {
        table_.fail(k, when_,
                    fmt::format("{} lies out of the period, which begins at 0; give one "
                                "period, or correct load_cycle.period",
                                here));
      }
      if (k == 0) continue;
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
    if (period == kInfinite && rows_.front().t > 0.0) {
      table_.fail(0, when_,
                  fmt::format("a single event begins at 0, not at {}; shift the column, or "
                              "give load_cycle.period",
                              table_.written(0, when_)));
    }
  }

  /// Rows from 0 on to before the end of the period, which is the first row again.
  void close(double period, LoadInterpolation interpolation) {
    const bool from_zero = rows_.front().t <= kSameTime * period;
    const auto at_end = [&] { return rows_.back().t >= period * (1.0 - kSameTime); };
    if (from_zero) rows_.front().t = 0.0;
    if (at_end()) {
      if (from_zero) {
        expect_periodic();
        rows_.pop_back();
      }
      if (at_end()) move_to_front();
    } else if (!from_zero) {
      begin_at_zero(period, interpolation);
    }
  }

  void expect_periodic() const {
    const Row& a = rows_.front();
    const Row& b = rows_.back();
    double load = 0.0;
    double speed = 0.0;
    for (const Row& row : rows_) {
      load = std::max(load, std::hypot(row.load.x, row.load.y));
      speed = std::max(speed, std::abs(row.load.omega));
    }
    const double jump = std::hypot(a.load.x - b.load.x, a.load.y - b.load.y);
    const double turn = a.load.omega - b.load.omega;
    if (jump <= kSameLoad * load && std::abs(turn) <= kSameLoad * speed) return;
    const std::string what = jump > kSameLoad * load
                                 ? fmt::format("the load jumps by {:.4g} N", jump)
                                 : fmt::format("the speed jumps by {:.4g} rad/s", std::abs(turn));
    table_.fail(b.line, when_,
                fmt::format("the table is not periodic: from {} back to {} {}; make the last row "
                            "equal to the first, or leave it out; a jump that is meant has two "
                            "rows at 0",
                            table_.written(b.line, when_), table_.written(a.line, when_), what));
  }

  /// A row at the end of the period holds at its beginning, before all others there.
  void move_to_front() {
    Row row = rows_.back();
    row.t = 0.0;
    rows_.pop_back();
    rows_.insert(rows_.begin(), row);
  }

  /// Adds the row at 0 that lies on the straight line from the last row to the first.
  void begin_at_zero(double period, LoadInterpolation interpolation) {
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

  CsvTable table_;
  bool angle_;
  std::string when_;  ///< name of the first column
  std::vector<Row> rows_;
};

LoadInterpolation read_interpolation(const Section& section, bool periodic) {
  if (!section.has("interpolation")) return LoadInterpolation::linear;
  const auto chosen = section.choice<LoadInterpolation>(
      "interpolation", {{"linear", LoadInterpolation::linear},
                        {"periodic_spline", LoadInterpolation::periodic_spline}});
  if (chosen == LoadInterpolation::periodic_spline && !periodic) {
    section.fail("interpolation",
                 "a periodic spline needs a period; add for example period = \"720 deg\", or write "
                 "\"linear\"");
  }
  return chosen;
}

void read_mass_and_step(const Section& file, const Section& section, double omega, LoadCycle& c) {
  c.journal_mass = section.maybe_quantity("journal_mass", kMass, kNotNegative).value_or(0.0);
  const auto step = maybe_extent(section, "step");
  if (!step) return;
  c.step = step->angle ? step->value / crank_speed(file, omega, "load_cycle.step is a crank angle")
                       : step->value;
}

LoadCycle cycle_of_table(const Section& file, const Section& section, double omega) {
  const auto period = maybe_extent(section, "period");
  const LoadInterpolation interpolation = read_interpolation(section, period.has_value());
  LoadTable table(table_beside(section, "file"));
  const bool angle = table.told_in_angle();
  if (period && period->angle != angle) {
    section.fail("period",
                 fmt::format("the period is {}, but the table has a column {}; give both in crank "
                             "angle or both in time",
                             period->angle ? "a crank angle" : "a time", angle ? "angle" : "time"));
  }
  const double speed =
      angle ? crank_speed(file, omega, "the load's table is told in crank angle") : 0.0;
  const double scale = angle ? 1.0 / speed : 1.0;
  LoadCycle c = table.cycle(scale, period ? period->value * scale : kInfinite, interpolation);
  c.crank_speed = speed;
  read_mass_and_step(file, section, omega, c);
  table.expect_mass(c);
  return c;
}

LoadCycle cycle_of_crank(const Section& file, const std::optional<Section>& section, double omega) {
  std::optional<double> period;
  if (section) {
    for (const char* key : {"file", "interpolation"}) {
      if (!section->has(key)) continue;
      section->fail(key, "the load comes from [crank]; take one of the two out");
    }
    if (const auto given = maybe_extent(*section, "period")) {
      if (!given->angle) section->fail("period", "with [crank] the period is 360 deg or 720 deg");
      period = given->value;
    }
  }
  const Section crank_section = file.section("crank");
  const Crank crank = read_crank(crank_section, period);
  static_cast<void>(crank_speed(file, omega, "[crank] tells the load by the crank's angle"));
  LoadCycle c = crank_load(crank, omega);
  if (section) read_mass_and_step(file, *section, omega, c);
  if (c.journal_mass <= 0.0 && vanishing_load(c)) {
    crank_section.fail("",
                       "the load of the big end vanishes or passes through zero, and nothing tells "
                       "where a journal without mass then is; give rod_mass, or "
                       "load_cycle.journal_mass");
  }
  return c;
}

enum class Frame { shell, rod };

Frame read_frame(const Section& file, const std::optional<Section>& section) {
  const bool crank = file.has("crank");
  if (!section || !section->has("frame")) return crank ? Frame::rod : Frame::shell;
  const Frame frame =
      section->choice<Frame>("frame", {{"shell", Frame::shell}, {"rod", Frame::rod}});
  if (frame == Frame::rod && !crank) {
    section->fail("frame",
                  "in the frame of a rod load and speed come from [crank], which is not given; add "
                  "it, or write \"shell\"");
  }
  if (frame == Frame::shell && crank) {
    section->fail("frame",
                  "[crank] gives the load in the frame of the rod; write \"rod\", or take [crank] "
                  "out");
  }
  return frame;
}

}  // namespace

std::optional<LoadCycle> read_load_cycle(const Section& file, double omega) {
  if (!file.has("load_cycle") && !file.has("crank")) return std::nullopt;
  const auto section = file.maybe_section("load_cycle");
  if (section) {
    section->only({"file", "period", "interpolation", "journal_mass", "frame", "step"},
                  "[load_cycle]");
  }
  if (read_frame(file, section) == Frame::rod) return cycle_of_crank(file, section, omega);
  return cycle_of_table(file, *section, omega);
}

}  // namespace shellback::app
