/// run --running-in: the shell wears until the time given, or until it is worn in.
#include <fmt/ostream.h>

#include <cmath>
#include <iostream>

#include "app/followed.hpp"
#include "app/labels/table_parts.hpp"
#include "app/program/commands.hpp"
#include "app/program/outputs.hpp"
#include "app/program/run_keeper.hpp"
#include "app/program/session.hpp"
#include "app/reading/case_text.hpp"
#include "app/reading/read_case.hpp"
#include "app/write_curves.hpp"
#include "app/write_running_in.hpp"
#include "fidelity/running_in_bars.hpp"
#include "validation/rivals/rivals.hpp"

namespace shellback::program {

using namespace app;
using namespace bearing;

namespace {

/// What else `run` writes belongs to one state.
void expect_running_in_outputs(const Request& request) {
  refuse_options(
      {{"-o", !request.output.empty()},
       {"--transient", request.transient},
       {"--page", !request.page.empty()}},
      "a running-in writes --json, --csv, --picture and --profile; give the profile to a case "
      "as bearing.shape and run that for all else");
}

/// The cycle of the last state: how it was told, and its audit.
void print_cycle(const CycleResult& cycle, int cycles) {
  fmt::print(std::cout,
             "\ncontact and film are extremes of the cycle, torque is its mean; {} cycles passed\n",
             cycles);
  fmt::print(std::cout, "last cycle: closed within {:.1e}, audit mass {:.1e}", cycle.closure,
             cycle.audit.mass);
  if (std::isfinite(cycle.audit.energy)) {
    fmt::print(std::cout, ", energy {:.1e}, walls {:.1e} K", cycle.audit.energy, cycle.audit.walls);
  }
  fmt::print(std::cout, "\n");
}

void print_words_of_last_state(const RunningInRun& run) {
  const std::vector<std::string> told = words_of_last_state(run);
  if (told.empty()) return;
  if (!run.cycle) fmt::print(std::cout, "\nthe last state:\n");
  for (const std::string& line : told) fmt::print(std::cout, "  - {}\n", line);
}

int cycles_of(const RunningInRun& run) {
  int sum = 0;
  for (const RunningInState& s : run.states) sum += s.cycles;
  return sum;
}

/// Control that shows where the wear has come to while a state is solved.
SolveControl control_over(ProgressLine& line, RunningInState& latest) {
  SolveControl control = control_for(line);
  control.progress = [&line, &latest](const Progress& p) {
    if (p.stage == "shape") {
      line.show(
          fmt::format("worn-in shape {}: {:.1e} summit roughnesses away", p.step, p.residual));
      return;
    }
    line.show(fmt::format("running-in {:.4g} s, wear {:.3g} um: {} step {}", latest.t,
                          1e6 * latest.depth, p.stage, p.step));
  };
  return control;
}

/// What a run of the profile needs beside it.
void tell_what_is_worn(const Case& c, const RunningInRun& run) {
  const std::string keys = worn_surface_keys(c, run);
  if (keys.empty()) return;
  fmt::print(std::cout, "\nthe shell's surface at the end, to be given with the profile:\n  {}\n",
             keys);
}

void print_states(const RunningInRun& run, const fidelity::RunningInBars& bars) {
  struct Column {
    const char *name, *unit;
    double RunningInState::*value;
    double factor;
  };
  constexpr Column columns[] = {{"wear", "[um]", &RunningInState::depth, 1e6},
                                {"volume", "[mm3]", &RunningInState::volume, 1e9},
                                {"contact", "[MPa]", &RunningInState::p_asperity_max, 1e-6},
                                {"torque", "[N m]", &RunningInState::torque, 1.0},
                                {"h_min", "[um]", &RunningInState::h_min, 1e6}};
  std::string names = fmt::format("{:>10}", "time"), units = fmt::format("{:>10}", "[s]");
  for (const Column& c : columns) {
    names += fmt::format(" {:>9} {:>8}", c.name, "+-");
    units += fmt::format(" {:>9} {:>8}", c.unit, "");
  }
  fmt::print(std::cout, "{}\n{}\n", names, units);
  for (std::size_t k = 0; k < run.states.size(); ++k) {
    const double t = run.states[k].t;
    const bool found = run.verdict.good();
    std::string line = fmt::format(
        "{:>10}", std::isfinite(t) ? fmt::format("{:.4g}", t) : (found ? "worn in" : "last tried"));
    for (const Column& c : columns) {
      const double bar = c.factor * bars.at(k, c.value);
      line += fmt::format(" {:>9.4g} {:>8}", c.factor * (run.states[k].*c.value),
                          std::isfinite(bar) ? fmt::format("{:.2g}", bar) : "-");
    }
    fmt::print(std::cout, "{}\n", line);
  }
}

}  // namespace

int running_in(const Request& request) {
  expect_running_in_outputs(request);
  const std::string text = read_text_file(request.case_file);
  const Case subject =
      validation::with_rivals(read_case_text(text, request.case_file, overrides_of(request)));
  expect_running_in(subject, subject.model.tier);
  expect_no_coefficients(request, subject, "a running-in is asked for");
  RunKeeper keeper(request, subject, RunOf::running_in);
  Outputs outputs(with_state(request),
                  files_of_case(text, request.case_file, overrides_of(request)));
  tell_warnings(subject);
  ProgressLine progress;
  RunningInState latest;
  SolveControl control = control_over(progress, latest);
  control.kept = keeper.kept();
  const RunningInRun run =
      run_in(subject, subject.model.tier, control,
             [&](const RunningInRun& so_far) { latest = so_far.states.back(); });
  const fidelity::RunningInBars bars = fidelity::running_in_bars(subject, run, control);
  progress.wipe();
  if (!run.states.empty() && prints_tables(request)) {
    std::cout << subject.title << '\n';
    app::print_scene(std::cout, subject);
    fmt::print(std::cout, "running-in, tier {}, grid {} x {}\n\n", to_string(subject.model.tier),
               subject.model.grid[0], subject.model.grid[1]);
    print_states(run, bars);
    for (const std::string& words : words_of_bars(subject, run, bars))
      fmt::print(std::cout, "{}\n", words);
    if (run.cycle) print_cycle(*run.cycle, cycles_of(run));
    print_words_of_last_state(run);
    if (std::isfinite(run.complementarity)) {
      fmt::print(std::cout, "\ncomplementarity of wear and contact pressure {:.1e}\n",
                 run.complementarity);
    }
  }
  if (!run.states.empty() && prints_tables(request)) tell_what_is_worn(subject, run);
  if (!run.verdict.good()) tell_verdict(subject.model.tier, run.verdict);
  outputs.give("--json", [&] { return running_in_json(subject, run, bars); });
  if (!run.states.empty()) {
    outputs.give("--csv", [&] {
      return curves_csv(curves_of(run.states, bars, kFollowedStates), run.verdict);
    });
    outputs.give("--picture", [&] { return running_in_svg(subject, run, bars); });
    outputs.give("--profile", [&] { return worn_shape_csv(subject, run); });
  }
  const bool late = run.verdict.good() && bars.interrupted;
  const int code = outputs.code(late ? kInterrupted : code_of(run.verdict));
  keeper.end(code);
  return code;
}

}  // namespace shellback::program
