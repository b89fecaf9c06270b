#pragma once
/// Three shells in one big end, after Offner and Knaus, Lubricants 3 (2015): plain AlSn, grooved
/// AlSn, polymer-coated; 2000 rpm, full load.
///
///   1  each shell over the load cycle, with temperatures (tier tehd) and isothermal at the same
///      oil temperature: friction power of film and asperities, pressures, heat, temperatures. It
///      is torque times speed; what the load spends on squeezing the film is told beside it (with
///      it the sum is the cycle's power_loss)
///   2  parts of the boundary friction coefficient at the paper's operating point (its Table 4)
///   3  thermal load capability: the highest multiple of the load at each speed at which a periodic
///      state exists, the lining stays below its limit and the film above its own, by bisection of
///      the logarithm; what limits it
///
/// The paper's engine is not published: the engine is that of the case big-end. Limits of lining
/// and film are assumptions told with the result. Points that are not found carry their reason.
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "bearing/cycle.hpp"
#include "solid/boundary_friction.hpp"
#include "validation/study_crew.hpp"

namespace shellback::validation {

/// One of the shells, and what the paper has of it.
struct ShellKind {
  const char* name;                    ///< as shown
  const char* file;                    ///< shipped case
  std::array<double, 3> coefficients;  ///< Table 4: abrasive, adhesive, micro-hydrodynamic [-]
  double power;                        ///< Table 5 [W]
  double T_limit;                      ///< of the lining, assumed [K]
};
inline constexpr int kShells = 3;
[[nodiscard]] const std::array<ShellKind, kShells>& shell_kinds();

struct ShellsPlan {
  std::array<int, 2> grid{100, 13};  ///< of the cycles
  std::array<int, 2> coarse{60, 9};  ///< of the capability
  std::vector<double> rpm{1000.0, 2000.0, 3000.0};
  std::array<double, 2> factors{0.25, 4.0};  ///< multiples of the load between which is looked [-]
  int halvings = 5;
};
[[nodiscard]] ShellsPlan shells_plan(bool quick);

/// One shell over the cycle in one tier.
struct ShellCycle {
  bearing::Case input;
  bearing::CycleResult result;
  bool tried = false;
  double film_power = 0.0;      ///< mean viscous torque on the journal times its speed [W]
  double asperity_power = 0.0;  ///< the same of the asperities [W]
  double load_power = 0.0;      ///< mean work of the load on the moving journal, left out above [W]
};

enum class ShellLimit { none, lining, film, state };
[[nodiscard]] const char* to_string(ShellLimit limit);

/// The highest load that a shell bears at one speed.
struct Capability {
  int shell = 0;
  bearing::Tier tier = bearing::Tier::tehd;
  double rpm = 0.0;
  double good = 0.0;  ///< largest multiple that was borne; 0: none of those tried [-]
  double bad = 0.0;   ///< smallest that was not; 0: all were borne [-]
  double peak = 0.0;  ///< largest load of the cycle at `good` [N]
  double h_good = std::numeric_limits<double>::quiet_NaN();  ///< smallest film at `good` [m]
  double h_bad = std::numeric_limits<double>::quiet_NaN();   ///< and at `bad`, if it was found [m]
  ShellLimit limit = ShellLimit::none;                       ///< what `bad` met
  std::string reason;                                        ///< of a state that was not found
  bool tried = false;
};

struct ShellsStudy {
  ShellsPlan plan;
  std::array<std::array<ShellCycle, 2>, kShells> cycles;  ///< tehd, isothermal
  std::array<solid::FrictionParts, kShells> parts;        ///< at the paper's point [-]
  std::vector<Capability> capability;
  int threads = 1;
  double wall_s = 0.0;
  bool interrupted = false;
  [[nodiscard]] const Capability* at(int shell, bearing::Tier tier, double rpm) const;
  /// Cycles that were tried and not solved.
  [[nodiscard]] int count_failed() const;
};

/// Sets the powers of a cycle from its instants, by trapezia over time.
void add_powers(ShellCycle& cycle);

/// Smallest film of the capability: the combined roughness of the pair (textbook: below it film and
/// asperities share the load) [m].
[[nodiscard]] double least_film(const bearing::Case& c);

/// Parts of the coefficient where the contact presses with 10 MPa, oil of 0.01 Pa s, 10 m/s (the
/// paper's section 4.1).
[[nodiscard]] solid::FrictionParts parts_at_the_papers_point(const bearing::Case& c);

/// Runs the study. Throws InputError where a shipped case does not read.
[[nodiscard]] ShellsStudy run_shells_study(const StudyOptions& options);
[[nodiscard]] ShellsStudy run_shells_study(const ShellsPlan& plan, const StudyOptions& options);

}  // namespace shellback::validation
