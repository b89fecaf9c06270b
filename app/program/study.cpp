/// study: published series of tests, rerun in one command.
#include <fmt/format.h>

#include <iostream>

#include "app/program/commands.hpp"
#include "app/program/outputs.hpp"
#include "app/program/run_keeper.hpp"
#include "app/program/session.hpp"
#include "app/reading/did_you_mean.hpp"
#include "core/contract.hpp"
#include "core/parallel.hpp"
#include "validation/rig/rig_page.hpp"
#include "validation/shells/shells_page.hpp"

namespace shellback::program {

using namespace app;
using namespace validation;

namespace {

const std::vector<std::string> kStudies{"ks-rig", "shells"};

/// Threads, stop, progress and states, which every study takes.
StudyOptions study_options(const Request& request, ProgressLine& line, PointKeepers& keepers) {
  StudyOptions options;
  options.quick = request.quick;
  options.threads = request.cores > 0 ? request.cores : hardware_threads();
  options.stop = &catch_interrupt();
  options.tell = [&line](const std::string& what, int done, int of) {
    line.show(fmt::format("{}: {} of {}", what, done, of));
  };
  options.kept = [&keepers](int piece, const bearing::Case& first, RunOf run,
                            const RunOptions& more) {
    return keepers.kept(piece, first, run, more);
  };
  return options;
}

int ended(const Outputs& outputs, bool interrupted, int failed) {
  if (interrupted) {
    std::cerr << "interrupted: what was finished is written\n";
    return outputs.code(kInterrupted);
  }
  if (failed > 0) {
    std::cerr << fmt::format("error: {} not found; told with {}\n",
                             failed == 1 ? "one solve was" : fmt::format("{} solves were", failed),
                             failed == 1 ? "its reason" : "their reasons");
    return outputs.code(kNotConverged);
  }
  return outputs.code(kDone);
}

int study_rig(const Request& request) {
  Outputs outputs(request, {});
  PointKeepers keepers(request, count_pieces(rig_plan(request.quick)));
  const RigStudy done = [&] {
    ProgressLine line;
    return run_rig_study(study_options(request, line, keepers));
  }();
  if (prints_tables(request)) write_rig_tables(std::cout, done);
  outputs.give("-o", [&] { return rig_page(done); });
  outputs.give("--json", [&] { return rig_json(done); });
  const int code = ended(outputs, done.interrupted, done.count_failed());
  keepers.end(code);
  return code;
}

int study_shells(const Request& request) {
  Outputs outputs(request, {});
  PointKeepers keepers(request, count_pieces(shells_plan(request.quick)));
  const ShellsStudy done = [&] {
    ProgressLine line;
    return run_shells_study(study_options(request, line, keepers));
  }();
  if (prints_tables(request)) write_shells_tables(std::cout, done);
  outputs.give("-o", [&] { return shells_page(done); });
  outputs.give("--json", [&] { return shells_json(done); });
  const int code = ended(outputs, done.interrupted, done.count_failed());
  keepers.end(code);
  return code;
}

}  // namespace

int study(const Request& request) {
  if (request.name.empty()) {
    refuse_outputs_of_a_list(request);
    for (const auto& [option, given] :
         {std::pair{"--resume", request.resume}, std::pair{"--quick", request.quick},
          std::pair{"--state", !request.state.empty()}}) {
      if (given) throw InputError(option, "belongs to a study; name one of them");
    }
    std::cout << "ks-rig  KS rig of Sander, Allmaier, Priebsch 2016: torque of three bearings over "
                 "speed, run-up and run-down, start and stop\n"
                 "shells  shells of Offner and Knaus 2015 in a big end: plain and grooved AlSn, "
                 "polymer; friction, heat, load capability\n";
    return kDone;
  }
  if (request.name == "ks-rig") return study_rig(request);
  if (request.name == "shells") return study_shells(request);
  throw InputError("NAME", "there is no study " + in_quotes(request.name) +
                               choices_for(request.name, kStudies, "studies are"));
}

}  // namespace shellback::program
