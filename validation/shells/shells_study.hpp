#pragma once
/// Three shells in one big end, after Offner and Knaus, Lubricants 3 (2015): plain AlSn, grooved
/// AlSn, polymer-coated; 2000 rpm, full load.
///
///   1  each shell over the load cycle, with temperatures (tier tehd) and isothermal at the same
///      oil temperature: friction power of film and asperities, pressures, heat, temperatures. It
///      is torque times speed; what the load spends on squeezing the film is told beside it (with
///      it the sum is the cycle's power_loss)
///   2  the same, isothermal, with what the paper leaves open taken otherwise (shell_variants):
///      what the order of the shells hangs on
///   3  parts of the boundary friction coefficient at the paper's operating point (its Table 4)
///   4  running-in of each shell under its full load, and the thermal load capability of the new
///      and of the run-in shells (shells_capability.hpp)
///
/// The axial cells of the cases are graded: asperities of these shells rub at the edges, as the
/// paper says (its section 4.2), and even cells do not see them.
///
/// The paper's engine is not published: the engine is that of the case big-end. Limits of lining
/// and film are assumptions told with the result. Points that are not found carry their reason.
#include <array>
#include <string>
#include <vector>

#include "bearing/over_time/cycle.hpp"
#include "solid/boundary_friction.hpp"
#include "validation/shells/shells_capability.hpp"
#include "validation/study_crew.hpp"

namespace shellback::validation {

/// What the paper does not tell, or not in numbers, taken otherwise than the cases have it.
struct ShellVariant {
  const char* name;  ///< as shown
  /// Of the mouth of a drilling in the pin, ahead of the rod's axis in the direction of rotation
  /// when film and contact press hardest; not a number: oil comes through the shell [rad]
  double mouth;
  double warmer;  ///< oil, above that of the case [K]
  /// Of a coating whose material has a law of its own: it yields by seed 001 Eq. 6-12, as the
  /// paper's does, instead of staying elastic.
  bool flows;
};
inline constexpr int kVariants = 7;
/// The first is the case as it is, on the grid of the others. Section 4.2 of the paper: the mouth
/// of the pin's drilling stands 20 deg beside the rod's axis at the largest pressure, on a side
/// that is not told.
[[nodiscard]] const std::array<ShellVariant, kVariants>& shell_variants();
/// The case with it. Errors: InputError as of judge, from solving it.
[[nodiscard]] bearing::Case varied(bearing::Case c, const ShellVariant& variant);

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
  /// The same of the asperities' part [W]
  [[nodiscard]] double asperity_error() const;
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

struct ShellsStudy {
  ShellsPlan plan;
  std::array<std::array<ShellCycle, 2>, kShells> cycles;            ///< tehd, isothermal
  std::array<std::array<ShellCycle, kShells>, kVariants> variants;  ///< isothermal, without bars
  std::array<solid::FrictionParts, kShells> parts;                  ///< at the paper's point [-]
  std::array<std::array<RunInShell, 2>, kShells> run_in;            ///< tehd, isothermal
  std::vector<Capability> capability;
  int threads = 1;
  double wall_s = 0.0;
  bool interrupted = false;
  [[nodiscard]] const Capability* at(int shell, bearing::Tier tier, double rpm, bool worn) const;
  /// Cycles and runnings-in that were tried and not found.
  [[nodiscard]] int count_failed() const;
};

/// Bars of grid and steps of the quantity `name` together; not a number: not known.
[[nodiscard]] double error_of(const bearing::CycleResult& r, const std::string& name);

/// Sets the powers of a cycle: those of film and asperities from its instants, by trapezia over
/// time; what is left of its power_loss is the load's.
void add_powers(ShellCycle& cycle);

/// Parts of the coefficient where the contact presses with 10 MPa, oil of 0.01 Pa s, 10 m/s (the
/// paper's section 4.1).
[[nodiscard]] solid::FrictionParts parts_at_the_papers_point(const bearing::Case& c);

/// Pieces of work of the study, each of which keeps a state of its own.
[[nodiscard]] int count_pieces(const ShellsPlan& plan);

/// Runs the study. Throws InputError where a shipped case does not read.
[[nodiscard]] ShellsStudy run_shells_study(const StudyOptions& options);
[[nodiscard]] ShellsStudy run_shells_study(const ShellsPlan& plan, const StudyOptions& options);

}  // namespace shellback::validation
