#include "app/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "app/check.hpp"
#include "app/did_you_mean.hpp"
#include "app/judge_case.hpp"
#include "app/progress.hpp"
#include "app/read_case.hpp"
#include "app/write_hdf5.hpp"
#include "app/write_html.hpp"
#include "app/write_json.hpp"
#include "app/write_table.hpp"
#include "core/contract.hpp"
#include "coupling/compare.hpp"
#include "coupling/solve.hpp"

namespace shellback::app {
namespace {

using namespace coupling;

std::vector<Override> overrides_of(const Request& request) {
  std::vector<Override> overrides;
  for (const std::string& words : request.set) overrides.push_back(parse_override(words));
  if (!request.tier.empty()) {
    static_cast<void>(tier_named(request.tier, "--tier"));
    overrides.push_back({"model.tier", "\"" + request.tier + "\"", "--tier"});
  }
  return overrides;
}

/// Refuses an output file that cannot come about, before the work and not after it.
void expect_folder(const std::string& path) {
  if (path.empty() || path == "-") return;
  const auto folder = std::filesystem::absolute(path).parent_path();
  if (!std::filesystem::is_directory(folder)) {
    throw FileError(fmt::format("{}: there is no folder {}", path, folder.string()));
  }
  if (std::filesystem::is_directory(path)) {
    throw FileError(fmt::format("{}: this is a folder; give a file in it", path));
  }
}

void write_text_file(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw FileError(fmt::format("{}: cannot be written", path));
}

void give_json(const Request& request, const std::string& json) {
  const std::string text = json.ends_with('\n') ? json : json + "\n";
  if (request.json == "-") std::cout << text;
  if (!request.json.empty() && request.json != "-") write_text_file(request.json, text);
}

void tell_warnings(const Case& subject) {
  for (const std::string& warning : subject.warnings) {
    std::cerr << "warning: " << warning << "\n";
  }
}

int code_of(const Verdict& verdict) {
  if (verdict.good()) return kDone;
  return verdict.status == Status::interrupted ? kInterrupted : kNotConverged;
}

/// Why there is no result, on standard error.
void tell_verdict(const Result& result) {
  const Verdict& verdict = result.verdict;
  if (verdict.good()) return;
  std::cerr << "error: " << to_string(result.tier) << ": " << to_string(verdict.status);
  if (!verdict.reason.empty()) std::cerr << ": " << verdict.reason;
  std::cerr << "\n";
  if (!verdict.place.empty()) std::cerr << "  where: " << verdict.place << "\n";
  if (!verdict.cure.empty()) std::cerr << "  cure:  " << verdict.cure << "\n";
}

SolveControl control_for(ProgressLine& line) {
  SolveControl control;
  control.progress = [&line](const Progress& progress) { line.show(progress); };
  control.stop = &catch_interrupt();
  return control;
}

std::vector<Tier> wanted_tiers(const Request& request) {
  std::vector<Tier> tiers;
  for (const std::string& name : request.tiers) {
    const Tier tier = tier_named(name, "--tiers");
    if (std::find(tiers.begin(), tiers.end(), tier) != tiers.end()) {
      throw InputError("--tiers", fmt::format("the tier {} is named twice", in_quotes(name)));
    }
    tiers.push_back(tier);
  }
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

Comparison solve_all(const Case& subject, const std::vector<Tier>& tiers) {
  ProgressLine line;
  return coupling::compare(subject, tiers, control_for(line));
}

}  // namespace

int check(const Request& request) {
  const Case subject = read_case(request.case_file, overrides_of(request));
  print_check(std::cout, subject);
  return kDone;
}

int run(const Request& request) {
  const Case subject = read_case(request.case_file, overrides_of(request));
  expect_folder(request.json);
  expect_folder(request.output);
  tell_warnings(subject);
  const Result result = [&] {
    ProgressLine line;
    return solve(subject, control_for(line));
  }();
  if (!request.json.empty()) give_json(request, result_json(subject, result));
  if (!request.output.empty()) write_hdf5(request.output, subject, result);
  if (result.verdict.good() && request.json != "-") write_table(std::cout, subject, result);
  if (!result.verdict.good() && request.json != "-") {
    std::cout << "not converged: there is no result to print\n";
  }
  tell_verdict(result);
  return code_of(result.verdict);
}

int compare(const Request& request) {
  std::vector<Tier> tiers = wanted_tiers(request);
  const Case subject = read_case(request.case_file, overrides_of(request), tiers);
  for (const std::string& path : {request.json, request.output, request.picture}) {
    expect_folder(path);
  }
  tell_warnings(subject);
  if (tiers.empty()) tiers = default_tiers(subject);
  const Comparison comparison = solve_all(subject, tiers);
  if (!request.json.empty()) give_json(request, comparison_json(subject, comparison));
  if (!request.output.empty()) write_comparison_html(request.output, subject, comparison);
  if (!request.picture.empty()) write_comparison_svg(request.picture, subject, comparison);
  if (request.json != "-") write_comparison_table(std::cout, subject, comparison);
  int code = kDone;
  for (const Result& result : comparison.results) {
    tell_verdict(result);
    code = std::max(code, code_of(result.verdict));
  }
  return code;
}

}  // namespace shellback::app
