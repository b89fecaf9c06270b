#include "app/write_sweep_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>

#include "app/labels/command_words.hpp"
#include "app/labels/indistinct.hpp"
#include "app/labels/quantity_label.hpp"
#include "app/labels/sweep_columns.hpp"
#include "app/labels/text_table.hpp"
#include "app/labels/tolerance_words.hpp"
#include "app/reading/sweep_case.hpp"
#include "app/words/ending_words.hpp"

namespace shellback::app {

using study::Sweep;
using study::SweepPoint;

namespace {

/// Shown on the screen, in this order, with their heads; the files hold all.
struct Shown {
  const char* name;
  const char* head;
  bool with_bar = false;  ///< those by which bearings are judged; more would not fit a line
};
constexpr std::array kShown{Shown{"friction_torque", "torque", true},
                            Shown{"friction_torque_asperity", "asperities"},
                            Shown{"power_loss", "power"},
                            Shown{"h_min", "h_min", true},
                            Shown{"p_max", "p_max", true},
                            Shown{"eccentricity_ratio", "ecc. ratio"},
                            Shown{"side_flow", "side flow"},
                            Shown{"T_film_max", "T film max", true},
                            Shown{"T_shell_back", "T back"}};
/// And in a table of its own, where they are wanted.
constexpr std::array kCoefficients{
    Shown{"K_xx", "Kxx"},
    Shown{"K_xy", "Kxy"},
    Shown{"K_yx", "Kyx"},
    Shown{"K_yy", "Kyy"},
    Shown{"C_xx", "Cxx"},
    Shown{"C_xy", "Cxy"},
    Shown{"C_yx", "Cyx"},
    Shown{"C_yy", "Cyy"},
    Shown{"whirl_critical_mass", "critical mass"},
    Shown{"whirl_ratio", "whirl ratio"},
};

struct Column {
  SweepQuantity quantity;
  DisplayUnit unit;
  double round_off = 0.0;  ///< what is smaller is shown as 0 [SI]
  std::string head;
  bool with_bar = false;
};

template <std::size_t N>
std::vector<Column> columns_of(const Sweep& sweep, const std::array<Shown, N>& wanted) {
  constexpr double kRoundOff = 1e-9;  // of the largest value of the column [-]
  const auto all = sweep_quantities(sweep);
  std::vector<Column> columns;
  for (const Shown& shown : wanted) {
    const auto it =
        std::find_if(all.begin(), all.end(), [&](const auto& q) { return q.name == shown.name; });
    if (it == all.end()) continue;
    double largest = 0.0;
    for (const SweepPoint& point : sweep.points) {
      const double value = value_at(point, *it);
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    }
    columns.push_back({*it, display_unit(it->name, it->unit, largest), kRoundOff * largest,
                       shown.head, shown.with_bar && it->with_error});
  }
  return columns;
}

void print_points(std::ostream& out, const Sweep& sweep, const std::vector<Column>& columns) {
  TextTable table(0);
  std::vector<std::string> names;
  std::vector<std::string> units;
  for (const auto& axis : sweep.axes) {
    names.push_back(axis.key.substr(axis.key.rfind('.') + 1));
    units.push_back(axis.unit);
  }
  for (const Column& column : columns) {
    names.push_back(column.head);
    units.push_back(column.unit.unit);
    if (!column.with_bar) continue;
    names.emplace_back("+-");
    units.emplace_back("");
  }
  names.emplace_back("status");
  table.add(names);
  table.add(units);
  table.rule();
  int last_curve = 0;
  for (const int index : reading_order(sweep)) {
    if (index % sweep.curves() != last_curve) table.add({" "});
    last_curve = index % sweep.curves();
    const SweepPoint& point = sweep.points[index];
    const std::vector<int> at = indices_of(sweep, index);
    std::vector<std::string> cells;
    for (std::size_t a = 0; a < at.size(); ++a) {
      const auto& axis = sweep.axes[a];
      cells.push_back(axis.numbers.empty() ? axis.words[at[a]]
                                           : fmt::format("{:.5g}", axis.numbers[at[a]]));
    }
    for (const Column& column : columns) {
      const double value = value_at(point, column.quantity);
      const bool round_off = std::abs(value) < column.round_off;
      cells.push_back(std::isfinite(value) ? figures(round_off ? 0.0 : column.unit(value)) : "");
      if (column.with_bar) {
        cells.push_back(bar_figures(column.unit.scale * error_at(point, column.quantity)));
      }
    }
    cells.push_back(point.good() ? "" : status_word(point));
    table.add(cells);
  }
  table.print(out);
}

/// What the bars hold, which points they leave open, whether they are what was asked for.
void print_bars(std::ostream& out, const bearing::Case& subject, const Sweep& sweep) {
  const auto known = [](const SweepPoint& point) {
    return point.good() && point.result.cost.bars_s > 0.0;
  };
  if (std::any_of(sweep.points.begin(), sweep.points.end(), known)) {
    const bool estimates = std::any_of(sweep.points.begin(), sweep.points.end(), [](const auto& p) {
      return p.good() && p.result.tier == bearing::Tier::estimate;
    });
    out << "\n+- is the bar of the grid"
        << (subject.cycle ? " and of the steps in time"
                          : " (with --bars: and of the physics left out)")
        << (estimates ? "; of tier estimate also of the physics that it leaves out" : "") << ".\n";
  }
  const auto open = indistinct_words(sweep);
  if (!open.empty()) {
    out << "\ncannot be told apart on their grids (their difference is within the bars)\n";
    for (const std::string& line : open) out << "  - " << line << '\n';
  }
  const auto lines = tolerance_lines(subject, missed_tolerance(subject, sweep));
  if (!lines.empty()) out << '\n';
  for (const std::string& line : lines) out << line << '\n';
}

void print_failures(std::ostream& out, const Sweep& sweep) {
  for (const int index : reading_order(sweep)) {
    const SweepPoint& point = sweep.points[index];
    const Verdict& verdict = point.result.verdict;
    if (!point.tried() || point.good() || verdict.status == Status::interrupted) continue;
    const EndingWords words = words_of(verdict);
    const std::vector<int> at = indices_of(sweep, index);
    out << fmt::format(
        "\nnot solved at {} ({} tries)\n  {}: {}\n",
        position_words(sweep.axes, {static_cast<double>(at.front()), {at.begin() + 1, at.end()}}),
        point.tries, to_string(verdict.status), words.reason);
    if (!words.place.empty()) out << "  where: " << words.place << '\n';
    if (!words.cure.empty()) out << "  cure:  " << words.cure << '\n';
  }
}

void print_audit(std::ostream& out, const Sweep& sweep) {
  using Audit = bearing::Audit;
  const auto worst = [&](double Audit::*member) {
    double largest = NAN;
    for (const SweepPoint& point : sweep.points) {
      if (point.good()) largest = std::fmax(largest, point.result.audit.*member);
    }
    return std::isfinite(largest) ? fmt::format("{:.1e}", largest) : std::string("n/a");
  };
  out << fmt::format("\nlargest imbalances (relative)  mass {}  energy {}  load {}  moment {}\n",
                     worst(&Audit::mass), worst(&Audit::energy), worst(&Audit::load),
                     worst(&Audit::moment));
}

void print_warnings(std::ostream& out, const Sweep& sweep) {
  constexpr std::size_t kShownWarnings = 8;  // numbers in them differ from point to point
  const auto warnings = sweep_warnings(sweep);
  if (warnings.empty()) return;
  out << "\nwarnings\n";
  for (std::size_t k = 0; k < std::min(warnings.size(), kShownWarnings); ++k) {
    out << "  - " << warnings[k] << '\n';
  }
  if (warnings.size() > kShownWarnings) {
    out << fmt::format("  and {} more, point by point in the JSON (--json)\n",
                       warnings.size() - kShownWarnings);
  }
  out << '\n';
}

void print_sweep_cost(std::ostream& out, const Sweep& sweep) {
  int tries = 0;
  int outer = 0;
  int newton = 0;
  double bars = 0.0;
  for (const SweepPoint& point : sweep.points) {
    tries += point.tries;
    outer += point.result.cost.outer_iterations;
    newton += point.result.cost.newton_iterations;
    bars += point.result.cost.bars_s;
  }
  out << fmt::format(
      "{} tries, {} outer and {} Newton iterations in those that converged, {} s on "
      "{} thread{}{}\n",
      tries, outer, newton, figures(sweep.wall_s, 3), sweep.threads, sweep.threads == 1 ? "" : "s",
      bars > 0.0 ? fmt::format(" (the error bars took {} s of it, added over the threads; "
                               "--no-bars leaves them out)",
                               figures(bars, 3))
                 : "");
}

}  // namespace

void write_sweep_table(std::ostream& out, const bearing::Case& subject, const Sweep& sweep) {
  out << subject.title << '\n' << describe_subject(subject, sweep, Writing::plain) << '\n';
  const std::string changes = describe_changes(subject);
  if (!changes.empty()) out << changes << '\n';
  for (const auto& axis : sweep.axes) out << axis_words(axis) << '\n';
  out << count_words(sweep) << "\n\n";
  print_points(out, sweep, columns_of(sweep, kShown));
  const std::vector<Column> coefficients = columns_of(sweep, kCoefficients);
  if (!coefficients.empty()) {
    out << "\nlinear coefficients, force on the journal = -K x - C dx/dt, x right, y up; a rigid "
           "rotor's whirl\n\n";
    print_points(out, sweep, coefficients);
  }
  print_bars(out, subject, sweep);
  print_failures(out, sweep);
  print_audit(out, sweep);
  print_warnings(out, sweep);
  print_sweep_cost(out, sweep);
}

}  // namespace shellback::app
