#include <fmt/format.h>

#include <iostream>

#include "app/check.hpp"
#include "app/pictures/svg_comparison.hpp"
#include "app/program/commands.hpp"
#include "app/program/outputs.hpp"
#include "app/program/session.hpp"
#include "app/reading/case_text.hpp"
#include "app/reading/read_case.hpp"
#include "app/words/ending_words.hpp"
#include "app/write_coefficients.hpp"
#include "app/write_hdf5.hpp"
#include "app/write_html.hpp"
#include "app/write_json.hpp"
#include "app/write_table.hpp"
#include "core/contract.hpp"
#include "fidelity/solve_case.hpp"
#include "validation/rivals/rivals.hpp"

namespace shellback::program {

using namespace app;
using namespace bearing;

int check(const Request& request) {
  const Case subject = read_case(request.case_file, overrides_of(request));
  print_check(std::cout, subject);
  return kDone;
}

namespace {

/// The table of coefficients, if it is asked for; 3 if they could not be had.
int give_coefficients(Outputs& outputs, const Result& result) {
  if (!result.coefficients) return kDone;
  const Coefficients& k = *result.coefficients;
  if (!k.verdict.good()) {
    std::cerr << "error: no stiffness and damping: " << reason_of(k.verdict) << "\n";
    return kNotConverged;
  }
  outputs.give("--coefficients-table", [&] { return coefficients_csv({k}); });
  return kDone;
}

/// Options of a transient.
void expect_no_transient(const Request& request) {
  for (const auto& [option, given] :
       {std::pair{"--from", !request.from.empty()}, std::pair{"--until", !request.until.empty()},
        std::pair{"--speeds", !request.speeds.empty()},
        std::pair{"--hold", !request.hold.empty()}}) {
    if (!given) continue;
    throw InputError(option, request.running_in
                                 ? "belongs to a transient; a running-in takes its speed and its "
                                   "end from the case (operation.speed, running_in.until)"
                                 : "belongs to a transient; add --transient");
  }
}

/// What belongs to something that goes on in time.
void expect_steady(const Request& request) {
  if (!request.csv.empty()) {
    throw InputError("--csv",
                     "belongs to what goes on in time: a load cycle, --transient or --running-in; "
                     "a steady state is a row of sweep (--vary KEY=VALUE --csv FILE.csv)");
  }
  if (request.resume || !request.state.empty()) {
    throw InputError(
        request.resume ? "--resume" : "--state",
        "belongs to a load cycle, a running-in or a transient; a steady state is solved anew");
  }
}

}  // namespace

int run(const Request& request) {
  if (!request.transient) expect_no_transient(request);
  if (request.running_in) return running_in(request);
  if (!request.profile.empty()) {
    throw InputError("--profile", "belongs to a running-in; add --running-in");
  }
  if (request.transient) return transient(request);
  const std::string text = read_text_file(request.case_file);
  const Case subject =
      validation::with_rivals(read_case_text(text, request.case_file, overrides_of(request)));
  if (subject.cycle) return cycle(request, text, subject);
  expect_steady(request);
  if (subject.model.tier == bearing::Tier::estimate && !request.picture.empty()) {
    throw InputError("--picture",
                     "tier estimate solves no film that could be drawn; name another tier");
  }
  Outputs outputs(request, files_of_case(text, request.case_file, overrides_of(request)));
  tell_warnings(subject);
  const Result result = [&] {
    ProgressLine line;
    return fidelity::solve_case(subject, control_for(line));
  }();
  if (result.verdict.good() && prints_tables(request)) write_table(std::cout, subject, result);
  if (!result.verdict.good() && prints_tables(request)) {
    std::cout << "not converged: there is no result to print\n";
  }
  tell_verdict(result);
  outputs.give("--json", [&] { return result_json(subject, result); });
  outputs.give("-o", [&] { return result_hdf5(subject, result); });
  Comparison alone;
  alone.results = {result};
  outputs.give("--picture", [&] { return comparison_svg(subject, alone); });
  outputs.give("--page", [&] { return comparison_html(subject, alone); });
  const int code = code_of(result.verdict, result.warnings);
  return outputs.code(code == kDone ? give_coefficients(outputs, result) : code);
}

}  // namespace shellback::program
