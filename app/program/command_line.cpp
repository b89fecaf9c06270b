#include <fmt/format.h>

#include <algorithm>

#include "app/program/cli.hpp"
#include "app/program/complaint.hpp"
#include "app/program/option_parts.hpp"
#include "app/program/proof_options.hpp"
#include "app/reading/did_you_mean.hpp"
#include "surface/form.hpp"

namespace shellback::program {
namespace {

using namespace app;

const std::string kTierWords = "estimate, isothermal, lumped, thd, tehd or auto";

void add_solve_options(CLI::App& command, Request& request) {
  add_case_options(command, request);
  command
      .add_option("--json", request.json,
                  "also write the result as JSON; - is standard output, without the table")
      ->type_name("FILE");
  add_force(command, request);
  add_threads(command, request, "threads that may be used (this command works on one)");
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
  add_cores(*sweep, request, "threads");
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
  add_cores(*identify, request, "threads");
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
  add_cores(*surface, request, "gaps solved at the same time");
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
