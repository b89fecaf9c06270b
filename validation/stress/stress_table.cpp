#include "validation/stress/stress_table.hpp"

#include <fmt/format.h>

#include "validation/stress/stress_refusal.hpp"
#include "validation/stress/stress_words.hpp"

namespace shellback::validation {
namespace {

constexpr const char* kLegend =
    "`ok` converged and audited · `none` refused as having no steady state, and nobody found one · "
    "`inp` refused as input · `?` not found, by nobody · `conv` differs by convention alone · "
    "`MISS` not found, but there is one · `REFUSAL` refused as having no steady state, but there "
    "is "
    "one · `WRONG` · `NaN` · `CRASH` · `HANG` · `·` does not apply\n";

constexpr std::size_t kLongReason = 160;  ///< of a reason on the page [characters]

/// For Markdown table cells.
std::string cell_text(std::string text) {
  for (char& c : text) {
    if (c == '|' || c == '\n') c = ' ';
  }
  return text;
}

/// The mark without its style.
std::string in_plain(StressClass c) {
  std::string mark = stress_mark(c);
  const std::size_t word = mark.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ");
  if (!mark.ends_with("**")) return mark;
  return mark.substr(word, mark.size() - word - 2);
}

/// Rows of counts, one per method.
std::string counts(const StressMap& map) {
  std::string out = "| method | cells |";
  for (const StressClass c : kStressClasses) out += fmt::format(" {} |", to_string(c));
  out += "\n|---|---:|" + std::string("---:|");
  for (std::size_t k = 1; k < kStressClasses.size(); ++k) out += "---:|";
  out += "\n";
  const auto& methods = stress_methods();
  for (std::size_t m = 0; m < methods.size(); ++m) {
    int all = 0;
    std::string line;
    for (const StressClass c : kStressClasses) {
      all += map.count(m, c);
      line += fmt::format(" {} |", map.count(m, c));
    }
    if (all == 0) continue;
    const char* weight = methods[m].shipped ? "**" : "";
    out += fmt::format("| {0}{1}{0} | {2} |{3}\n", weight, methods[m].title, all, line);
  }
  return out;
}

std::string row_line(const StressRow& row, std::size_t m) {
  std::string line =
      fmt::format("| {} | {} |", to_string(row.scene.tier), stress_methods()[m].title);
  for (const StressCell& cell : row.cells[m])
    line += fmt::format(" {} |", stress_mark(cell.result));
  return line + "\n";
}

bool was_run(const std::vector<StressCell>& cells) {
  for (const StressCell& cell : cells) {
    if (cell.result != StressClass::not_run) return true;
  }
  return false;
}

/// Who was asked about a refusal that nobody contradicts.
std::string nobody_else(const StressRow& row, std::size_t step) {
  const StressClass c = row.cells.front()[step].result;
  if (c != StressClass::no_steady_state && c != StressClass::not_found) return "";
  const Witnesses asked = witnesses_of(row, step);
  const std::string coarser = overruled_by_finer(row, step);
  std::string but = coarser.empty() ? "" : "; " + coarser + " converges, the finer refuses";
  for (const std::string& faulty : asked.faulty) but += "; " + faulty;
  if (asked.silent == 0 && asked.faulty.empty()) return " (nobody else asked)";
  return fmt::format(" ({} other{} found none either{})", asked.silent,
                     asked.silent == 1 ? "" : "s", but);
}

/// What ended the default's row, value by value.
std::string endings(const StressRow& row) {
  std::string out;
  for (std::size_t k = 0; k < row.scene.steps.size(); ++k) {
    const StressCell& cell = row.cells.front()[k];
    if (cell.result == StressClass::converged || cell.result == StressClass::not_run) continue;
    out += fmt::format(
        "- {}, {}: {}{}: {}\n", to_string(row.scene.tier), row.scene.steps[k].label,
        is_fault(cell.result) ? std::string(stress_mark(cell.result)) + " " : std::string(),
        to_string(cell.result) + nobody_else(row, k), cell_text(in_short(cell.why, kLongReason)));
  }
  return out;
}

/// What physics is known to have in store, by tier.
std::string known_beforehand(const StressMap& map, const std::string& name) {
  std::string out;
  for (const StressRow& row : map.rows) {
    if (row.scene.name != name || row.scene.expects.words.empty()) continue;
    out += fmt::format("{}{}: {}", out.empty() ? " Judged by: " : ", ", to_string(row.scene.tier),
                       row.scene.expects.words);
  }
  return out.empty() ? out : out + ".";
}

/// How many differences of friction are ones of convention.
std::string conventions(const StressMap& map) {
  std::string out;
  for (std::size_t m = 0; m < stress_methods().size(); ++m) {
    if (map.count_conventions(m) == 0) continue;
    out += fmt::format(
        "\n{}: in {} cells the friction torque differs by a convention alone (the cavitated film "
        "is "
        "sheared in full); with the same convention it agrees. What else is wrong there stands in "
        "the cell.\n",
        stress_methods()[m].title, map.count_conventions(m));
  }
  return out;
}

}  // namespace

std::string stress_page(const StressMap& map, const std::string& picture,
                        const std::string& command) {
  std::string out = "# Stability map\n\n";
  out += fmt::format("Made by `{}`; not written by hand.\n\n", command);
  if (!map.complete) out += "**Stopped before the end: cells are missing.**\n\n";
  if (!picture.empty()) out += fmt::format("![Stability map]({})\n\n", picture);
  out += "## Counts\n\n" + faults_in_words(map) + ".\n\n" + counts(map) + conventions(map);
  out += std::string("\n## Scenes\n\n") + kLegend;
  std::string before;
  for (std::size_t r = 0; r < map.rows.size(); ++r) {
    const StressRow& row = map.rows[r];
    if (row.scene.name != before) {
      before = row.scene.name;
      out += fmt::format("\n### {}: {}\n\nDriven: {}. Expected: {}.{}\n\n| tier | method |",
                         row.scene.name, row.scene.title, row.scene.axis, row.scene.expect,
                         known_beforehand(map, row.scene.name));
      for (const StressStep& step : row.scene.steps) out += fmt::format(" {} |", step.label);
      out += "\n|---|---|";
      for (std::size_t k = 0; k < row.scene.steps.size(); ++k) out += "---|";
      out += "\n";
      for (std::size_t s = r; s < map.rows.size() && map.rows[s].scene.name == before; ++s) {
        for (std::size_t m = 0; m < map.rows[s].cells.size(); ++m) {
          if (was_run(map.rows[s].cells[m])) out += row_line(map.rows[s], m);
        }
      }
      out += "\n";
    }
    out += endings(row);
  }
  return out;
}

std::string stress_summary(const StressMap& map) {
  std::string out = fmt::format("{:<28}", "cells");
  for (const StressClass c : kStressClasses) out += fmt::format(" {:>9.9}", in_plain(c));
  out += "\n";
  for (std::size_t m = 0; m < stress_methods().size(); ++m) {
    int all = 0;
    std::string line;
    for (const StressClass c : kStressClasses) {
      all += map.count(m, c);
      line += fmt::format(" {:>9}", map.count(m, c));
    }
    if (all > 0) out += fmt::format("{:<28}{}\n", stress_methods()[m].title, line);
  }
  return out + "\n" + faults_in_words(map) + "\n";
}

}  // namespace shellback::validation
