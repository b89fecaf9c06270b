#pragma once
/// Three shells in one big end, after Offner and Knaus, Lubricants 3 (2015): plain AlSn, grooved
/// AlSn, polymer-coated; 2000 rpm, full load.
///
///   1  each shell over the load cycle, with temperatures (tier tehd) and isothermal at the same
///      oil temperature: friction power of film and asperities, pressures, heat, temperatures. It
///      is torque times speed; what the load spends on squeezing the film is told beside it (with
///      it the sum is the cycle's power_loss)
///   2  the same, isothermal, with what the paper leaves open taken otherwise (shell_variants):
///   what
///      the order of the shells hangs on
///   3  parts of the boundary friction coefficient at the paper's operating point (its Table 4)
///   4  thermal load capability: the highest multiple of the load at each speed at which a periodic
///      state exists, the lining stays below its limit and the film above its own, by bisection of
///      the logarithm; what limits it. Between the last two loads the limit stands where what it
///      names (smallest film, temperature of the lining) goes through its bound on the straight
///      line over ln of the load; the same on two thirds of the cells gives its bar
///
/// The axial cells of the cases are graded: asperities of these shells rub at the edges, as the
/// paper says (its section 4.2), and even cells do not see them.
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

/// What the paper does not tell, or not in numbers, taken otherwise than the cases have it.
struct ShellVariant {
  const char* name;  ///< as shown
  /// Of the mouth of a drilling in the pin, ahead of the rod's axis in the direction of rotation
  /// when film and contact press hardest; not a number: oil comes through the shell [rad]
  double mouth;
  double warmer;  ///< oil, above that of the case [K]
};
inline constexpr int kVariants = 5;
/// The first is the case as it is, on the grid of the others. Section 4.2 of the paper: the mouth
/// of the pin's drilling stands 20 deg beside the rod's axis at the largest pressure, on a side
/// that is not told.
[[nodiscard]] const std::array<ShellVariant, kVariants>& shell_variants();
/// The case with it. Errors: InputError as of judge, from solving it.
[[nodiscard]] bearing::Case varied(bearing::Case c, const ShellVariant& variant);

struct ShellsPlan {
  std::array<int, 2> grid{100, 25};       ///< of the cycles
  std::array<int, 2> left_open{100, 13};  ///< of the variants
  std::array<int, 2> coarse{60, 9};       ///< of the capability
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
  [[nodiscard]] bool good() const { return tried && result.verdict.good(); }
  [[nodiscard]] double power() const { return film_power + asperity_power; }  ///< [W]
  /// Bars of the mean torque (grid and steps) at the mean speed; not a number: not known [W]
  [[nodiscard]] double power_error() const;
};

/// A shell at the instant at which film and contact press hardest; means are over the whole bore.
struct HardestInstant {
  double angle = 0.0;     ///< of the crank [deg]
  double pressure = 0.0;  ///< largest of the film and largest of the contact, together [Pa]
  double tau_film = 0.0;  ///< mean shear stress on the journal, of the film [Pa]
  double tau_asperity = 0.0;
  double friction = 0.0;  ///< mean friction power per area [W/m2]
  double heat = 0.0;      ///< mean heat flux into the shell; not a number: isothermal [W/m2]
  double T_shell = 0.0;   ///< highest of the lining's surface, like T_film [K]
  double T_film = 0.0;
};
[[nodiscard]] HardestInstant hardest_instant(const ShellCycle& cycle);

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
  LoadTried good;     ///< largest that was borne
  LoadTried bad;      ///< smallest that was not
  double peak = 0.0;  ///< largest load of the cycle at `good` [N]
  /// Multiple of the load at which the limit is met, and what the grid moves it by; not a number:
  /// not known [-]
  double met = std::numeric_limits<double>::quiet_NaN();
  double met_error = std::numeric_limits<double>::quiet_NaN();
  ShellLimit limit = ShellLimit::none;  ///< what `bad` met
  std::string reason;                   ///< of a state that was not found
  bool tried = false;
};

struct ShellsStudy {
  ShellsPlan plan;
  std::array<std::array<ShellCycle, 2>, kShells> cycles;            ///< tehd, isothermal
  std::array<std::array<ShellCycle, kShells>, kVariants> variants;  ///< isothermal, without bars
  std::array<solid::FrictionParts, kShells> parts;                  ///< at the paper's point [-]
  std::vector<Capability> capability;
  int threads = 1;
  double wall_s = 0.0;
  bool interrupted = false;
  [[nodiscard]] const Capability* at(int shell, bearing::Tier tier, double rpm) const;
  /// Cycles that were tried and not solved.
  [[nodiscard]] int count_failed() const;
};

/// Bars of grid and steps of the quantity `name` together; not a number: not known.
[[nodiscard]] double error_of(const bearing::CycleResult& r, const std::string& name);

/// Sets the powers of a cycle from its instants, by trapezia over time.
void add_powers(ShellCycle& cycle);

/// Smallest film of the capability: the combined roughness of the pair (textbook: below it film and
/// asperities share the load) [m].
[[nodiscard]] double least_film(const bearing::Case& c);

/// Parts of the coefficient where the contact presses with 10 MPa, oil of 0.01 Pa s, 10 m/s (the
/// paper's section 4.1).
[[nodiscard]] solid::FrictionParts parts_at_the_papers_point(const bearing::Case& c);

/// Multiple of the load at which `limit` is met, `h_least` and `T_most` being its bounds: the root
/// of the straight line through two loads in (ln load, smallest film) or (ln load, temperature);
/// not a number where both say the same or one is not known.
[[nodiscard]] double load_met(ShellLimit limit, const LoadTried& a, const LoadTried& b,
                              double h_least, double T_most);

/// Runs the study. Throws InputError where a shipped case does not read.
[[nodiscard]] ShellsStudy run_shells_study(const StudyOptions& options);
[[nodiscard]] ShellsStudy run_shells_study(const ShellsPlan& plan, const StudyOptions& options);

}  // namespace shellback::validation
