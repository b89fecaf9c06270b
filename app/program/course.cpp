/// run --transient --speeds: bodies in time while the speed goes in steps.
#include <fmt/format.h>

#include <iostream>

#include "app/program/commands.hpp"
#include "app/program/outputs.hpp"
#include "app/program/run_keeper.hpp"
#include "app/program/session.hpp"
#include "app/reading/case_text.hpp"
#include "app/reading/read_axis.hpp"
#include "app/reading/read_case.hpp"
#include "app/reading/sweep_case.hpp"
#include "app/reading/units.hpp"
#include "app/words/ending_words.hpp"
#include "app/write_course.hpp"
#include "app/write_curves.hpp"
#include "app/write_instants.hpp"
#include "core/contract.hpp"
#include "fidelity/march_bars.hpp"
#include "validation/rivals/rivals.hpp"

namespace shellback::program {

using namespace app;
using namespace bearing;

namespace {

/// Time for which each speed is held [s].
double held(const Request& request) {
  if (request.hold.empty()) {
    throw InputError("--speeds", "tells no time; add --hold, for example --hold \"20 min\"");
  }
  const double time = given("--hold", request.hold, kTime);
  if (!(time > 0.0)) throw InputError("--hold", "the time is not positive");
  return time;
}

/// One unit serves all speeds: those that have none take that of one that has.
std::vector<std::string> with_units(std::vector<std::string> speeds) {
  std::string unit;
  for (const std::string& s : speeds) {
    const auto number = number_in_front(s);
    if (number && unit.empty()) unit = number->unit;
  }
  for (std::string& s : speeds) {
    const auto number = number_in_front(s);
    if (number && number->unit.empty() && !unit.empty()) s += " " + unit;
  }
  return speeds;
}

/// The case at each speed, read anew so that all judgements hold.
std::vector<Stretch> stretches_of(const Request& request, const std::string& text) {
  const double time = held(request);
  if (!request.until.empty()) {
    throw InputError("--until", "a course ends with its last speed; leave it out");
  }
  std::vector<Stretch> stretches;
  expect_no_commas_in_numbers(request.speeds, "--speeds");
  const std::vector<std::string> speeds = with_units(request.speeds);
  const auto at_speed = [&](const std::string& speed) {
    std::vector<Override> set = overrides_of(request);
    for (const Override& change : set) {
      if (change.key != "operation.speed") continue;
      throw InputError(
          "--speeds", fmt::format("the speed is also given by {}; keep one of them", change.place));
    }
    set.push_back({"operation.speed", speed, "--speeds"});
    return set;
  };
  const Case given = read_case_text(text, request.case_file, overrides_of(request));
  for (const std::string& speed : speeds) {
    const std::vector<Override> set = at_speed(speed);
    stretches.push_back(
        {validation::with_rivals(read_case_text(text, request.case_file, set)), time});
    const Case& at = stretches.back().subject;
    if (at.cycle && time < at.cycle->length()) {
      throw InputError("--hold",
                       fmt::format("is shorter than one load cycle, {:.4g} s", at.cycle->length()));
    }
    expect_speed_is_free(given, at, "--speeds");
  }
  return stretches;
}

/// What is not that of the first stretch's case.
RunOptions run_options(const std::vector<Stretch>& stretches, const WarmUpOptions& options) {
  std::vector<double> speeds;
  for (const Stretch& s : stretches) speeds.push_back(s.subject.operation.omega);
  return {{"--from", {options.T_start}},
          {"--speeds", speeds},
          {"--hold", {stretches.front().duration}}};
}

}  // namespace

int course(const Request& request, const WarmUpOptions& options) {
  const std::string text = read_text_file(request.case_file);
  const std::vector<Stretch> stretches = stretches_of(request, text);
  const Case& first = stretches.front().subject;
  expect_no_coefficients(request, first, "a transient is asked for");
  RunKeeper keeper(request, first, RunOf::course, run_options(stretches, options));
  Outputs outputs(with_state(request),
                  files_of_case(text, request.case_file, overrides_of(request)));
  tell_warnings(first);
  CourseRun run;
  fidelity::MarchBars bars;
  {
    ProgressLine line;
    SolveControl control = control_for(line);
    control.kept = keeper.kept();
    run = run_course(stretches, first.model.tier, options, control);
    bars = fidelity::march_bars(stretches, options, run, control);
  }
  if (prints_tables(request)) write_course_table(std::cout, stretches, run, bars);
  if (!run.end.verdict.good()) {
    tell_end("course", app::end_words(run.end, bars), run.end.verdict);
  }
  outputs.give("--json", [&] { return course_json(stretches, options, run, bars); });
  outputs.give("--csv", [&] { return course_csv(stretches, run, bars); });
  outputs.give("--picture", [&] { return course_svg(stretches, run, bars); });
  const bool late = run.end.verdict.good() && bars.interrupted;
  const int code = outputs.code(late ? kInterrupted : code_of(run.end.verdict));
  keeper.end(code);
  return code;
}

}  // namespace shellback::program
