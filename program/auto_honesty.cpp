#include "proof/auto_honesty.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/progress.hpp"
#include "program/commands.hpp"
#include "program/outputs.hpp"
#include "program/session.hpp"

namespace shellback::program {
namespace {

using proof::AutoTrial;

std::string json_of(const std::vector<AutoTrial>& trials) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const AutoTrial& t : trials) {
    nlohmann::ordered_json one{{"seed", t.seed},
                               {"truth_converged", t.truth_converged},
                               {"seconds_800x100", t.truth_seconds},
                               {"seconds_400x50", t.usual_seconds},
                               {"off_friction_400x50", t.usual_friction},
                               {"off_h_min_400x50", t.usual_h_min},
                               {"answers", nlohmann::ordered_json::array()}};
    for (const proof::AutoAnswer& a : t.answers) {
      one["answers"].push_back({{"tolerance", a.tolerance},
                                {"converged", a.converged},
                                {"met", a.met},
                                {"within", a.within()},
                                {"holds_limit", a.holds_limit},
                                {"off_friction", a.off_friction},
                                {"off_h_min", a.off_h_min},
                                {"bar_friction", a.bar_friction},
                                {"bar_h_min", a.bar_h_min},
                                {"seconds", a.seconds},
                                {"factorizations", a.factorizations},
                                {"chosen", a.chosen}});
    }
    all.push_back(one);
  }
  return nlohmann::ordered_json{{"trials", all}}.dump(2) + "\n";
}

}  // namespace

int auto_honesty(const Request& request) {
  Outputs outputs(request, {});
  proof::AutoStudy study;
  study.first_seed = request.seed;
  study.cases = request.cases;
  study.threads = request.threads;
  study.stop = &app::catch_interrupt();
  const bool terminal = isatty(STDERR_FILENO) == 1;
  if (terminal) {
    study.told = [](int done, int of) { std::cerr << fmt::format("\r{} of {} cases ", done, of); };
  }
  const auto trials = proof::judge_auto(study);
  if (terminal) std::cerr << "\r                      \r";
  if (request.json != "-") proof::write_auto_honesty(std::cout, trials);
  outputs.give("--json", [&] { return json_of(trials); });
  return outputs.code(study.stop->load() ? kInterrupted : kDone);
}

}  // namespace shellback::program
