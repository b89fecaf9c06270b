#include "app/labels/table_parts.hpp"

#include <fmt/format.h>

#include <cmath>
#include <ostream>

#include "app/labels/command_words.hpp"
#include "app/labels/quantity_label.hpp"
#include "app/words/effect_words.hpp"
#include "app/words/ending_words.hpp"

namespace shellback::app {

using bearing::Case;
using bearing::Result;

std::string audit_figure(double value) {
  return std::isfinite(value) ? fmt::format("{:.1e}", value) : "n/a";
}

void print_failure(std::ostream& out, const std::string& name, const Result& result,
                   const std::string& meaning) {
  if (result.verdict.good()) return;
  const EndingWords words = words_of(result.verdict);
  out << fmt::format("*** {}: {} ***\n", name, status_line(result));
  if (!words.reason.empty()) out << "    reason: " << words.reason << '\n';
  if (!words.place.empty()) out << "    place:  " << words.place << '\n';
  if (!words.cure.empty()) out << "    cure:   " << words.cure << '\n';
  out << "    " << meaning << "\n\n";
}

void print_list(std::ostream& out, const char* heading, const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  out << '\n' << heading << '\n';
  for (const auto& line : lines) out << "  - " << line << '\n';
}

void print_limiters(std::ostream& out, const std::vector<Result>& results) {
  const auto names = column_names(results);
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < results.size(); ++k) {
    for (const auto& l : results[k].limiters) {
      lines.push_back(fmt::format("{}: {}, {} times", names[k], words_of(l.what), l.count));
    }
  }
  print_list(out, "limiters that acted", lines);
}

void print_cost(std::ostream& out, const Result& result) {
  const auto& k = result.cost;
  if (result.tier == bearing::Tier::estimate) {
    out << fmt::format("\nno film was solved: no grid, {} s\n", figures(k.wall_s, 3));
    return;
  }
  out << fmt::format(
      "\ngrid {} x {}, {} outer iterations, {} Newton iterations, {} factorizations, {} s",
      result.grid[0], result.grid[1], k.outer_iterations, k.newton_iterations, k.factorizations,
      figures(k.wall_s, 3));
  if (k.setup_s > 0.0)
    out << fmt::format(" (of it {} s set-up of the solids)", figures(k.setup_s, 3));
  if (k.bars_s > 0.0) out << fmt::format(", and {} s for the error bars", figures(k.bars_s, 3));
  out << '\n';
}

void print_scene(std::ostream& out, const Case& c) {
  out << describe_case(c, Writing::plain) << '\n';
  const std::string changes = describe_changes(c);
  if (!changes.empty()) out << changes << '\n';
}

}  // namespace shellback::app
