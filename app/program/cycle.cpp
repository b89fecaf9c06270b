/// run on a case with a load cycle.
#include "bearing/over_time/cycle.hpp"

#include <iostream>

#include "app/pictures/svg_cycle.hpp"
#include "app/program/commands.hpp"
#include "app/program/outputs.hpp"
#include "app/program/run_keeper.hpp"
#include "app/program/session.hpp"
#include "app/reading/read_case.hpp"
#include "app/write_curves.hpp"
#include "app/write_cycle_hdf5.hpp"
#include "app/write_cycle_html.hpp"
#include "app/write_cycle_json.hpp"
#include "app/write_cycle_table.hpp"
#include "fidelity/auto_cycle.hpp"

namespace shellback::program {

using namespace app;
using namespace bearing;

namespace {

CycleResult solved(const Case& subject, RunKeeper& keeper) {
  ProgressLine line;
  SolveControl control = control_for(line);
  control.kept = keeper.kept();
  return fidelity::solve_cycle_case(subject, control);
}

}  // namespace

int cycle(const Request& request, const std::string& text, const Case& subject) {
  expect_no_coefficients(request, subject, "the case has a load cycle");
  RunKeeper keeper(request, subject, RunOf::load_cycle);
  Outputs outputs(with_state(request),
                  files_of_case(text, request.case_file, overrides_of(request)));
  tell_warnings(subject);
  const CycleResult result = solved(subject, keeper);
  if (prints_tables(request)) write_cycle_table(std::cout, subject, result);
  tell_verdict(result.tier, result.verdict);
  outputs.give("--json", [&] { return cycle_json(subject, result); });
  outputs.give("-o", [&] { return cycle_hdf5(subject, result); });
  outputs.give("--csv", [&] { return curves_csv(curves_of(subject, result), result.verdict); });
  outputs.give("--picture", [&] { return cycle_svg(subject, result); });
  outputs.give("--page", [&] { return cycle_html(subject, result); });
  const int code = outputs.code(code_of(result.verdict, result.warnings));
  keeper.end(code);
  return code;
}

}  // namespace shellback::program
