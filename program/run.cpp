#include <fmt/format.h>

#include <iostream>

#include "app/check.hpp"
#include "app/read_case.hpp"
#include "app/write_hdf5.hpp"
#include "app/write_json.hpp"
#include "app/write_table.hpp"
#include "fidelity/solve.hpp"
#include "program/commands.hpp"
#include "program/session.hpp"

namespace shellback::program {

using namespace app;
using namespace coupling;

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
    return fidelity::solve(subject, control_for(line));
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

}  // namespace shellback::program
