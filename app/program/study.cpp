/// study: published series of tests, rerun in one command.
#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <thread>

#include "app/did_you_mean.hpp"
#include "app/program/commands.hpp"
#include "app/program/outputs.hpp"
#include "app/program/session.hpp"
#include "core/contract.hpp"
#include "validation/rig/rig_page.hpp"

namespace shellback::program {

using namespace app;
using namespace validation;

namespace {

const std::vector<std::string> kStudies{"ks-rig"};

RigStudy solved(const Request& request) {
  ProgressLine line;
  RigOptions options;
  options.quick = request.quick;
  const int all = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  options.threads = request.cores > 0 ? request.cores : all;
  options.stop = &catch_interrupt();
  options.tell = [&](const std::string& what, int done, int of) {
    line.show(fmt::format("{}: {} of {}", what, done, of));
  };
  return run_rig_study(options);
}

}  // namespace

int study(const Request& request) {
  if (request.name.empty()) {
    std::cout << "ks-rig  KS rig of Sander, Allmaier, Priebsch 2016: torque of three bearings over "
                 "speed, run-up and run-down, start and stop\n";
    return kDone;
  }
  if (std::find(kStudies.begin(), kStudies.end(), request.name) == kStudies.end()) {
    throw InputError("NAME", "there is no study " + in_quotes(request.name) +
                                 choices_for(request.name, kStudies, "studies are"));
  }
  Outputs outputs(request, {});
  const RigStudy done = solved(request);
  if (request.json != "-") write_rig_tables(std::cout, done);
  outputs.give("-o", [&] { return rig_page(done); });
  outputs.give("--json", [&] { return rig_json(done); });
  if (done.interrupted) {
    std::cerr << "interrupted: what was finished is written\n";
    return outputs.code(kInterrupted);
  }
  if (const int failed = done.count_failed(); failed > 0) {
    std::cerr << fmt::format("error: {} solves were not found; they are told with their reasons\n",
                             failed);
    return outputs.code(kNotConverged);
  }
  return outputs.code(kDone);
}

}  // namespace shellback::program
