#pragma once
/// What the command line asks for, and the codes with which the program ends.
#include <string>
#include <vector>

namespace shellback::program {

/// How the program ends.
enum ExitCode : int {
  kDone = 0,           ///< done and converged
  kDefect = 1,         ///< an error inside the program, to be reported
  kBadInput = 2,       ///< the case or the command line is wrong
  kNotConverged = 3,   ///< or no steady state exists
  kBadFile = 4,        ///< a file could not be read or written
  kInterrupted = 130,  ///< by Ctrl-C or SIGTERM; what is finished is kept
};

enum class Command {
  none,
  init,
  check,
  run,
  compare,
  sweep,
  identify,
  chart,
  stress,
  study,
  surface,
  report,
  export_film,
  help,
  honesty,
  auto_honesty,
  validate,
};

/// What was asked for.
struct Request {
  Command command = Command::none;
  std::string name;                 ///< init: shipped case; study: which
  std::string case_file;            ///< surface: the height map; report, export: the result
  std::string tier;                 ///< --tier
  std::vector<std::string> tiers;   ///< --tiers
  std::vector<std::string> set;     ///< --set, each KEY=VALUE
  std::string json;                 ///< --json: file, "-" for standard output
  std::string output;               ///< -o
  bool force = false;               ///< --force: replace files that are no results
  std::string picture;              ///< --picture
  std::string page;                 ///< run --page
  std::string state;                ///< run --state
  bool resume = false;              ///< run --resume
  bool transient = false;           ///< run --transient
  bool running_in = false;          ///< run --running-in
  std::string vtu;                  ///< export --vtu: folder
  std::string profile;              ///< run --profile: the worn shape
  std::string from;                 ///< run --from: temperature of the walls
  std::string until;                ///< run --until: time
  std::vector<std::string> speeds;  ///< run --speeds: one after the other
  std::string hold;                 ///< run --hold: time for each of them
  double budget_s = 32.0;           ///< honesty, auto-honesty --budget: of a case [s]
  bool coefficients = false;        ///< --coefficients
  std::string coefficients_table;   ///< --coefficients-table
  std::string csv;                  ///< --csv: file, "-" for standard output
  std::string png;                  ///< --png
  int threads = 1;                  ///< -j
  bool quick = false;               ///< --quick: fewer or coarser
  std::vector<std::string> scenes;  ///< chart, stress: which; empty: all
  std::vector<std::string> vary;    ///< sweep --vary, each KEY=VALUES
  int cases = 200;                  ///< honesty, auto-honesty --cases
  int seed = 1;                     ///< honesty, auto-honesty --seed: of the first case
  int nodes = 7;                    ///< honesty --nodes: across the film of the truth
  bool known = true;                ///< honesty: shipped and validation cases as well
  std::vector<std::string> grids{"200x25"};  ///< honesty --grids
  std::string truth = "400x50";              ///< honesty --truth
  bool bars = false;                         ///< sweep --bars: of the physics left out as well
  bool no_bars = false;                      ///< sweep --no-bars
  int cores = 0;                             ///< sweep, identify, surface -j; 0: all there are
  std::string measured;                      ///< identify --measured
  std::vector<std::string> fit;              ///< identify --fit, each KEY or KEY,KEY
  std::vector<std::string> bounds;           ///< identify --bounds, each KEY=LOW:HIGH
  std::string motion = "x";                  ///< surface --motion
  int form = 2;                              ///< surface --form
  std::string fill;                          ///< surface --fill; empty: holes are refused
  std::vector<std::string> gaps;             ///< surface --gaps; empty: the usual ones
  std::string error;                         ///< surface --error: of Rq
  bool periodic = false;                     ///< surface --periodic
  std::string modulus;                       ///< surface --composite-modulus
  std::string hardness;                      ///< surface --hardness
  std::string table;                         ///< stress --table
  bool only_default = false;                 ///< stress --only-default
  double limit_s = 60.0;                     ///< stress --limit [s]
  std::vector<std::string> names;  ///< validate: ledger entries, help: sections, none: all; study
                                   ///< plan: cases, study run and others: the folder
  std::string ledger;              ///< validate --ledger: folder of entries; empty: the shipped
  std::string part;                ///< study run --part I/N
  int tasks = 0;                   ///< study submit --tasks; 0: one for each point
  std::vector<std::string> slurm;  ///< study submit --slurm: options of sbatch
  bool list = false;               ///< stress, validate: --list
  bool all_rows = false;           ///< validate --rows
};

/// Whether tables are printed: a file on standard output stands there alone.
[[nodiscard]] inline bool prints_tables(const Request& request) {
  return request.json != "-" && request.csv != "-";
}

}  // namespace shellback::program
