#pragma once
/// What one solve gives: scalars, audit, effects, cost, fields. SI units, kelvin, radians.
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "bearing/case.hpp"
#include "bearing/coefficients.hpp"
#include "bearing/effect_kind.hpp"
#include "bearing/note.hpp"
#include "bearing/quantities.hpp"
#include "core/grid.hpp"
#include "core/outcome.hpp"

namespace shellback::bearing {

/// Scalars of one grid of the nested iteration, solved to its own tolerance.
struct LevelRecord {
  std::array<int, 2> grid{0, 0};
  std::vector<Quantity> quantities;
};

/// Relative imbalances; see docs/theory.md. Not-a-number: not applicable in this tier.
struct Audit {
  double mass = 0.0;
  double energy = 0.0;
  double load = 0.0;
  double moment = 0.0;
};

struct Effect {
  EffectKind kind = EffectKind::heating;
  bool included = false;
  double indicator = 0.0;  ///< the indicator number of the effect; NaN: not computed [-]
  /// Relative change of friction torque and smallest film by the effect; NaN: not estimated [-].
  double change_in_friction = std::numeric_limits<double>::quiet_NaN();
  double change_in_h_min = std::numeric_limits<double>::quiet_NaN();
};

struct Cost {
  double wall_s = 0.0;
  double setup_s = 0.0;  ///< part of wall_s spent on the solids' operators, once per geometry
  int factorizations = 0;
  int newton_iterations = 0;
  int outer_iterations = 0;
  double bars_s = 0.0;  ///< spent on the error bars, not part of wall_s
};

/// One recorded outer iteration.
struct HistoryEntry {
  std::string stage;
  double residual = 0.0;         ///< relative change of the iterate [-]
  double friction_torque = 0.0;  ///< [N m]
  double h_min = 0.0;            ///< [m]
};

/// A temperature at which the heat balance of the whole bearing is met (bearing/steady/lumped.hpp).
struct HeatRoot {
  double T = 0.0;                ///< [K]
  double slope = 0.0;            ///< of the residual, d r/d T [-]
  double friction_torque = 0.0;  ///< there [N m]
  double h_min = 0.0;            ///< there [m]
  [[nodiscard]] bool stable() const { return slope < 0.0; }
};

/// A limiter that acted, and how often.
struct LimiterCount {
  Limiter what = Limiter::rejected_steps;
  long count = 0;
};

/// Fields on the full-width grid. Empty vectors: not part of this tier.
struct Fields {
  FilmGrid grid;                ///< full width
  Field p;                      ///< film pressure, gauge [Pa]
  Field p_asperity;             ///< contact pressure [Pa]
  Field summit_flow;            ///< flow of summits at the hardness; empty: none [m]
  Field layer_depth;            ///< lasting, of an elasto-plastic layer; empty: none [m]
  Field theta;                  ///< fill ratio [-]
  Field h;                      ///< nominal gap [m], the depth of grooves included
  std::vector<char> supplied;   ///< 1 inside a supply feature
  std::vector<double> s;        ///< positions across the film y/h of T [-], 0 shell, 1 journal
  std::vector<double> T;        ///< film temperature, index cell * s.size() + k [K]
  Field T_mean;                 ///< flow-independent mean across the film [K]
  Field T_shell_surface;        ///< [K]
  Field T_shell_back;           ///< [K]
  std::vector<double> T_shaft;  ///< shaft surface temperature per axial cell [K]
  Field tau_journal;            ///< viscous shear stress that opposes a positive speed [Pa]
  Field tau_shell;              ///< viscous shear stress on the shell, along the motion [Pa]
  // Parts of the asperity shear stress, opposing the motion; empty without a friction law [Pa].
  Field tau_abrasive, tau_adhesive, tau_micro_hydrodynamic;
  Field elastic;              ///< elastic widening of the gap, shell and shaft [m]
  Field thermal_deformation;  ///< thermal widening of the gap, shell and shaft [m]
  /// Shell and housing temperature in the section z = 0: radii and values, index i * r.size() + k.
  std::vector<double> r;
  std::vector<double> T_solid;
};

/// How tier `auto` came to its choice.
struct AutoChoice {
  double tolerance = 0.0;           ///< asked for on friction torque and smallest film [-]
  bool met = false;                 ///< both bars are within it
  double bar_friction = 0.0;        ///< relative bar of the friction torque, grid and model [-]
  double bar_h_min = 0.0;           ///< relative bar of the smallest film [-]
  std::vector<std::string> solved;  ///< what was solved on the way
};

/// A supply of the case.
struct SupplyState {
  double flow = 0.0;  ///< into the film, net [m3/s]
  /// Of the oil in its vessel; not a number without film energy [K].
  double T_mixed = std::numeric_limits<double>::quiet_NaN();
};

struct Result {
  Verdict verdict;
  Tier tier = Tier::isothermal;
  std::string title;
  std::vector<Quantity> quantities;  ///< what the tier knows, with bars
  Audit audit;
  std::vector<SupplyState> supplies;  ///< in the order of the case
  std::vector<Effect> effects;
  std::vector<LimiterCount> limiters;
  std::vector<Note> warnings;
  std::vector<Note> assumptions;
  std::array<int, 2> grid{0, 0};
  Cost cost;
  std::vector<HistoryEntry> history;
  std::vector<HeatRoot> heat_roots;          ///< tier lumped: all that were found; the lowest
                                             ///< stable one is the solution
  std::optional<AutoChoice> choice;          ///< set if tier `auto` chose
  std::optional<Coefficients> coefficients;  ///< if the case asks for them
  std::vector<LevelRecord> levels;  ///< from the coarsest grid to the finest that converged
  Fields fields;

  /// Value of the quantity `name`, or not-a-number if this tier does not know it.
  [[nodiscard]] double value(const std::string& name) const { return value_in(quantities, name); }
  [[nodiscard]] bool has(const std::string& name) const {
    return quantity_in(quantities, name) != nullptr;
  }
  /// The same typed: `result.values().h_min`.
  [[nodiscard]] Quantities values() const { return typed(quantities); }
};

/// One step of the friction difference between two tiers.
struct FrictionStep {
  std::string name;     ///< "viscosity level", "viscosity variation", "clearance", ...
  double change = 0.0;  ///< of the friction torque [N m]
};

/// The friction difference between the isothermal prediction at the equivalent temperature and
/// the full one; the steps are substituted in the order given and add up to the difference.
struct FrictionSplit {
  double from = 0.0;  ///< isothermal friction torque [N m]
  double to = 0.0;    ///< full friction torque [N m]
  std::vector<FrictionStep> steps;
};

/// The equivalent temperature at which isothermal and full torque agree, and what was seen on the
/// way to it: the range of film temperatures and that of the isothermal torque over it.
struct Calibration {
  double T = NAN;                                           ///< [K]; NaN: none
  double coldest = INFINITY, warmest = -INFINITY;           ///< [K]
  double least_torque = INFINITY, most_torque = -INFINITY;  ///< [N m]
  [[nodiscard]] bool found() const { return std::isfinite(T); }
  [[nodiscard]] bool looked() const { return coldest <= warmest; }  ///< one film at least
};

/// All that `compare` shows.
struct Comparison {
  std::vector<Result> results;
  FrictionSplit split;      ///< empty `steps`: not both ends were computed
  Calibration calibration;  ///< `looked` where both ends were
};

}  // namespace shellback::bearing
