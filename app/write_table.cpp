#include "app/write_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "app/labels/indistinct.hpp"
#include "app/labels/quantity_label.hpp"
#include "app/labels/table_parts.hpp"
#include "app/labels/text_table.hpp"
#include "app/labels/tolerance_words.hpp"
#include "app/words/effect_words.hpp"
#include "app/words/note_words.hpp"
#include "app/write_coefficients.hpp"
#include "core/constants.hpp"
#include "fidelity/grid_error.hpp"

namespace shellback::app {
namespace {

using bearing::Case;
using bearing::Comparison;
using bearing::Result;

void print_effects(std::ostream& out, const Result& result) {
  if (result.effects.empty()) return;
  out << "\neffects\n";
  std::size_t width = 0;
  for (const auto& e : result.effects) {
    width = std::max(width, std::string_view(name_of(e.kind)).size());
  }
  for (const auto& e : result.effects) {
    out << fmt::format("  {:<{}}  {:<3}  {:>8}  {}\n", name_of(e.kind), width,
                       e.included ? "in" : "out", figures(e.indicator, 3), meaning_of(e));
  }
}

std::string change(double value) {
  return std::isfinite(value) ? fmt::format("{:+.2f} %", 100.0 * value) : "";
}

/// What tier `auto` chose, and what each effect is worth.
void print_choice(std::ostream& out, const Result& result) {
  if (!result.choice) return;
  const auto& c = *result.choice;
  out << fmt::format("\nchosen by auto for {:.3g} %: {}; friction torque {}, smallest film {}\n",
                     100.0 * c.tolerance, c.met ? "met" : "NOT MET", known_within(c.bar_friction),
                     known_within(c.bar_h_min));
  const bool led_on =
      std::any_of(result.assumptions.begin(), result.assumptions.end(), [](const auto& note) {
        return std::holds_alternative<bearing::note::ScalarsOfFinerGrid>(note);
      });
  if (led_on) {
    out << fmt::format(
        "  That is on {} x {} cells, the finest meant; the bars above go on to ever finer ones.\n",
        fidelity::kFineGrid[0], fidelity::kFineGrid[1]);
  }
  TextTable table;
  table.add({"  effect", "", "indicator", "friction torque", "smallest film"});
  for (const auto& e : result.effects) {
    table.add({std::string("  ") + name_of(e.kind), e.included ? "in" : "out",
               figures(e.indicator, 3), change(e.change_in_friction), change(e.change_in_h_min)});
  }
  table.print(out);
  out << "  Changes by the effect alone, on the coarsest grid, temperatures held.\n";
}

void print_quantities(std::ostream& out, const bearing::Measured& measured,
                      const std::vector<Result>& results) {
  const auto rows = quantity_rows(measured, results);
  const auto has_measured = [](const auto& row) { return row.measured.has_value(); };
  const bool with_measured = std::any_of(rows.begin(), rows.end(), has_measured);
  const bool single = results.size() == 1;
  const bool with_bars = std::any_of(rows.begin(), rows.end(), has_bars);
  const bool with_limit = single && std::any_of(rows.begin(), rows.end(), [](const auto& row) {
                            return std::isfinite(row.bars.front().limit);
                          });
  const bool with_time = single && std::any_of(rows.begin(), rows.end(), [](const auto& row) {
                           return row.bars.front().time > 0.0;
                         });
  TextTable table;
  std::vector<std::string> head{"quantity"};
  const auto names = column_names(results);
  for (std::size_t k = 0; k < names.size(); ++k) {
    head.push_back(names[k] + (results[k].verdict.good() ? "" : " (FAILED)"));
    if (with_bars && single) head.emplace_back("+- grid");
    if (with_time) head.emplace_back("+- time");
    if (with_bars && single) head.emplace_back("+- model");
    if (with_bars && !single) head.emplace_back("+-");
  }
  if (with_limit) head.emplace_back("extrapolated");
  head.emplace_back("unit");
  if (with_measured) head.emplace_back("measured");
  if (with_measured && single) head.emplace_back("difference");
  table.add(head);
  table.rule();
  for (const auto& row : rows) {
    std::vector<std::string> cells{row.label};
    for (std::size_t k = 0; k < row.values.size(); ++k) {
      cells.push_back(row.values[k] ? figures(*row.values[k]) : "");
      const ShownBars& bars = row.bars[k];
      if (with_bars && single) cells.push_back(bar_figures(bars.grid));
      if (with_time) cells.push_back(bar_figures(bars.time));
      if (with_bars && single) cells.push_back(bar_figures(bars.model));
      if (with_bars && !single) cells.push_back(bar_figures(bars.total));
    }
    if (with_limit) {
      const double limit = row.bars.front().limit;
      cells.push_back(std::isfinite(limit) ? figures(limit) : "");
    }
    cells.push_back(row.unit.unit);
    if (row.measured) cells.push_back(figures(*row.measured));
    if (row.measured && single) {
      cells.push_back(row.values[0] ? difference(row.unit, *row.values[0], *row.measured) : "");
    }
    table.add(cells);
  }
  table.print(out);
}

void print_split(std::ostream& out, const Comparison& comparison) {
  if (comparison.split.steps.empty()) return;
  const auto split = against_the_motion(comparison.split);
  out << "\nfriction torque against the motion, isothermal to full [N m]\n";
  TextTable table;
  table.add({"  isothermal at T_equivalent", figures(split.from)});
  for (const auto& step : split.steps) {
    table.add({"  " + step.name, signed_change(split, step.change),
               difference({}, split.from + step.change, split.from)});
  }
  const double rest = unexplained(split);
  if (std::abs(rest) > kNegligibleRest * std::max(std::abs(split.from), std::abs(split.to))) {
    table.add({"  not accounted for", signed_change(split, rest),
               difference({}, split.from + rest, split.from)});
  }
  table.add({"  full", figures(split.to), difference({}, split.to, split.from)});
  table.print(out);
  out << "  Substituted one after another in this order; another order would share the\n"
         "  difference out differently. Percentages are of the isothermal torque.\n";
}

void print_tolerance(std::ostream& out, const Case& c, const Missed& missed) {
  const auto lines = tolerance_lines(c, missed);
  if (!lines.empty()) out << '\n';
  for (const std::string& line : lines) out << line << '\n';
}

/// What each of several supplies feeds: of one the quantities tell it.
void print_supplies(std::ostream& out, const Result& result) {
  if (result.supplies.size() < 2) return;
  const DisplayUnit unit = display_unit("supply_flow", "m3/s");
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < result.supplies.size(); ++k) {
    const bearing::SupplyState& s = result.supplies[k];
    std::string line =
        fmt::format("supply.{}: {} {} into the film", k, figures(unit(s.flow)), unit.unit);
    if (std::isfinite(s.T_mixed)) {
      line += fmt::format(", its oil mixed to {:.1f} degC", s.T_mixed - kZeroCelsius);
    }
    lines.push_back(line);
  }
  print_list(out, "supplies", lines);
}

void print_table(std::ostream& out, const Case* c, const Result& result) {
  const bearing::Measured measured = c != nullptr ? c->measured : bearing::Measured{};
  out << result.title << '\n';
  if (c != nullptr) print_scene(out, *c);
  out << "tier " << to_string(result.tier) << ", " << status_line(result) << "\n\n";
  print_failure(out, to_string(result.tier), result);
  print_quantities(out, measured, {result});
  if (c != nullptr) print_tolerance(out, *c, missed_tolerance(*c, result));
  if (const std::string open = undetermined_words(result); !open.empty()) out << open << '\n';
  print_coefficients(out, result);
  print_supplies(out, result);
  const auto& a = result.audit;
  out << fmt::format("\naudit (relative)  mass {}  energy {}  load {}  moment {}\n",
                     audit_figure(a.mass), audit_figure(a.energy), audit_figure(a.load),
                     audit_figure(a.moment));
  if (result.choice) {
    print_choice(out, result);
  } else {
    print_effects(out, result);
  }
  print_limiters(out, {result});
  print_list(out, "warnings", words_of(result.warnings));
  print_list(out, "assumptions", words_of(result.assumptions));
  print_cost(out, result);
  out << '\n';
  print_failure(out, to_string(result.tier), result);
}

void print_checks(std::ostream& out, const Comparison& comparison) {
  const auto names = column_names(comparison.results);
  out << '\n';
  TextTable table;
  table.add({"audit (relative)", "mass", "energy", "load", "moment", "outer its", "time [s]"});
  table.rule();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto& a = comparison.results[i].audit;
    const auto& k = comparison.results[i].cost;
    table.add({names[i], audit_figure(a.mass), audit_figure(a.energy), audit_figure(a.load),
               audit_figure(a.moment), std::to_string(k.outer_iterations), figures(k.wall_s, 3)});
  }
  table.print(out);
}

}  // namespace

void write_table(std::ostream& out, const Case& c, const Result& result) {
  print_table(out, &c, result);
}

void write_table(std::ostream& out, const Result& result) { print_table(out, nullptr, result); }

void write_comparison_table(std::ostream& out, const Case& c, const Comparison& comparison) {
  const auto& results = comparison.results;
  const auto names = column_names(results);
  out << c.title << '\n';
  print_scene(out, c);
  out << '\n';
  for (std::size_t i = 0; i < results.size(); ++i) print_failure(out, names[i], results[i]);
  print_quantities(out, c.measured, results);
  if (std::any_of(results.begin(), results.end(),
                  [](const Result& r) { return r.cost.bars_s > 0.0; })) {
    out << (c.cycle
                ? "\n+- is the bar of the grid and of the steps in time, of tier estimate of the "
                  "physics, too; what\nphysics is worth is what the columns differ by.\n"
                : "\n+- is the bar of the grid and of the physics left out together; where the "
                  "physics cannot be\njudged, of the grid alone.\n");
  }
  print_list(out, "cannot be told apart on this grid (their difference is within its bars)",
             indistinct_words(comparison));
  print_tolerance(out, c, missed_tolerance(c, comparison));
  for (const Result& r : comparison.results) {
    const std::string open = undetermined_words(r);
    if (!open.empty()) out << to_string(r.tier) << ": " << open << '\n';
  }
  print_split(out, comparison);
  if (!comparison.split.steps.empty())
    out << '\n' << calibration_words(comparison, Writing::plain) << '\n';
  print_checks(out, comparison);
  if (!results.empty()) print_effects(out, results.back());
  print_limiters(out, results);
  print_list(out, "warnings",
             lines_of_columns(results, [](const Result& r) { return words_of(r.warnings); }));
  print_list(out, "assumptions",
             lines_of_columns(results, [](const Result& r) { return words_of(r.assumptions); }));
  out << '\n';
  for (std::size_t i = 0; i < results.size(); ++i) print_failure(out, names[i], results[i]);
}

}  // namespace shellback::app
