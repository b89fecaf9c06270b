#include "app/program/proof_options.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/program/option_parts.hpp"
#include "app/reading/did_you_mean.hpp"

namespace shellback::program {
namespace {

using app::in_quotes;

constexpr double kLongest = 1e5;  ///< a day and more [s]

/// From a tenth of a second; not-a-number is no time, though no comparison says so.
CLI::Validator processor_seconds() {
  const auto fault = [](const std::string& text) {
    double seconds = NAN;
    const bool read = CLI::detail::lexical_cast(text, seconds);
    if (read && seconds >= 0.1 && seconds <= kLongest) return std::string();
    return fmt::format("{} is no time from 0.1 to {:g} s", in_quotes(text), kLongest);
  };
  return CLI::Validator(fault, fmt::format("FLOAT in [0.1 - {:g}]", kLongest));
}

void add_budget(CLI::App& command, Request& request) {
  command
      .add_option(
          "--budget", request.budget_s,
          "processor time of a case [s] (default: 32, so that 217 cases on two cores take at "
          "most an hour); a case that needs more counts as not judged")
      ->type_name("S")
      ->check(processor_seconds());
}

}  // namespace

void add_validate(CLI::App& app, Request& request) {
  auto* validate = app.add_subcommand(
      "validate", "rerun the ledger: ours, theirs, difference, tolerance, verdict");
  validate->add_option("NAME", request.names, "entries; without one, all of them");
  validate->add_flag("--list", request.list, "list the entries without running them");
  validate->add_flag("--rows", request.all_rows, "print every row, not only the worst");
  add_force(*validate, request);
  add_threads(*validate, request, "threads that may be used");
  validate->add_option("-o", request.output, "write the page with figures and bands (HTML)")
      ->type_name("FILE.html");
  validate->add_option("--csv", request.csv, "write every row as a table; - is standard output")
      ->type_name("FILE");
  validate
      ->add_option("--json", request.json,
                   "also write the ledger as JSON; - is standard output, without the tables")
      ->type_name("FILE");
  validate->add_option("--ledger", request.ledger, "folder of entries (default: the shipped ones)")
      ->type_name("FOLDER");
}

void add_chart(CLI::App& app, Request& request) {
  auto* chart = app.add_subcommand("chart", "speed against accuracy of grids, tiers and methods");
  chart->add_option("SCENE", request.scenes,
                    "shipped scenes or case files (default: all shipped scenes)");
  chart->add_option("-o", request.output, "write the picture (SVG)")->type_name("FILE.svg");
  chart->add_option("--png", request.png, "write the picture as pixels")->type_name("FILE.png");
  chart->add_option("--csv", request.csv, "write all numbers; - is standard output")
      ->type_name("FILE.csv");
  chart->add_flag("--quick", request.quick, "coarser grids, each solve timed once");
  add_force(*chart, request);
  add_threads(*chart, request, "threads for the references; timed solves run one at a time");
}

void add_stress(CLI::App& app, Request& request) {
  auto* stress = app.add_subcommand("stress", "the stability map: hard scenes by methods");
  stress->add_option("SCENE", request.scenes, "scene or scene/tier (default: all)");
  stress->add_flag("--list", request.list, "list the scenes and do nothing else");
  stress->add_option("-o", request.output, "write the map as a picture (SVG)")
      ->type_name("FILE.svg");
  stress->add_option("--table", request.table, "write the map as a page with tables (Markdown)")
      ->type_name("FILE.md");
  stress->add_option("--csv", request.csv, "write all cells; - is standard output")
      ->type_name("FILE.csv");
  stress->add_option("--json", request.json, "write all cells; - is standard output")
      ->type_name("FILE");
  stress->add_flag("--quick", request.quick,
                   "coarser grids where the scene does not choose its own");
  stress->add_flag("--only-default", request.only_default, "leave out the other methods");
  stress->add_option("--limit", request.limit_s, "processor time after which a solve hangs [s]")
      ->type_name("S")
      ->check(processor_seconds());
  add_force(*stress, request);
  add_threads(*stress, request, "solves that run at the same time");
}

void add_honesty(CLI::App& app, Request& request) {
  auto* honesty =
      app.add_subcommand("honesty", "measure on random bearings whether the error bars hold");
  honesty->add_option("--cases", request.cases, "random bearings (default: 200)")
      ->type_name("N")
      ->check(CLI::Range(0, 100000));
  honesty->add_option("--seed", request.seed, "of the first of them (default: 1)")
      ->type_name("N")
      ->check(CLI::Range(0, 2000000000));
  add_list(*honesty, "--tiers", request.tiers,
           "isothermal, lumped, thd or tehd (default: all of them)");
  add_list(*honesty, "--grids", request.grids, "whose bars are tested (default: 200x25)")
      ->type_name("NxM,...");
  honesty->add_option("--truth", request.truth, "grid of the truth (default: 400x50)")
      ->type_name("NxM");
  honesty->add_option("--nodes", request.nodes, "nodes across the film of the truth (default: 7)")
      ->type_name("N")
      ->check(CLI::Range(5, 15));
  honesty->add_flag("!--random-only", request.known,
                    "leave out the shipped cases and those of the ledger and the chart");
  honesty->add_option("--json", request.json, "write every bar; - is standard output")
      ->type_name("FILE");
  honesty->add_option("-o", request.output, "write the picture (SVG)")->type_name("FILE.svg");
  add_budget(*honesty, request);
  add_force(*honesty, request);
  add_threads(*honesty, request, "cases solved at the same time");
}

void add_auto_honesty(CLI::App& app, Request& request) {
  constexpr int kMostCases = 1000000;
  auto* honesty =
      app.add_subcommand("auto-honesty", "judge tier auto on random bearings against fine grids");
  honesty->add_option("--cases", request.cases, "number of random bearings (default 200)")
      ->check(CLI::Range(1, kMostCases));
  honesty->add_option("--seed", request.seed, "of the first bearing (default 1)")
      ->check(CLI::Range(0, kMostCases));
  honesty->add_option("--json", request.json, "also write every trial as JSON")->type_name("FILE");
  add_budget(*honesty, request);
  add_force(*honesty, request);
  add_threads(*honesty, request, "bearings at the same time");
}

void add_study(CLI::App& app, Request& request) {
  constexpr int kMostTasks = 100000;
  auto* study = app.add_subcommand(
      "study", "rerun a published series of tests (ks-rig, shells), or many cases of your own");
  study->add_option(
      "NAME", request.name,
      "which study (without one they are listed), or plan, run, submit, status, merge");
  study->add_option("FOLDER", request.names, "of run, submit, status, merge; of plan: the cases")
      ->type_name("CASE|FOLDER");
  study->add_flag("--quick", request.quick, "fewer speeds, a coarser grid, no bands");
  study->add_option("-o", request.output, "write the page (HTML); of plan: the folder to be made")
      ->type_name("FILE.html|FOLDER");
  study->add_option("--vary", request.vary, "of plan: a key and its values, as in sweep")
      ->type_name("KEY=FROM..TO[/N][log]")
      ->allow_extra_args(false);
  study->add_option("--set", request.set, "of plan: change all cases; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  study->add_option("--tier", request.tier, "of plan: of all cases");
  study->add_option("--part", request.part, "of run: every N-th point, from the I-th")
      ->type_name("I/N");
  study
      ->add_option("--tasks", request.tasks,
                   "of submit: tasks of the array (default: one for each point)")
      ->check(CLI::Range(1, kMostTasks));
  study->add_option("--slurm", request.slurm, "of submit: an option of sbatch; may be repeated")
      ->type_name("--OPTION=VALUE")
      ->allow_extra_args(false);
  study->add_option("--csv", request.csv, "of merge: a row a point; - is standard output")
      ->type_name("FILE.csv");
  study
      ->add_option("--json", request.json,
                   "also write every number as JSON; - is standard output, without the tables")
      ->type_name("FILE");
  add_state(*study, request, "a study");
  add_force(*study, request);
  add_cores(*study, request,
            "threads, of run: points at the same time; of submit: cores of a task");
}

}  // namespace shellback::program
