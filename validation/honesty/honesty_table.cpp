#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <set>

#include "app/labels/text_table.hpp"
#include "validation/honesty/coverage.hpp"
#include "validation/honesty/honesty_report.hpp"

namespace shellback::validation {

using bearing::Tier;

namespace {

using Samples = std::vector<BarSample>;

/// Bars that are told together.
struct Group {
  std::string first;
  std::string second;
  Samples samples;
  std::string cost;
};

std::string percent(double part) {
  return std::isfinite(part) ? fmt::format("{:.1f} %", 100.0 * part) : "-";
}

std::string ratio(double value) { return std::isnan(value) ? "-" : fmt::format("{:.2f}", value); }

/// "95.8 % [95.4, 96.2]"
std::string with_interval(double part, const ShareInterval& i) {
  if (!std::isfinite(part)) return "-";
  return fmt::format("{} [{:.1f}, {:.1f}]", percent(part), 100.0 * i.low, 100.0 * i.high);
}

std::string held(const Coverage& c) { return with_interval(c.held, c.interval); }

std::string without_truth(const Coverage& c) {
  return with_interval(c.share_without_truth(), wilson(c.no_truth, c.count + c.no_truth));
}

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

template <class Choice>
Samples chosen(const Samples& all, Choice choice) {
  Samples some;
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

std::vector<Group> by_tier(const HonestyRecord& record) {
  std::vector<Group> groups;
  for (const auto& grid : grids_of(record)) {
    const auto here = chosen(record.samples, [&](const auto& s) { return s.grid == grid; });
    const std::string name = fmt::format("{}x{}", grid[0], grid[1]);
    for (const Tier tier : {Tier::isothermal, Tier::lumped, Tier::thd, Tier::tehd}) {
      auto some = chosen(here, [&](const auto& s) { return s.tier == tier; });
      if (some.empty()) continue;
      const std::string cost = cost_ratio(record.costs, grid, tier);
      groups.push_back({name, to_string(tier), std::move(some), cost});
    }
    groups.push_back({name, "all", here, "-"});
  }
  return groups;
}

std::vector<Group> by_set(const HonestyRecord& record) {
  std::vector<Group> groups;
  for (const auto& grid : grids_of(record)) {
    for (const std::string& set : std::set(record.sets.begin(), record.sets.end())) {
      groups.push_back(
          {set, fmt::format("{}x{}", grid[0], grid[1]),
           chosen(record.samples,
                  [&](const auto& s) { return s.grid == grid && record.sets[s.subject] == set; }),
           "-"});
    }
  }
  return groups;
}

/// The poorest first.
std::vector<Group> by_quantity(const HonestyRecord& record) {
  std::set<std::string> names;
  for (const BarSample& s : record.samples) names.insert(s.quantity);
  std::vector<std::pair<double, Group>> ranked;
  for (const std::string& name : names) {
    Group g{name, "", chosen(record.samples, [&](const auto& s) { return s.quantity == name; }),
            "-"};
    const double part = coverage_of(g.samples, BarKind::limit).held;
    ranked.emplace_back(std::isnan(part) ? INFINITY : part, std::move(g));
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Group> groups;
  for (auto& [part, g] : ranked) groups.push_back(std::move(g));
  return groups;
}

/// The bars of the grid: against the truth's grid and against the limit of fine grids.
void write_grid_bars(std::ostream& out, const std::vector<Group>& groups) {
  app::TextTable table(2);
  table.add({"bars of the grid", "", "judged", "no truth", "hold the truth's grid", "by bearing",
             "bar/error", "hold the limit", "by bearing", "bar/error", "cost"});
  table.rule();
  const auto ends = [](const ShareInterval& i) {
    return fmt::format("[{:.1f}, {:.1f}]", 100.0 * i.low, 100.0 * i.high);
  };
  for (const Group& g : groups) {
    const Coverage grid = coverage_of(g.samples, BarKind::grid);
    const Coverage limit = coverage_of(g.samples, BarKind::limit);
    if (grid.count + grid.no_truth == 0) continue;
    table.add({g.first, g.second, std::to_string(grid.count), without_truth(grid), held(grid),
               ends(grid.by_bearing), ratio(grid.median), held(limit), ends(limit.by_bearing),
               ratio(limit.median), g.cost});
  }
  table.print(out);
}

/// Bars of grid and model together against the full physics.
void write_sums(std::ostream& out, const std::vector<Group>& groups) {
  app::TextTable table(2);
  table.add(
      {"grid and model", "", "judged", "no truth", "hold", "by bearing", "bar/error", "unknown"});
  table.rule();
  for (const Group& g : groups) {
    const Coverage c = coverage_of(g.samples, BarKind::total);
    if (c.count + c.no_truth == 0) continue;
    table.add({g.first, g.second, std::to_string(c.count), without_truth(c), held(c),
               fmt::format("[{:.1f}, {:.1f}]", 100.0 * c.by_bearing.low, 100.0 * c.by_bearing.high),
               ratio(c.median), std::to_string(c.unknown)});
  }
  table.print(out);
}

void write_cases(std::ostream& out, const HonestyRecord& record) {
  const int all = static_cast<int>(record.ends.size()) - record.count(CaseEnd::stopped);
  const int cut = record.count(CaseEnd::over_budget) + record.count(CaseEnd::failed);
  const ShareInterval i = wilson(cut, all);
  out << fmt::format(
      "{} cases of at most {:.0f} s of processor time: {} to the end; {} over the budget, {} "
      "failed: "
      "{}\n",
      all, record.budget_s, record.count(CaseEnd::done), record.count(CaseEnd::over_budget),
      record.count(CaseEnd::failed),
      all > 0 ? with_interval(static_cast<double>(cut) / all, i) + " not judged in full" : "none");
  for (std::size_t k = 0; k < record.ends.size(); ++k) {
    if (record.ends[k] != CaseEnd::over_budget && record.ends[k] != CaseEnd::failed) continue;
    out << fmt::format("  {}: {} ({:.0f} s){}{}\n", record.subjects[k], to_string(record.ends[k]),
                       record.processor_s[k], record.whys[k].empty() ? "" : ": ", record.whys[k]);
  }
}

void write_refusals(std::ostream& out, const HonestyRecord& record) {
  if (record.refusals.empty()) return;
  out << "\nsolves that gave no result, by reason\n";
  std::map<std::string, int> count;
  for (const HonestyRefusal& r : record.refusals) {
    // Reasons differ in their numbers; what stands before the first one is their name.
    const std::string name = r.reason.substr(0, r.reason.find_first_of("(0123456789"));
    ++count[fmt::format("{}, {}: {}", to_string(r.tier), r.status, name)];
  }
  for (const auto& [name, n] : count) out << fmt::format("  {:4d}  {}\n", n, name);
}

}  // namespace

void write_honesty_table(std::ostream& out, const HonestyRecord& record) {
  write_cases(out, record);
  out << "\nhold: share of the bars judged that contain the truth, [Wilson interval, 95 %], as if "
         "each bar\nwere drawn by itself; by bearing: the interval for bars that are wrong "
         "together; "
         "no truth: share\nof all bars that could not be judged; bar/error: median; cost: bars "
         "over "
         "solve\n\n";
  const auto tiers = by_tier(record);
  const auto sets = by_set(record);
  const auto quantities = by_quantity(record);
  for (const auto* groups : {&tiers, &sets, &quantities}) {
    write_grid_bars(out, *groups);
    out << '\n';
    write_sums(out, *groups);
    out << '\n';
  }
  write_refusals(out, record);
}

}  // namespace shellback::validation
