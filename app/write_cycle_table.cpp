#include "app/write_cycle_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ostream>

#include "app/labels/cycle_shown.hpp"
#include "app/labels/table_parts.hpp"
#include "app/labels/text_table.hpp"
#include "app/labels/tolerance_words.hpp"
#include "app/words/note_words.hpp"

namespace shellback::app {
namespace {

using bearing::CycleQuantity;
using bearing::CycleResult;

void print_quantities(std::ostream& out, const bearing::Measured& measured,
                      const CycleResult& cycle) {
  const bool known = is_measured(measured, cycle);
  const bool bars =
      std::any_of(cycle.quantities.begin(), cycle.quantities.end(),
                  [](const CycleQuantity& q) { return std::isfinite(q.quantity.error()); });
  const bool physics =
      std::any_of(cycle.quantities.begin(), cycle.quantities.end(),
                  [](const CycleQuantity& q) { return std::isfinite(q.quantity.error_model); });
  TextTable table;
  std::vector<std::string> head{"quantity", "value"};
  if (bars) head.insert(head.end(), {"+- grid", "+- time"});
  if (physics) head.emplace_back("+- physics");
  head.insert(head.end(), {"unit", fmt::format("at [{}]", told_unit(cycle))});
  if (known) head.insert(head.end(), {"measured", "difference"});
  table.add(head);
  table.rule();
  for (const CycleQuantity& q : cycle.quantities) {
    const DisplayUnit unit = cycle_unit(q);
    std::vector<std::string> cells{cycle_label(q), figures(unit(q.quantity.value))};
    if (bars) {
      cells.push_back(bar_figures(unit.scale * q.quantity.error_grid));
      cells.push_back(bar_figures(unit.scale * q.quantity.error_time));
    }
    if (physics) cells.push_back(bar_figures(unit.scale * q.quantity.error_model));
    cells.push_back(unit.unit);
    cells.push_back(std::isfinite(q.at) ? figures(shown_instant(cycle, q.at)) : "");
    if (const auto si = measured_value(measured, q.quantity)) {
      cells.push_back(figures(unit(*si)));
      cells.push_back(difference(unit, unit(q.quantity.value), unit(*si)));
    }
    table.add(cells);
  }
  table.print(out);
}

}  // namespace

void write_cycle_table(std::ostream& out, const bearing::Case& c, const CycleResult& cycle) {
  const bearing::Result head = head_of(cycle);
  const std::string tier = to_string(cycle.tier);
  out << cycle.title << '\n';
  print_scene(out, c);
  out << "load cycle, tier " << tier << ", " << status_line(head) << "\n\n";
  print_failure(out, tier, head, meaning_of_the_rest(cycle));
  if (!cycle.quantities.empty()) {
    print_quantities(out, c.measured, cycle);
    out << '\n';
  }
  if (cycle.choice) {
    out << choice_words(*cycle.choice) << '\n';
  } else {
    for (const std::string& line :
         tolerance_lines(c, missed_tolerance(c, bearing::as_result(cycle)))) {
      out << line << '\n';
    }
  }
  const std::string open = undetermined_words(bearing::as_result(cycle));
  if (!open.empty()) out << open << '\n';
  out << how_it_ran(c, cycle) << '\n';
  out << "audit (relative)  " << audit_words(cycle) << '\n';
  print_limiters(out, {head});
  print_list(out, "warnings", words_of(cycle.warnings));
  print_list(out, "assumptions", words_of(cycle.assumptions));
  print_cost(out, head);
}

}  // namespace shellback::app
