#include "app/study/identify.hpp"

#include <fmt/format.h>

#include <iostream>

#include "app/pictures/svg_identify.hpp"
#include "app/program/commands.hpp"
#include "app/program/outputs.hpp"
#include "app/program/session.hpp"
#include "app/reading/case_text.hpp"
#include "app/reading/identify_case.hpp"
#include "app/reading/read_case.hpp"
#include "app/write_identify.hpp"
#include "core/contract.hpp"
#include "core/parallel.hpp"
#include "validation/rivals/rivals.hpp"

namespace shellback::program {

using namespace app;

namespace {

study::Identification search(const MeasuredTable& table, const std::vector<FittedKey>& keys,
                             const study::MeasuredCase& case_at, int threads) {
  ProgressLine line;
  study::IdentifyOptions options;
  options.threads = threads;
  options.stop = &catch_interrupt();
  options.progress = [&](const study::IdentifyProgress& now) {
    line.show(fmt::format("evaluation {}, chi2 {:.4g}", now.evaluation, now.chi2));
  };
  std::vector<study::FitParameter> values;
  for (const FittedKey& key : keys) values.push_back(key.value);
  const auto with_rivals_at = [&](double at, const std::vector<double>& x) {
    return validation::with_rivals(case_at(at, x));
  };
  return study::identify(table.points, values, with_rivals_at, options);
}

int code_of(const IdentifyView& v) {
  if (v.end.fit.status == study::FitStatus::interrupted) {
    std::cerr << (v.end.fit.computed()
                      ? "interrupted: the keys are the best that were found until then\n"
                      : "interrupted: no set of keys was computed yet\n");
    return kInterrupted;
  }
  for (const std::string& words : {misfit(v), jumps(v)}) {
    if (!words.empty()) std::cerr << "warning: " << words << "\n";
  }
  const std::vector<std::string> why = complaints(v);
  for (const std::string& reason : why) std::cerr << "error: " << reason << "\n";
  return why.empty() ? kDone : kNotConverged;
}

}  // namespace

int identify(const Request& request) {
  const std::vector<Override> set = overrides_of(request);
  const std::string text = read_text_file(request.case_file);
  const bearing::Case given = read_case_text(text, request.case_file, set);
  if (request.measured.empty()) {
    throw InputError("--data", "the table of measurements is missing; give --data FILE.csv");
  }
  if (request.fit.empty()) {
    throw InputError("--fit", "no key is named; give --fit KEY=FROM..TO");
  }
  const MeasuredTable table =
      read_measured_table(request.measured, static_cast<int>(given.supplies.size()),
                          given.model.tier == bearing::Tier::isothermal, given.operation.omega);
  const std::vector<FittedKey> keys =
      fitted_keys(text, request.case_file, set, request.fit, request.bounds, table);
  std::vector<std::string> inputs = files_of_case(text, request.case_file, set);
  inputs.push_back(request.measured);
  Outputs outputs(request, inputs);
  tell_warnings(given);
  for (const FittedKey& key : keys) {
    if (!key.usual_bounds) continue;
    std::cerr << fmt::format(
        "note: {} is sought between {} and {}, as no bounds are given; what is "
        "possible is said by --fit {}=FROM..TO\n",
        key.key, key.words(key.value.low), key.words(key.value.high), key.key);
  }
  const study::MeasuredCase case_at = measured_case(text, request.case_file, set, table, keys);
  const study::Identification end =
      search(table, keys, case_at, request.cores > 0 ? request.cores : hardware_threads());
  std::vector<double> x;
  for (const FittedKey& key : keys) x.push_back(key.value.start);
  const IdentifyView view{given, keys, table, end, keys_that_move_cells(case_at, keys, x)};
  if (prints_tables(request)) write_identify_table(std::cout, view);
  outputs.give("--json", [&] { return identify_json(view); });
  outputs.give("--csv", [&] { return identify_csv(view); });
  outputs.give("--picture", [&] { return identify_svg(view); });
  return outputs.code(code_of(view));
}

}  // namespace shellback::program
