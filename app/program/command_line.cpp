#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "app/program/cli.hpp"
#include "app/program/complaint.hpp"
#include "app/reading/did_you_mean.hpp"
#include "surface/form.hpp"

namespace shellback::program {
namespace {

using namespace app;

constexpr int kMostThreads = 1024;
constexpr int kMostTasks = 100000;
const std::string kTierWords = "estimate, isothermal, lumped, thd, tehd or auto";

void add_case_options(CLI::App& command, Request& request) {
  command.add_option("CASE", request.case_file, "case file (TOML)")->required();
  command
      .add_option("--set", request.set,
                  "change the case: --set operation.speed=\"1500 rpm\"; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

std::string without_blanks_around(const std::string& text) {
  if (is_blank(text)) return "";
  const std::size_t begin = text.find_first_not_of(' ');
  return text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

/// An option that takes a list; each part of it says something.
CLI::Option* add_list(CLI::App& command, const std::string& name, std::vector<std::string>& list,
                      const std::string& words) {
  const auto take = [name, &list](const std::vector<std::string>& given) {
    list.clear();
    for (const std::string& text : given) {
      for (std::size_t begin = 0, end = 0; begin <= text.size(); begin = end + 1) {
        end = std::min(text.find(',', begin), text.size());
        list.push_back(without_blanks_around(text.substr(begin, end - begin)));
        if (!list.back().empty()) continue;
        throw CLI::ValidationError(
            name,
            in_quotes(text) + " has a part that is empty; give a value on each side of a comma");
      }
    }
  };
  return command.add_option_function<std::vector<std::string>>(name, take, words)
      ->type_name("A,B,...")
      ->allow_extra_args(false);
}

/// From a tenth of a second; not-a-number is no time, though no comparison says so.
CLI::Validator seconds_up_to(double most) {
  const auto fault = [most](const std::string& text) {
    double seconds = NAN;
    const bool read = CLI::detail::lexical_cast(text, seconds);
    if (read && seconds >= 0.1 && seconds <= most) return std::string();
    return fmt::format("{} is no time from 0.1 to {:g} s", in_quotes(text), most);
  };
  return CLI::Validator(fault, fmt::format("FLOAT in [0.1 - {:g}]", most));
}

void add_threads(CLI::App& command, Request& request, const std::string& words) {
  command.add_option("-j", request.threads, words)
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads));
}

void add_force(CLI::App& command, Request& request) {
  command.add_flag("--force", request.force,
                   "let outputs replace files that are no results of shellback (never an input)");
}

void add_solve_options(CLI::App& command, Request& request) {
  add_case_options(command, request);
  command
      .add_option("--json", request.json,
                  "also write the result as JSON; - is standard output, without the table")
      ->type_name("FILE");
  add_force(command, request);
  add_threads(command, request, "threads that may be used (this command works on one)");
}

/// Of what takes its time.
void add_state(CLI::App& command, Request& request, const std::string& what) {
  command
      .add_option("--state", request.state,
                  "where " + what +
                      " keeps its state on the way (default: beside its first file, NAME.state)")
      ->type_name("FILE");
  command.add_flag("--resume", request.resume,
                   "go on from the state of " + what + " that was interrupted or killed");
}

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

/// `rows`: how many.
void add_coefficients_table(CLI::App& command, Request& request, const std::string& rows) {
  command
      .add_option("--coefficients-table", request.coefficients_table,
                  "write them for rotordynamics programs, " + rows +
                      ": frequency [rad/s], kxx to cyy [N/m, N s/m], the columns of a bearing in "
                      "ROSS")
      ->type_name("FILE.csv");
}

void add_coefficients(CLI::App& command, Request& request) {
  command.add_flag("--coefficients", request.coefficients,
                   "also stiffness, damping and whirl threshold (as model.coefficients = true)");
}

void add_sweep(CLI::App& app, Request& request) {
  auto* sweep = app.add_subcommand("sweep", "solve a case over ranges of its keys");
  add_case_options(*sweep, request);
  sweep
      ->add_option("--vary", request.vary,
                   "a range or a list: --vary operation.speed=\"3000 rpm..50 rpm/30log\", --vary "
                   "operation.load=\"4 kN,8 kN\"; may be repeated; points follow one another along "
                   "the first")
      ->type_name("KEY=FROM..TO[/N][log]")
      ->allow_extra_args(false);
  sweep->add_option("--tier", request.tier, kTierWords);
  auto* bars = sweep->add_flag(
      "--bars", request.bars,
      "error bars of the physics left out beside those of the grid; takes several times as long");
  sweep->add_flag("--no-bars", request.no_bars, "no error bars: for speed alone")->excludes(bars);
  add_coefficients(*sweep, request);
  add_coefficients_table(*sweep, request, "a row a speed, with --vary operation.speed alone");
  add_state(*sweep, request, "a sweep over load cycles");
  sweep->add_option("-o", request.output, "write all results over the grid (HDF5)")
      ->type_name("FILE.h5");
  sweep->add_option("--csv", request.csv, "write a table, one line a point; - is standard output")
      ->type_name("FILE.csv");
  sweep->add_option("--picture", request.picture, "draw the curves or maps (SVG)")
      ->type_name("FILE.svg");
  sweep->add_option("--json", request.json, "write all results as JSON; - is standard output")
      ->type_name("FILE");
  add_force(*sweep, request);
  sweep->add_option("-j", request.cores, "threads (default: all cores)")
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads));
}

void add_identify(CLI::App& app, Request& request) {
  auto* identify = app.add_subcommand("identify", "fit keys of a case to measurements");
  add_case_options(*identify, request);
  identify
      ->add_option("--data,--measured", request.measured,
                   "measured points (CSV): where (speed [rpm], load [kN], ...) and what "
                   "(friction_torque [N m], friction_torque_sd [N m], ...)")
      ->type_name("DATA.csv");
  identify
      ->add_option("--fit", request.fit,
                   "keys to be fitted, from their values in the case, between bounds (a tenth and "
                   "ten times the value, of temperatures 50 K, where none are given); parted by "
                   "commas or repeated")
      ->type_name("KEY[=FROM..TO]")
      ->allow_extra_args(false);
  identify
      ->add_option("--bounds", request.bounds, "the same as --fit KEY=LOW..HIGH; repeated for each")
      ->type_name("KEY=LOW:HIGH")
      ->allow_extra_args(false);
  identify->add_option("--tier", request.tier, "isothermal, lumped, thd or tehd");
  identify
      ->add_option("--csv", request.csv,
                   "write measured and computed values; - is standard "
                   "output")
      ->type_name("FILE.csv");
  identify->add_option("--picture", request.picture, "draw measured and fitted curves (SVG)")
      ->type_name("FILE.svg");
  identify
      ->add_option("--json", request.json,
                   "write keys, deviations and points; - is standard output")
      ->type_name("FILE");
  add_force(*identify, request);
  identify->add_option("-j", request.cores, "threads (default: all cores)")
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads));
}

void add_stress(CLI::App& app, Request& request) {
  constexpr double kLongest = 1e5;  // a day and more
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
      ->check(seconds_up_to(kLongest));
  add_force(*stress, request);
  stress->add_option("-j", request.threads, "solves that run at the same time")
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads));
}

void add_budget(CLI::App& command, Request& request) {
  constexpr double kLongest = 1e5;  // a day and more
  command
      .add_option(
          "--budget", request.budget_s,
          "processor time of a case [s] (default: 32, so that 217 cases on two cores take at "
          "most an hour); a case that needs more counts as not judged")
      ->type_name("S")
      ->check(seconds_up_to(kLongest));
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

void add_study(CLI::App& app, Request& request) {
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
  study
      ->add_option("-j", request.cores,
                   "threads; of run: points at the same time (default: all cores); of submit: "
                   "cores of a task")
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads));
}

void add_init(CLI::App& app, Request& request) {
  auto* init = app.add_subcommand("init", "list the shipped cases, or write one to start from");
  init->add_option("NAME", request.name, "shipped case; without it they are listed");
  init->add_option("-o", request.output, "file to write (default: NAME.toml)")
      ->type_name("FILE.toml");
}

void add_check(CLI::App& app, Request& request) {
  auto* check = app.add_subcommand("check", "read and judge a case without solving it");
  add_case_options(*check, request);
  check->add_option("--tier", request.tier, kTierWords);
}

void add_run(CLI::App& app, Request& request) {
  auto* run = app.add_subcommand("run", "solve a case");
  add_solve_options(*run, request);
  run->add_option("--tier", request.tier, kTierWords);
  run->add_option("-o", request.output, "write all fields (HDF5)")->type_name("FILE.h5");
  add_coefficients(*run, request);
  add_coefficients_table(*run, request, "one row");
  run->add_flag("--transient", request.transient,
                "warm up in time: shell, housing and shaft from one temperature to the steady "
                "state (tiers thd and tehd)");
  run->add_option("--from", request.from,
                  "temperature of shell, housing and shaft at the start (default 20 degC)")
      ->type_name("TEMPERATURE");
  run->add_option("--until", request.until, "end of the transient (default: until at rest)")
      ->type_name("TIME");
  run->add_flag("--running-in", request.running_in,
                "let the shell wear as [running_in] says: over a time, or until it is worn in");
  run->add_option("--profile", request.profile,
                  "write the worn shape, which a case takes as bearing.shape (CSV)")
      ->type_name("FILE.csv");
  add_list(*run, "--speeds", request.speeds,
           "with --transient: speeds one after the other, bodies carried over: --speeds "
           "\"1000 rpm,2000 rpm,1000 rpm\"");
  run->add_option("--hold", request.hold, "time for which each of --speeds is held: \"20 min\"")
      ->type_name("TIME");
  run->add_option("--picture", request.picture,
                  "draw it: the steady film, the load cycle, the transient, the running-in (SVG)")
      ->type_name("FILE.svg");
  run->add_option("--csv", request.csv,
                  "write what a load cycle, a transient or a running-in follows over time as a "
                  "table; - is standard output")
      ->type_name("FILE.csv");
  run->add_option("--page", request.page,
                  "write the steady state or the load cycle, its film in motion, as a page (HTML)")
      ->type_name("FILE.html");
  add_state(*run, request, "a load cycle, a running-in or a transient");
}

void add_compare(CLI::App& app, Request& request) {
  auto* compare = app.add_subcommand("compare", "solve a case in several tiers, side by side");
  add_solve_options(*compare, request);
  add_list(*compare, "--tiers", request.tiers, "tiers to compare (default: all the case allows)");
  compare->add_option("-o", request.output, "write the comparison as a page (HTML)")
      ->type_name("FILE.html");
  compare->add_option("--picture", request.picture, "write the main picture (SVG)")
      ->type_name("FILE.svg");
  add_state(*compare, request, "a comparison over a load cycle");
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
  honesty->add_option("-j", request.threads, "bearings at the same time")
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads));
}

void add_surface_choices(CLI::App& surface, Request& request) {
  surface
      .add_option("--motion", request.motion,
                  "axis of the map along which surfaces slide (default x)")
      ->check(CLI::IsMember({"x", "y"}));
  surface
      .add_option("--form", request.form, "degree of the form removed (default 2; 1: tilt only)")
      ->check(CLI::Range(0, surface::kHighestForm));
  surface
      .add_option("--fill", request.fill,
                  "fill holes: laplace (harmonic interpolation); without it they are refused")
      ->check(CLI::IsMember({"laplace"}));
  add_list(surface, "--gaps", request.gaps,
           "h/sigma of the flow factors, three values or more (default 0.5 to 10)")
      ->type_name("H,H,...");
  surface
      .add_option("--error", request.error, "largest standard error of Rq allowed (default 10 %)")
      ->type_name("SHARE");
  surface.add_flag("--periodic", request.periodic,
                   "the map repeats itself at its sides (default: no flow over them)");
  surface.add_option("--composite-modulus", request.modulus, "contact pressures in MPa: E*")
      ->type_name("PRESSURE");
  surface
      .add_option("--hardness", request.hardness, "of the softer surface: bearing area times it")
      ->type_name("PRESSURE");
}

void add_surface(CLI::App& app, Request& request) {
  auto* surface = app.add_subcommand(
      "surface", "roughness, summits, contact and flow factors of a measured height map");
  surface->add_option("MAP", request.case_file, "height map (text; docs/surfaces.md)")->required();
  add_surface_choices(*surface, request);
  surface->add_option("--csv", request.csv, "write the flow factors for surfaces.flow_factors")
      ->type_name("FILE");
  surface
      ->add_option("--json", request.json,
                   "also write everything as JSON; - is standard output, without the table")
      ->type_name("FILE");
  surface->add_option("--picture", request.picture, "draw map, heights, factors, contact (SVG)")
      ->type_name("FILE.svg");
  add_force(*surface, request);
  surface->add_option("-j", request.cores, "gaps solved at the same time (default: all cores)")
      ->type_name("N")
      ->check(CLI::Range(1, kMostThreads));
}

void add_report(CLI::App& app, Request& request) {
  auto* report = app.add_subcommand("report", "one page of a result file, from that file alone");
  report->add_option("FILE.h5", request.case_file, "result of run -o (HDF5)")->required();
  report->add_option("-o", request.output, "the page (HTML)")->type_name("FILE.html")->required();
  add_force(*report, request);
}

void add_export(CLI::App& app, Request& request) {
  auto* out = app.add_subcommand("export", "the film of a result file for ParaView");
  out->add_option("FILE.h5", request.case_file, "result of run -o (HDF5)")->required();
  out->add_option("--vtu", request.vtu, "folder for film.vtu and, of a load cycle, film.pvd")
      ->type_name("FOLDER")
      ->required();
  add_force(*out, request);
}

void add_help(CLI::App& app, Request& request) {
  auto* help =
      app.add_subcommand("help", "of a command, or all keys of a case: help keys [SECTION]");
  help->add_option("TOPIC", request.name, "a command, or keys");
  help->add_option("SECTION", request.names, "of keys: bearing, supply, oil, ... (default: all)");
}

/// A command as it is offered.
struct Offer {
  std::string name;
  Command command;
  void (*add)(CLI::App&, Request&);
};
const std::vector<Offer> kOffers{
    {"init", Command::init, add_init},
    {"check", Command::check, add_check},
    {"run", Command::run, add_run},
    {"compare", Command::compare, add_compare},
    {"sweep", Command::sweep, add_sweep},
    {"identify", Command::identify, add_identify},
    {"surface", Command::surface, add_surface},
    {"report", Command::report, add_report},
    {"export", Command::export_film, add_export},
    {"help", Command::help, add_help},
    {"auto-honesty", Command::auto_honesty, add_auto_honesty},
    {"honesty", Command::honesty, add_honesty},
    {"chart", Command::chart, add_chart},
    {"stress", Command::stress, add_stress},
    {"study", Command::study, add_study},
    {"validate", Command::validate, add_validate},
};

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const Offer& offer : kOffers) names.push_back(offer.name);
  return names;
}

Command command_of(const CLI::App& app) {
  for (const Offer& offer : kOffers) {
    if (app.got_subcommand(offer.name)) return offer.command;
  }
  return Command::none;
}

/// A first word that is no command, unless it is an option.
std::string unknown_command(const std::vector<std::string>& words) {
  if (words.empty() || words.front().starts_with("-")) return "";
  const auto known = command_names();
  if (std::find(known.begin(), known.end(), words.front()) != known.end()) return "";
  return "there is no command " + in_quotes(words.front()) +
         choices_for(words.front(), known, "commands are");
}

/// What is told of a command; of none, of all.
Reading help_on(const std::string& topic, const std::string& more) {
  if (topic.empty()) return read_command_line({"--help"});
  std::vector<std::string> known = command_names();
  if (std::find(known.begin(), known.end(), topic) != known.end()) {
    return read_command_line({topic, "--help"});
  }
  known.emplace_back("keys");
  return {{},
          "shellback: there is no help on " + in_quotes(topic) +
              choices_for(topic, known, "there is some on") + more,
          kBadInput};
}

}  // namespace

Reading read_command_line(const std::vector<std::string>& words) {
  Reading reading;
  CLI::App app{"Friction, film and temperature of oil-lubricated journal bearings", "shellback"};
  app.set_version_flag("--version", std::string("shellback ") + SHELLBACK_VERSION);
  app.require_subcommand(0, 1);
  for (const Offer& offer : kOffers) offer.add(app, reading.request);
  const std::string more = "\n\"shellback --help\" tells more.\n";
  if (const std::string unknown = unknown_command(words); !unknown.empty()) {
    return {{}, "shellback: " + unknown + more, kBadInput};
  }
  try {
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    for (const CLI::App* command : app.get_subcommands()) expect_values(*command);
  } catch (const CLI::CallForHelp&) {
    const auto chosen = app.get_subcommands();
    return {{}, chosen.empty() ? app.help() : chosen.front()->help(), kDone};
  } catch (const CLI::CallForVersion& version) {
    return {{}, std::string(version.what()) + "\n", kDone};
  } catch (const CLI::ParseError& error) {
    return {{}, "shellback: " + complaint(app, error) + more, kBadInput};
  }
  reading.request.command = command_of(app);
  if (reading.request.command == Command::none) return {{}, app.help(), kBadInput};
  if (reading.request.command == Command::help && reading.request.name != "keys") {
    return help_on(reading.request.name, more);
  }
  return reading;
}

}  // namespace shellback::program
