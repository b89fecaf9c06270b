#include "app/study/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "app/labels/sweep_columns.hpp"
#include "app/pictures/svg_sweep.hpp"
#include "app/program/commands.hpp"
#include "app/program/outputs.hpp"
#include "app/program/run_keeper.hpp"
#include "app/program/session.hpp"
#include "app/reading/case_text.hpp"
#include "app/reading/read_axis.hpp"
#include "app/reading/sweep_case.hpp"
#include "app/write_coefficients.hpp"
#include "app/write_csv.hpp"
#include "app/write_json.hpp"
#include "app/write_sweep_hdf5.hpp"
#include "app/write_sweep_table.hpp"
#include "bearing/over_time/cycle.hpp"
#include "core/contract.hpp"
#include "core/parallel.hpp"
#include "fidelity/solve.hpp"
#include "fidelity/solve_case.hpp"
#include "validation/rivals/rivals.hpp"

namespace shellback::program {

using namespace app;
using study::Axis;
using study::Sweep;

namespace {

/// The bars of the physics left out are not told of points over a load cycle.
void expect_bars_of_points(const Request& request, const bearing::Case& subject,
                           const std::vector<Axis>& axes) {
  std::vector<std::string> tiers{to_string(subject.model.tier)};
  for (const Axis& axis : axes) {
    if (axis.key == "model.tier") tiers = axis.words;
  }
  const bool have_their_own = std::all_of(tiers.begin(), tiers.end(), [](const std::string& tier) {
    return tier == to_string(bearing::Tier::estimate) ||
           tier == to_string(bearing::Tier::automatic);
  });
  if (!request.bars || !subject.cycle || have_their_own) return;
  throw InputError("--bars",
                   "over a load cycle a sweep tells the bars of grid and steps alone; tier auto "
                   "judges the physics left out, and compare solves the tiers beside each other");
}

Sweep solve_all(const std::vector<Axis>& axes, const study::CaseAt& case_at, int threads,
                const Request& request, PointKeepers& keepers) {
  ProgressLine line;
  study::SweepOptions options;
  options.threads = threads;
  options.stop = &catch_interrupt();
  options.solve_alone = [&](int k, const bearing::Case& c, bearing::SolveControl control) {
    if (c.cycle) control.kept = keepers.kept(k, c);
    const bool tier_alone =
        c.model.tier != bearing::Tier::estimate && c.model.tier != bearing::Tier::automatic;
    const bool cycle_alone = c.cycle && request.no_bars && tier_alone;
    bearing::Result r = cycle_alone
                            ? bearing::as_result(bearing::solve_cycle(c, c.model.tier, control))
                            : fidelity::solve_case(c, control);
    if (control.kept != nullptr && r.verdict.status != Status::interrupted) {
      control.kept->note_ended();
    }
    return r;
  };
  fidelity::KeptSolids kept;
  const auto bars =
      request.bars ? fidelity::WantedBars::grid_and_model : fidelity::WantedBars::grid;
  if (!request.no_bars) {
    options.sum_up = [&](const bearing::Solution& s, bearing::Tier tier,
                         const bearing::SolveControl& control) {
      return fidelity::summarize(s, tier, control, bars, &kept);
    };
  }
  options.progress = [&](const study::SweepProgress& now) {
    line.show(fmt::format("{} of {} points{}", now.done, now.total,
                          now.failed > 0 ? fmt::format(", {} not solved so far", now.failed) : ""));
  };
  const auto with_rivals_at = [&](const study::Position& at) {
    return validation::with_rivals(case_at(at));
  };
  return run_sweep(axes, with_rivals_at, options);
}

/// The isothermal tier takes its temperature from a measured one, which belongs to one point.
void warn_of_one_measurement(const bearing::Case& subject, const std::vector<Axis>& axes) {
  const bool isothermal = subject.model.tier == bearing::Tier::isothermal;
  const bool varied = std::any_of(
      axes.begin(), axes.end(), [](const Axis& axis) { return axis.key.starts_with("measured."); });
  if (!isothermal || varied || !subject.measured.shell_back_temperature) return;
  std::cerr << "warning: the film temperature of every point follows from the one "
               "measured.shell_back_temperature of the case\n";
}

/// A table of coefficients has no column for anything but the speed.
void expect_rows_of_speeds(const Request& request, const std::vector<Axis>& axes) {
  const bool speeds = axes.size() == 1 && axes.front().key == "operation.speed";
  if (speeds || request.coefficients_table.empty()) return;
  throw InputError("--coefficients-table",
                   "its rows differ by the speed alone: --vary operation.speed=FROM..TO/N and "
                   "nothing else");
}

void give_files(Outputs& outputs, const std::string& text, const bearing::Case& subject,
                const Sweep& sweep) {
  outputs.give("-o", [&] { return sweep_hdf5(subject, sweep); });
  outputs.give("--csv", [&] { return sweep_csv(sweep); });
  outputs.give("--picture", [&] { return sweep_svg(text, subject, sweep); });
  outputs.give("--json", [&] { return sweep_json(subject, sweep); });
  outputs.give("--coefficients-table", [&] {
    std::vector<bearing::Coefficients> known;
    for (const study::SweepPoint& point : sweep.points) {
      const auto& k = point.result.coefficients;
      if (point.good() && k && k->verdict.good()) known.push_back(*k);
    }
    return coefficients_csv(known);
  });
}

}  // namespace

int sweep(const Request& request) {
  const std::vector<Override> set = overrides_of(request);
  const std::vector<Axis> axes = parse_axes(request.vary, set);
  if (!request.picture.empty()) expect_drawable(axes);
  expect_rows_of_speeds(request, axes);
  const std::string text = read_text_file(request.case_file);
  const bearing::Case subject = sweep_subject(text, request.case_file, set, axes);
  expect_bars_of_points(request, subject, axes);
  Outputs outputs(request, files_of_sweep(text, request.case_file, set, axes));
  warn_of_one_measurement(subject, axes);
  if (!subject.cycle) {
    refuse_options({{"--resume", request.resume}, {"--state", !request.state.empty()}},
                   "belongs to a load cycle; a sweep of steady states is solved anew");
  }
  int points = subject.cycle ? 1 : 0;
  for (const Axis& axis : axes) points *= axis.size();
  PointKeepers keepers(request, points);
  const Sweep done =
      solve_all(axes, case_source(text, request.case_file, set, axes),
                request.cores > 0 ? request.cores : hardware_threads(), request, keepers);
  if (prints_tables(request)) write_sweep_table(std::cout, subject, done);
  give_files(outputs, text, subject, done);
  if (done.interrupted) std::cerr << "interrupted: " << count_words(done) << "\n";
  const bool failed = !done.interrupted && done.count_failed() > 0;
  if (failed) std::cerr << "error: " << count_words(done) << "\n";
  const int code = outputs.code(done.interrupted ? kInterrupted : failed ? kNotConverged : kDone);
  keepers.end(code);
  return code;
}

}  // namespace shellback::program
