/// run --transient: from one wall temperature to the steady state, in time.
#include <fmt/ostream.h>

#include <cmath>
#include <iostream>

#include "app/case_text.hpp"
#include "app/program/commands.hpp"
#include "app/program/outputs.hpp"
#include "app/program/run_keeper.hpp"
#include "app/program/session.hpp"
#include "app/read_case.hpp"
#include "app/table_parts.hpp"
#include "app/units.hpp"
#include "app/words/ending_words.hpp"
#include "app/words/note_words.hpp"
#include "app/write_warm_up.hpp"
#include "bearing/case_limits.hpp"
#include "bearing/judge_case.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"
#include "fidelity/solve_case.hpp"
#include "validation/rivals/rivals.hpp"

namespace shellback::program {

using namespace app;
using namespace bearing;

namespace {

double given(const std::string& option, const std::string& text, const Kind& kind) {
  try {
    return parse_quantity(text, kind);
  } catch (const UnitError& e) {
    throw InputError(option, e.what());
  }
}

/// What else `run` writes belongs to the steady state.
void expect_transient_outputs(const Request& request) {
  refuse_options({{"-o", !request.output.empty()}, {"--page", !request.page.empty()}},
                 "a transient writes --json and --picture; leave out --transient for the steady "
                 "state's");
}

WarmUpOptions warm_up_options(const Request& request) {
  expect_transient_outputs(request);
  WarmUpOptions o;
  if (!request.from.empty()) o.T_start = given("--from", request.from, kTemperature);
  if (!request.until.empty()) o.end = given("--until", request.until, kTime);
  if (const Range& can = kValueRanges.temperature; !can.holds(o.T_start)) {
    throw InputError("--from",
                     fmt::format("\"{}\" is not possible (it must {})", request.from, can.words));
  }
  if (!(o.end > 0.0)) throw InputError("--until", "the time is not positive");
  return o;
}

/// The steady or the periodic state, in which a warm-up ends.
Result steady_state(const Case& subject, SolveControl control, RunKeeper& keeper) {
  control.kept = subject.cycle ? keeper.next() : nullptr;  // none of a steady one is kept
  return fidelity::solve_case(subject, control);
}

void print_warm_up(const Case& c, const WarmUp& run, const Result& steady) {
  std::cout << c.title << '\n';
  app::print_scene(std::cout, c);
  fmt::print(std::cout, "transient, tier {}, grid {} x {}\n\n", to_string(c.model.tier),
             c.model.grid[0], c.model.grid[1]);
  fmt::print(std::cout, "{:>36} {:>12} {:>12} {:>12} {:>12}\n", "", "largest", "largest", "mean",
             "mean");
  fmt::print(std::cout, "{:>12} {:>12} {:>10} {:>12} {:>12} {:>12} {:>12}\n", "time [s]",
             "torque [N m]", "h_min [um]", "film [degC]", "shell [degC]", "back [degC]",
             "shaft [degC]");
  double next = 0.0;
  const auto line = [](const char* t, double torque, double h, double a, double b, double d,
                       double e) {
    fmt::print(std::cout, "{:>12} {:>12.4g} {:>10.4g}", t, torque, 1e6 * h);
    for (const double T : {a, b, d, e}) {
      fmt::print(std::cout, " {:>12}",
                 std::isfinite(T) ? fmt::format("{:.1f}", T - kZeroCelsius) : "-");
    }
    fmt::print(std::cout, "\n");
  };
  for (const Instant& i : run.instants) {
    if (i.t < next && &i != &run.instants.back()) continue;
    line(fmt::format("{:.4g}", i.t).c_str(), i.torque, i.h_min, i.T_film_max, i.T_shell_max,
         i.T_shell_back, i.T_shaft);
    next = 1.5 * i.t;  // some lines a decade
  }
  if (steady.verdict.good() && std::isfinite(steady.value("friction_torque"))) {
    line("steady", steady.value("friction_torque"), steady.value("h_min"),
         steady.value("T_film_max"), steady.value("T_shell_max"), steady.value("T_shell_back"),
         steady.value("T_shaft"));
  }
  if (run.end.jumps > 0) {
    fmt::print(
        std::cout,
        "\n{} steps of the shortest length err by more than was allowed: a wall's surface jumps "
        "where oil of another temperature first meets it\n",
        run.end.jumps);
  }
  if (run.end.unfollowed > 0) {
    fmt::print(std::cout,
               "\nat {} instants the film still stored more than half a per cent of its heat after "
               "four cycles between the same walls: the bodies see so much less\n",
               run.end.unfollowed);
  }
  fmt::print(std::cout, "\naudit (relative)  heat in - heat out - heat stored: {:.1e}\n",
             run.imbalance());
  print_list(std::cout, "warnings", app::warm_up_warnings(c, run, steady));
  print_list(std::cout, "assumptions", warm_up_assumptions(c, steady));
}

}  // namespace

int transient(const Request& request) {
  if (!request.speeds.empty()) return course(request, warm_up_options(request));
  if (!request.hold.empty()) throw InputError("--hold", "belongs to --speeds; add them");
  const std::string text = read_text_file(request.case_file);
  const Case subject =
      validation::with_rivals(read_case_text(text, request.case_file, overrides_of(request)));
  expect_no_coefficients(request, subject, "a transient is asked for");
  const WarmUpOptions options = warm_up_options(request);
  if (subject.cycle && options.end < subject.cycle->length()) {
    throw InputError("--until", fmt::format("is shorter than one load cycle, {:.4g} s",
                                            subject.cycle->length()));
  }
  RunKeeper keeper(request, subject, RunOf::warm_up,
                   {{"--from", {options.T_start}}, {"--until", {options.end}}});
  Outputs outputs(with_state(request),
                  files_of_case(text, request.case_file, overrides_of(request)));
  tell_warnings(subject);
  ProgressLine progress;
  SolveControl control = control_for(progress);
  control.kept = keeper.kept();
  const WarmUp run = warm_up(subject, subject.model.tier, options, control);
  Result steady;
  steady.verdict = {Status::interrupted};  // as long as it is not solved
  if (run.instants.empty()) {
    std::cerr << "error: transient: " << reason_of(run.end.verdict) << "\n";
    outputs.give("--json", [&] { return warm_up_json(subject, run, options, steady); });
    const int code = outputs.code(code_of(run.end.verdict));
    keeper.end(code);
    return code;
  }
  const bool stopped = run.end.verdict.status == Status::interrupted;
  if (!stopped) steady = steady_state(subject, control, keeper);
  if (request.json != "-") print_warm_up(subject, run, steady);
  if (!run.end.verdict.good()) {
    std::cerr << fmt::format("error: transient: ended after {:.4g} s: {}\n", run.end.t,
                             reason_of(run.end.verdict));
  }
  outputs.give("--json", [&] { return warm_up_json(subject, run, options, steady); });
  outputs.give("--picture", [&] { return warm_up_svg(subject, run, steady); });
  const bool late =
      run.end.verdict.good() && code_of(steady.verdict, steady.warnings) == kInterrupted;
  if (late) tell_verdict(steady);
  const int code = outputs.code(late ? kInterrupted : code_of(run.end.verdict));
  keeper.end(code);
  return code;
}

}  // namespace shellback::program
