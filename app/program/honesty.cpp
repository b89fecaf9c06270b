#include "validation/honesty/honesty.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "app/program/commands.hpp"
#include "app/program/outputs.hpp"
#include "app/progress.hpp"
#include "app/reading/read_case.hpp"
#include "core/contract.hpp"
#include "validation/honesty/honesty_report.hpp"
#include "validation/honesty/known_cases.hpp"
#include "validation/honesty/population.hpp"
#include "validation/rivals/rivals.hpp"

namespace shellback::program {

using namespace validation;
using bearing::Tier;

namespace {

/// "200x25" as two numbers of cells. Throws InputError.
std::array<int, 2> grid_named(const std::string& words, const std::string& place) {
  std::array<int, 2> grid{0, 0};
  char rest = 0;
  const int read = std::sscanf(words.c_str(), "%dx%d%c", &grid[0], &grid[1], &rest);
  if (read != 2 || grid[0] < 16 || grid[1] < 3 || grid[0] > 3200 || grid[1] > 400) {
    throw InputError(place, fmt::format("\"{}\" is no grid; write cells round x along, as 200x25, "
                                        "between 16x3 and 3200x400",
                                        words));
  }
  return grid;
}

std::vector<HonestyCase> chosen_cases(const Request& request) {
  std::vector<HonestyCase> cases;
  for (int k = 0; k < request.cases; ++k) {
    cases.push_back({random_case(request.seed + k), "random"});
  }
  if (!request.known) return cases;
  for (const auto& file : known_cases()) {
    bearing::Case known = app::read_case(file.string());
    if (known.cycle) continue;  // bars are those of a steady film
    cases.push_back({with_rivals(std::move(known)), "known"});
    cases.back().input.title = (file.parent_path().filename() / file.stem()).string();
  }
  return cases;
}

/// A truth that is no finer than what it judges is none, and what stands twice counts twice.
void expect_judgeable(const HonestyOptions& o) {
  for (const auto& grid : o.grids) {
    if (grid[0] < o.truth_grid[0] && grid[1] < o.truth_grid[1]) continue;
    throw InputError("--truth", fmt::format("{}x{} cells are not finer than the {}x{} that they "
                                            "are to judge, around and along",
                                            o.truth_grid[0], o.truth_grid[1], grid[0], grid[1]));
  }
  const auto twice = [](auto list) {
    std::sort(list.begin(), list.end());
    return std::adjacent_find(list.begin(), list.end()) != list.end();
  };
  if (twice(o.grids)) throw InputError("--grids", "one grid stands there twice");
  if (twice(o.tiers)) throw InputError("--tiers", "one tier stands there twice");
}

HonestyOptions honesty_options(const Request& request) {
  HonestyOptions o;
  for (const std::string& name : request.tiers) {
    o.tiers.push_back(app::tier_named(name, "--tiers"));
    if (o.tiers.back() == Tier::estimate || o.tiers.back() == Tier::automatic) {
      throw InputError(
          "--tiers", "the bars of " + name +
                         " are not those of grids, which are judged here (of auto: auto-honesty)");
    }
  }
  if (o.tiers.empty()) o.tiers = {Tier::isothermal, Tier::lumped, Tier::thd, Tier::tehd};
  for (const std::string& words : request.grids) o.grids.push_back(grid_named(words, "--grids"));
  o.truth_grid = grid_named(request.truth, "--truth");
  o.truth_nodes = request.nodes;
  expect_judgeable(o);
  o.at_once = request.threads;
  o.budget_s = request.budget_s;
  o.stop = &app::catch_interrupt();
  return o;
}

}  // namespace

int honesty(const Request& request) {
  HonestyOptions options = honesty_options(request);
  Outputs outputs(request, {});
  const auto cases = chosen_cases(request);
  if (cases.empty()) throw InputError("--cases", "there is no case to judge; give one or more");
  const HonestyRecord record = [&] {
    app::ProgressLine line;
    options.progress = [&](int done, int of) {
      line.show(fmt::format("{} of {} cases", done, of));
    };
    return measure_honesty(cases, options);
  }();
  if (prints_tables(request)) write_honesty_table(std::cout, record);
  outputs.give("-o", [&] { return honesty_svg(record); });
  outputs.give("--json", [&] { return honesty_json(record); });
  if (const int cut = record.count(CaseEnd::stopped); cut > 0) {
    std::cerr << fmt::format("interrupted: {} of {} cases are finished\n", record.ends.size() - cut,
                             record.ends.size());
  }
  return outputs.code(options.stop->load() ? kInterrupted : kDone);
}

}  // namespace shellback::program
