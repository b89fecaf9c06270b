#include "validation/honesty/auto_honesty.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

#include "app/program/commands.hpp"
#include "app/program/outputs.hpp"
#include "app/progress.hpp"
#include "validation/honesty/auto_report.hpp"

namespace shellback::program {

int auto_honesty(const Request& request) {
  Outputs outputs(request, {});
  validation::AutoStudy study;
  study.first_seed = request.seed;
  study.cases = request.cases;
  study.at_once = request.threads;
  study.budget_s = request.budget_s;
  study.stop = &app::catch_interrupt();
  const bool terminal = isatty(STDERR_FILENO) == 1;
  if (terminal) {
    study.told = [](int done, int of) { std::cerr << fmt::format("\r{} of {} cases ", done, of); };
  }
  const auto trials = validation::judge_auto(study);
  if (terminal) std::cerr << "\r                      \r";
  if (prints_tables(request)) validation::write_auto_honesty(std::cout, trials, study);
  outputs.give("--json", [&] { return validation::auto_honesty_json(trials, study); });
  if (study.stop->load()) {
    std::cerr << fmt::format("interrupted: {} of {} cases are finished\n", trials.size(),
                             study.cases);
  }
  return outputs.code(study.stop->load() ? kInterrupted : kDone);
}

}  // namespace shellback::program
