/// study: published series of tests, rerun in one command.
#include <fmt/format.h>

#include <algorithm>
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
const std::vector<std::string> kOfMany{"plan", "run", "submit", "status", "merge"};

/// What belongs to the work on a folder of points, and is not asked for there.
void expect_no_points(const Request& request) {
  constexpr const char* kOnlyOfMany = "belongs to studies of many cases: plan, run, submit, merge";
  refuse_options({{"--vary", !request.vary.empty()},
                  {"--set", !request.set.empty()},
                  {"--tier", !request.tier.empty()},
                  {"--part", !request.part.empty()},
                  {"--tasks", request.tasks != 0},
                  {"--slurm", !request.slurm.empty()},
                  {"--csv", !request.csv.empty()},
                  {"FOLDER", !request.names.empty()}},
                 kOnlyOfMany);
}

/// What each of the words may be given.
void expect_own_options(const Request& request) {
  const auto is = [&](const char* name) { return request.name == name; };
  const auto asked = [&](const char* option, bool given, bool taken) {
    if (given && !taken) {
      throw InputError(option, "is no option of study " + request.name + "; leave it out");
    }
  };
  asked("--vary", !request.vary.empty(), is("plan"));
  asked("--set", !request.set.empty(), is("plan"));
  asked("--tier", !request.tier.empty(), is("plan"));
  asked("-o", !request.output.empty(), is("plan"));
  asked("--force", request.force, is("plan") || is("merge"));
  asked("--part", !request.part.empty(), is("run"));
  asked("--tasks", request.tasks != 0, is("submit"));
  asked("--slurm", !request.slurm.empty(), is("submit"));
  asked("-j", request.cores != 0, is("run") || is("submit"));
  asked("--csv", !request.csv.empty(), is("merge"));
  asked("--json", !request.json.empty(), is("merge"));
  asked("--quick", request.quick, false);
  asked("--state", !request.state.empty(), false);
  asked("--resume", request.resume, false);
}

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
                 "polymer; friction, heat, load capability\n"
                 "plan, run, submit, status, merge  many cases of your own, here or on a cluster: "
                 "docs/many-cases.md\n";
    return kDone;
  }
  if (std::find(kOfMany.begin(), kOfMany.end(), request.name) != kOfMany.end()) {
    expect_own_options(request);
    return study_of_many(request);
  }
  if (std::find(kStudies.begin(), kStudies.end(), request.name) != kStudies.end()) {
    expect_no_points(request);
    return request.name == "ks-rig" ? study_rig(request) : study_shells(request);
  }
  std::vector<std::string> known = kStudies;
  known.insert(known.end(), kOfMany.begin(), kOfMany.end());
  throw InputError("NAME", "there is no study " + in_quotes(request.name) +
                               choices_for(request.name, known, "studies are"));
}

}  // namespace shellback::program
