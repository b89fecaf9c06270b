#include "app/program/session.hpp"

#include <algorithm>
#include <iostream>
#include <utility>

#include "app/reading/read_case.hpp"
#include "app/words/ending_words.hpp"
#include "core/contract.hpp"

namespace shellback::program {

using namespace app;
using namespace bearing;

std::vector<Override> overrides_of(const Request& request) {
  std::vector<Override> overrides;
  for (const std::string& words : request.set) {
    Override given = parse_override(words);
    const auto same = [&](const Override& other) { return other.key == given.key; };
    if (std::any_of(overrides.begin(), overrides.end(), same)) {
      throw InputError("--set " + given.key, "is given twice; leave out one of them");
    }
    overrides.push_back(std::move(given));
  }
  if (!request.tier.empty()) {
    static_cast<void>(tier_named(request.tier, "--tier"));
    overrides.push_back({"model.tier", "\"" + request.tier + "\"", "--tier"});
  }
  if (request.coefficients || !request.coefficients_table.empty()) {
    overrides.push_back({"model.coefficients", "true",
                         request.coefficients ? "--coefficients" : "--coefficients-table"});
  }
  return overrides;
}

double given(const std::string& option, const std::string& text, const Kind& kind) {
  try {
    return parse_quantity(text, kind);
  } catch (const UnitError& error) {
    throw InputError(option, error.what());
  }
}

void expect_no_coefficients(const Request& request, const Case& subject,
                            const std::string& instead) {
  if (!subject.model.coefficients) return;
  throw InputError(!request.coefficients_table.empty() ? "--coefficients-table"
                   : request.coefficients              ? "--coefficients"
                                                       : "model.coefficients",
                   "stiffness and damping are those of a steady state, and " + instead +
                       "; leave out one of them");
}

void tell_warnings(const Case& subject) {
  for (const std::string& warning : subject.warnings) {
    std::cerr << "warning: " << warning << "\n";
  }
}

int worse_code(int a, int b) { return a == kDefect || b == kDefect ? kDefect : std::max(a, b); }

int code_of(const Verdict& verdict) {
  if (verdict.good()) return kDone;
  if (verdict.status == Status::invalid_number) return kDefect;
  return verdict.status == Status::interrupted ? kInterrupted : kNotConverged;
}

int code_of(const Verdict& verdict, const std::vector<Note>& warnings) {
  const bool bars_cut_off = std::any_of(warnings.begin(), warnings.end(), [](const Note& n) {
    const auto* plain = std::get_if<note::Plain>(&n);
    return plain != nullptr && *plain == note::Plain::bars_interrupted;
  });
  return verdict.good() && bars_cut_off ? kInterrupted : code_of(verdict);
}

namespace {

void tell_place_and_cure(const EndingWords& words) {
  std::cerr << "\n";
  if (!words.place.empty()) std::cerr << "  where: " << words.place << "\n";
  if (!words.cure.empty()) std::cerr << "  cure:  " << words.cure << "\n";
}

}  // namespace

void tell_verdict(const Result& result) { tell_verdict(result.tier, result.verdict); }

void tell_verdict(Tier tier, const Verdict& verdict) {
  if (verdict.good()) return;
  std::cerr << "error: " << to_string(tier) << ": " << to_string(verdict.status);
  const EndingWords words = words_of(verdict);
  if (!words.reason.empty()) std::cerr << ": " << words.reason;
  tell_place_and_cure(words);
}

void tell_end(const char* run, const std::string& why, const Verdict& verdict) {
  std::cerr << "error: " << run << ": " << why;
  tell_place_and_cure(words_of(verdict));
}

SolveControl control_for(ProgressLine& line) {
  SolveControl control;
  control.progress = [&line](const Progress& progress) { line.show(progress); };
  control.stop = &catch_interrupt();
  return control;
}

}  // namespace shellback::program
