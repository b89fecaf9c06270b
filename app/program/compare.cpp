#include "bearing/steady/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "app/pictures/svg_comparison.hpp"
#include "app/program/commands.hpp"
#include "app/program/outputs.hpp"
#include "app/program/run_keeper.hpp"
#include "app/program/session.hpp"
#include "app/reading/case_text.hpp"
#include "app/reading/did_you_mean.hpp"
#include "app/reading/read_case.hpp"
#include "app/write_cycle_comparison.hpp"
#include "app/write_html.hpp"
#include "app/write_json.hpp"
#include "app/write_table.hpp"
#include "bearing/judge/judge_case.hpp"
#include "bearing/over_time/compare_cycles.hpp"
#include "core/contract.hpp"
#include "fidelity/cycle_bars.hpp"
#include "fidelity/solve.hpp"
#include "validation/rivals/rivals.hpp"

namespace shellback::program {

using namespace app;
using namespace bearing;

namespace {

std::vector<Tier> wanted_tiers(const Request& request) {
  std::vector<Tier> tiers;
  for (const std::string& name : request.tiers) {
    const Tier tier = tier_named(name, "--tiers");
    if (std::find(tiers.begin(), tiers.end(), tier) != tiers.end()) {
      throw InputError("--tiers", fmt::format("the tier {} is named twice", in_quotes(name)));
    }
    if (tier == Tier::estimate || tier == Tier::automatic) {
      throw InputError("--tiers", fmt::format("the tier {} has no film of its own to compare; name "
                                              "some of isothermal, lumped, thd, tehd",
                                              in_quotes(name)));
    }
    tiers.push_back(tier);
  }
  std::sort(tiers.begin(), tiers.end());  // the ladder's order, the richest last
  return tiers;
}

/// Every tier that the case has the data for; says which are left out.
std::vector<Tier> default_tiers(const Case& subject) {
  const std::vector<Tier> tiers = possible_tiers(subject);
  for (const Tier tier : {Tier::isothermal, Tier::lumped, Tier::thd, Tier::tehd}) {
    if (std::find(tiers.begin(), tiers.end(), tier) != tiers.end()) continue;
    std::cerr << fmt::format(
        "the tier {0} is left out: the case lacks its data (\"shellback "
        "check {1} --tier {0}\" tells which)\n",
        to_string(tier), subject.path);
  }
  return tiers;
}

/// Interrupted after the last tier, while the causes of the differences were sought.
int code_of_split(int code) {
  if (code != kDone || !catch_interrupt().load()) return code;
  std::cerr << "interrupted: what the differences come from was not sought to the end\n";
  return kInterrupted;
}

Comparison solve_all(const Case& subject, const std::vector<Tier>& tiers) {
  ProgressLine line;
  const SolveControl control = control_for(line);
  const auto judged = [&](const Solution& s, Tier tier) {
    return fidelity::summarize(s, tier, control);
  };
  return bearing::compare(subject, tiers, control, judged);
}

CycleComparison cycles_compared(const Case& subject, const std::vector<Tier>& tiers,
                                RunKeeper& keeper) {
  ProgressLine line;
  const SolveControl control = control_for(line);
  SolveControl with_state = control;
  with_state.kept = keeper.kept();
  return compare_cycles(subject, tiers, control, [&](const Case& one) {
    CycleResult r = fidelity::solve_cycle_with_bars(one, with_state);
    if (with_state.kept != nullptr && r.verdict.status != Status::interrupted) {
      with_state.kept->note_ended();
    }
    return r;
  });
}

int compare_over_cycle(const Request& request, const std::string& text, const Case& subject,
                       const std::vector<Tier>& tiers) {
  std::vector<double> which;
  for (const Tier tier : tiers) which.push_back(static_cast<double>(tier));
  RunKeeper keeper(request, subject, RunOf::comparison, {{"--tiers", which}});
  Outputs outputs(with_state(request),
                  files_of_case(text, request.case_file, overrides_of(request), tiers));
  tell_warnings(subject);
  const CycleComparison comparison = cycles_compared(subject, tiers, keeper);
  if (prints_tables(request)) write_comparison_table(std::cout, subject, comparison.sums);
  int code = kDone;
  for (const CycleResult& r : comparison.cycles) {
    tell_verdict(r.tier, r.verdict);
    code = worse_code(code, code_of(r.verdict));
  }
  outputs.give("--json", [&] { return comparison_json(subject, comparison.sums); });
  outputs.give("-o", [&] { return cycle_comparison_html(subject, comparison); });
  outputs.give("--picture", [&] { return cycle_comparison_svg(subject, comparison); });
  code = outputs.code(code_of_split(code));
  keeper.end(code);
  return code;
}

}  // namespace

int compare(const Request& request) {
  std::vector<Tier> tiers = wanted_tiers(request);
  const std::string text = read_text_file(request.case_file);
  const Case subject = validation::with_rivals(
      read_case_text(text, request.case_file, overrides_of(request), tiers));
  if (subject.cycle) {
    return compare_over_cycle(request, text, subject,
                              tiers.empty() ? default_tiers(subject) : tiers);
  }
  refuse_options({{"--resume", request.resume}, {"--state", !request.state.empty()}},
                 "belongs to a load cycle; steady states are solved anew");
  Outputs outputs(request, files_of_case(text, request.case_file, overrides_of(request), tiers));
  tell_warnings(subject);
  if (tiers.empty()) tiers = default_tiers(subject);
  const Comparison comparison = solve_all(subject, tiers);
  if (prints_tables(request)) write_comparison_table(std::cout, subject, comparison);
  int code = kDone;
  for (const Result& result : comparison.results) {
    tell_verdict(result);
    code = worse_code(code, code_of(result.verdict));
  }
  outputs.give("--json", [&] { return comparison_json(subject, comparison); });
  outputs.give("-o", [&] { return comparison_html(subject, comparison); });
  outputs.give("--picture", [&] { return comparison_svg(subject, comparison); });
  return outputs.code(code_of_split(code));
}

}  // namespace shellback::program
