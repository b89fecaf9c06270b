#pragma once
/// Thermal load capability of the shells, new and run in.
///
/// Running-in: each shell wears under its full load at 2000 rpm for the time that its case has in
/// [running_in] (bearing/over_time/running_in.hpp), in the tier and on the cells of the capability.
///
/// Capability: the highest multiple of the load at each speed at which a periodic state exists, the
/// lining stays below its limit and the film above its own; what limits it. Between two loads the
/// limit stands where what it names (smallest film, temperature of the lining) goes through its
/// bound on the straight line over ln of the load. From the load itself the search goes outwards,
/// then to either side of that line's root until the loads that are borne and not are near enough;
/// then the root itself is tried. Its bar: by how much that moves it, and by how much the root of
/// the line through the same two loads moves on two thirds of the cells, with the same shape.
///
/// Limits of lining and film are assumptions told with the result. What is not found carries its
/// reason.
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "bearing/over_time/running_in_run.hpp"
#include "validation/shells/shells_case.hpp"
#include "validation/study_crew.hpp"

namespace shellback::validation {

/// A shell that has worn under its full load.
struct RunInShell {
  bearing::RunningInState begin, end;  ///< contact and film are extremes of the cycle
  bearing::Profile wear;               ///< what is gone
  Verdict verdict;
  bool tried = false;
  [[nodiscard]] bool good() const { return tried && verdict.good(); }
};

enum class ShellLimit { none, lining, film, state };
[[nodiscard]] const char* to_string(ShellLimit limit);

/// What a load came to.
struct LoadTried {
  double factor = 0.0;                                  ///< of the load; 0: none [-]
  double h = std::numeric_limits<double>::quiet_NaN();  ///< smallest film [m]
  double T = std::numeric_limits<double>::quiet_NaN();  ///< hottest lining [K]
};

/// The highest load that a shell bears at one speed.
struct Capability {
  int shell = 0;
  bearing::Tier tier = bearing::Tier::tehd;
  double rpm = 0.0;
  bool worn = false;  ///< run in before
  LoadTried good;     ///< largest that was borne
  LoadTried bad;      ///< smallest that was not
  double peak = 0.0;  ///< largest load of the cycle at `good` [N]
  /// Multiple of the load at which the limit is met, and what grid and line move it by; not a
  /// number: not known [-]
  double met = std::numeric_limits<double>::quiet_NaN();
  double met_error = std::numeric_limits<double>::quiet_NaN();
  ShellLimit limit = ShellLimit::none;  ///< what `bad` met
  std::string reason;                   ///< of a state that was not found
  bool tried = false;
};

/// Multiple of the load at which `limit` is met, `h_least` and `T_most` being its bounds: the root
/// of the straight line through two loads in (ln load, smallest film) or (ln load, temperature);
/// not a number where both say the same or one is not known.
[[nodiscard]] double load_met(ShellLimit limit, const LoadTried& a, const LoadTried& b,
                              double h_least, double T_most);

/// The next multiple of the load to be tried, from the largest that was borne and the smallest that
/// was not (0: none yet), `met` being where the limit stands between them (not a number: halves);
/// 0: they are within plan.width, or at an end of plan.factors.
[[nodiscard]] double next_load(const ShellsPlan& plan, const Capability& c, double met);

/// Runs shell `shell` in, as task `task` of the crew.
[[nodiscard]] RunInShell run_shell_in(const ShellsPlan& plan, const StudyCrew& crew, int task,
                                      int shell, bearing::Tier tier);

/// Finds the capability of c.shell at c.rpm in c.tier, with the shape of `wear` (null: as new), as
/// task `task` of the crew.
void find_capability(const ShellsPlan& plan, const StudyCrew& crew, int task,
                     const bearing::Profile* wear, Capability& c);

}  // namespace shellback::validation
