/// run --transient: from one wall temperature to the steady state, in time.
#include <fmt/ostream.h>

#include <cmath>
#include <iostream>

#include "app/labels/table_parts.hpp"
#include "app/program/commands.hpp"
#include "app/program/outputs.hpp"
#include "app/program/run_keeper.hpp"
#include "app/program/session.hpp"
#include "app/reading/case_text.hpp"
#include "app/reading/read_case.hpp"
#include "app/reading/units.hpp"
#include "app/words/ending_words.hpp"
#include "app/write_curves.hpp"
#include "app/write_instants.hpp"
#include "app/write_warm_up.hpp"
#include "bearing/case_limits.hpp"
#include "core/contract.hpp"
#include "fidelity/march_bars.hpp"
#include "fidelity/solve_case.hpp"
#include "validation/rivals/rivals.hpp"

namespace shellback::program {

using namespace app;
using namespace bearing;

namespace {

/// What else `run` writes belongs to the steady state.
void expect_transient_outputs(const Request& request) {
  refuse_options(
      {{"-o", !request.output.empty()}, {"--page", !request.page.empty()}},
      "a transient writes --json, --csv and --picture; leave out --transient for the steady "
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

void print_warm_up(const Case& c, const WarmUp& run, const fidelity::MarchBars& bars,
                   const Result& steady) {
  std::cout << c.title << '\n';
  app::print_scene(std::cout, c);
  fmt::print(std::cout, "transient, tier {}, grid {} x {}\n\n", to_string(c.model.tier),
             c.model.grid[0], c.model.grid[1]);
  std::cout << instant_heading("time [s]");
  double next = 0.0;
  for (std::size_t k = 0; k < run.instants.size(); ++k) {
    const Instant& i = run.instants[k];
    if (i.t < next && k + 1 < run.instants.size()) continue;
    std::cout << instant_line(fmt::format("{:.4g}", i.t), i, bar_at(bars, k));
    next = 1.5 * i.t;  // some lines a decade
  }
  if (steady.verdict.good() && std::isfinite(steady.value("friction_torque"))) {
    Instant at, bar;
    for (const auto& q : kFollowedInstants) {
      const Quantity* of = quantity_in(steady.quantities, q.name);
      at.*q.value = of != nullptr ? of->value : NAN;
      bar.*q.value = of != nullptr ? of->error_grid : NAN;
    }
    std::cout << instant_line("steady", at, bar);
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
  print_list(std::cout, "warnings", app::warm_up_warnings(c, run, bars, steady));
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
    tell_end("transient", reason_of(run.end.verdict), run.end.verdict);
    outputs.give("--json", [&] { return warm_up_json(subject, run, options, {}, steady); });
    const int code = outputs.code(code_of(run.end.verdict));
    keeper.end(code);
    return code;
  }
  const bool stopped = run.end.verdict.status == Status::interrupted;
  if (!stopped) steady = steady_state(subject, control, keeper);
  const fidelity::MarchBars bars = fidelity::march_bars(subject, options, run, control);
  progress.wipe();
  if (prints_tables(request)) print_warm_up(subject, run, bars, steady);
  if (!run.end.verdict.good()) {
    tell_end("transient", app::end_words(run.end, bars), run.end.verdict);
  }
  outputs.give("--json", [&] { return warm_up_json(subject, run, options, bars, steady); });
  outputs.give("--csv", [&] {
    return curves_csv(curves_of(run.instants, bars, kFollowedInstants), run.end.verdict);
  });
  outputs.give("--picture", [&] { return warm_up_svg(subject, run, bars, steady); });
  const bool late = run.end.verdict.good() &&
                    (bars.interrupted || code_of(steady.verdict, steady.warnings) == kInterrupted);
  if (late) tell_verdict(steady);
  const int code = outputs.code(late ? kInterrupted : code_of(run.end.verdict));
  keeper.end(code);
  return code;
}

}  // namespace shellback::program
