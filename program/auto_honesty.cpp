#include "proof/auto_honesty.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

#include "app/progress.hpp"
#include "program/commands.hpp"
#include "program/outputs.hpp"
#include "program/session.hpp"
#include "proof/auto_report.hpp"

namespace shellback::program {

int auto_honesty(const Request& request) {
  Outputs outputs(request, {});
  proof::AutoStudy study;
  study.first_seed = request.seed;
  study.cases = request.cases;
  study.at_once = request.threads;
  study.budget_s = request.budget_s;
  study.stop = &app::catch_interrupt();
  const bool terminal = isatty(STDERR_FILENO) == 1;
  if (terminal) {
    study.told = [](int done, int of) { std::cerr << fmt::format("\r{} of {} cases ", done, of); };
  }
  const auto trials = proof::judge_auto(study);
  if (terminal) std::cerr << "\r                      \r";
  if (request.json != "-") proof::write_auto_honesty(std::cout, trials, study);
  outputs.give("--json", [&] { return proof::auto_honesty_json(trials, study); });
  return outputs.code(study.stop->load() ? kInterrupted : kDone);
}

}  // namespace shellback::program
