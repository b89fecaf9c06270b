#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <set>

#include "app/text_table.hpp"
#include "proof/honesty_report.hpp"

namespace shellback::proof {

using coupling::Tier;

namespace {

std::string percent(double part) {
  return std::isfinite(part) ? fmt::format("{:.1f} %", 100.0 * part) : "-";
}

std::string ratio(double value) { return std::isnan(value) ? "-" : fmt::format("{:.2f}", value); }

/// Median of the cost of the bars over that of the solve.
std::string cost_ratio(const std::vector<BarCost>& costs, std::array<int, 2> grid, Tier tier) {
  std::vector<double> ratios;
  for (const BarCost& c : costs) {
    if (c.tier == tier && c.grid == grid && c.solve_s > 0.0) ratios.push_back(c.bars_s / c.solve_s);
  }
  if (ratios.empty()) return "-";
  std::nth_element(ratios.begin(), ratios.begin() + static_cast<long>(ratios.size() / 2),
                   ratios.end());
  return fmt::format("{:.2f}", ratios[ratios.size() / 2]);
}

std::vector<std::string> cells(const std::string& first, const std::string& second,
                               const std::vector<BarSample>& samples) {
  const Coverage grid = coverage_of(samples, BarKind::grid);
  const Coverage limit = coverage_of(samples, BarKind::limit);
  const Coverage total = coverage_of(samples, BarKind::total);
  return {first,
          second,
          std::to_string(grid.count),
          percent(grid.held),
          ratio(grid.median),
          percent(limit.held),
          ratio(limit.median),
          std::to_string(total.count),
          percent(total.held),
          ratio(total.median),
          std::to_string(total.unknown)};
}

template <class Choice>
std::vector<BarSample> chosen(const std::vector<BarSample>& all, Choice choice) {
  std::vector<BarSample> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some), choice);
  return some;
}

std::vector<std::array<int, 2>> grids_of(const HonestyRecord& record) {
  std::vector<std::array<int, 2>> grids;
  for (const BarSample& s : record.samples) {
    if (std::find(grids.begin(), grids.end(), s.grid) == grids.end()) grids.push_back(s.grid);
  }
  return grids;
}

const std::vector<std::string> kHead{"",          "",          "grid bars", "hold",
                                     "bar/error", "limit",     "bar/error", "total",
                                     "hold",      "bar/error", "unknown"};

void write_by_tier(std::ostream& out, const HonestyRecord& record) {
  app::TextTable table(2);
  auto head = kHead;
  head[0] = "grid";
  head[1] = "tier";
  head.emplace_back("cost");
  table.add(head);
  table.rule();
  for (const auto& grid : grids_of(record)) {
    const auto here = chosen(record.samples, [&](const auto& s) { return s.grid == grid; });
    const std::string name = fmt::format("{}x{}", grid[0], grid[1]);
    for (const Tier tier : {Tier::isothermal, Tier::lumped, Tier::thd, Tier::tehd}) {
      const auto some = chosen(here, [&](const auto& s) { return s.tier == tier; });
      if (some.empty()) continue;
      auto row = cells(name, to_string(tier), some);
      row.push_back(cost_ratio(record.costs, grid, tier));
      table.add(row);
    }
    table.add(cells(name, "all", here));
  }
  table.print(out);
}

void write_by_set(std::ostream& out, const HonestyRecord& record) {
  app::TextTable table(2);
  auto head = kHead;
  head[0] = "cases";
  table.add(head);
  table.rule();
  for (const auto& grid : grids_of(record)) {
    const std::string name = fmt::format("{}x{}", grid[0], grid[1]);
    for (const std::string& set : std::set(record.sets.begin(), record.sets.end())) {
      const auto here = chosen(record.samples, [&](const auto& s) {
        return s.grid == grid && record.sets[s.subject] == set;
      });
      table.add(cells(set, name, here));
    }
  }
  table.print(out);
}

void write_by_quantity(std::ostream& out, const HonestyRecord& record) {
  std::vector<std::string> names;
  for (const BarSample& s : record.samples) {
    if (std::find(names.begin(), names.end(), s.quantity) == names.end()) {
      names.push_back(s.quantity);
    }
  }
  app::TextTable table(2);
  auto head = kHead;
  head[0] = "quantity";
  table.add(head);
  table.rule();
  for (const std::string& name : names) {
    table.add(
        cells(name, "", chosen(record.samples, [&](const auto& s) { return s.quantity == name; })));
  }
  table.print(out);
}

void write_refusals(std::ostream& out, const HonestyRecord& record) {
  if (record.refusals.empty()) return;
  out << "\nsolves that gave no result, by reason\n";
  std::map<std::string, int> count;
  for (const HonestyRefusal& r : record.refusals) {
    // Reasons differ in their numbers; what stands before the first one is their name.
    const std::string name = r.reason.substr(0, r.reason.find_first_of("(0123456789"));
    ++count[fmt::format("{}: {}", r.status, name)];
  }
  for (const auto& [name, n] : count) out << fmt::format("  {:4d}  {}\n", n, name);
}

}  // namespace

void write_honesty_table(std::ostream& out, const HonestyRecord& record) {
  const auto done = std::count(record.finished.begin(), record.finished.end(), true);
  out << fmt::format(
      "{} cases; bars of the grid against a finer grid and against the limit\n"
      "of fine grids, bars of grid and model\n"
      "together against the full physics on it; bar/error is the median, cost that\n"
      "of the bars over that of the solve\n\n",
      done);
  write_by_tier(out, record);
  out << '\n';
  write_by_set(out, record);
  out << '\n';
  write_by_quantity(out, record);
  write_refusals(out, record);
}

}  // namespace shellback::proof
