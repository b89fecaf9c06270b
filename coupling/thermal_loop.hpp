#pragma once
/// Film, heat and growth together: the fixed point over node temperatures and thermal growth.
///
/// One turn: viscosities from the temperatures -> film, position, elastic displacement in
/// equilibrium -> node flows and dissipation -> a few sweeps of the film energy -> heat into the
/// walls -> solids' temperatures (Robin-coupled) and growth. Fixed point by Anderson acceleration
/// (KINSOL); temperatures in units of 10 K, growth in clearances.
///
/// Where that does not settle, small steps towards the map's value follow from the best state on:
/// they go the way that the bearing itself goes in time, slowly. They reach a steady state that is
/// stable; where temperatures and friction rise for good instead, there is none, and the verdict
/// says so.
#include "coupling/control.hpp"
#include "coupling/film_heat.hpp"
#include "coupling/result.hpp"

namespace shellback::coupling {

struct ThermalOptions {
  int sweeps = 3;  ///< energy sweeps per turn (methods 3.4)
  int anderson_depth = 6;
  int max_turns = 50;       ///< accelerated; then as many again, slowly
  int most_newton = 1500;   ///< film iterations in all, from which slow steps are given up
  double tolerance = 3e-4;  ///< largest change per turn, in the units above [-]
  bool close = true;        ///< bring film and walls to balance at the end (false: coarse grids)
  bool patient = true;      ///< small steps where acceleration fails (false: give up at once)
  double runaway = 400.0;   ///< film temperature above the supply that is taken as runaway [K]
  EquilibriumOptions film;
};

/// Everything thermal at the last turn.
struct HeatState {
  Field growth;                    ///< thermal widening of the gap [m]; empty without growth
  Field T_shell;                   ///< bore temperature seen by the film [K]
  std::vector<double> T_shaft;     ///< journal temperature seen by the film, per axial cell [K]
  SolidTemperature solids;         ///< the solids' answer to the last heat
  thermal::EnergyBalance balance;  ///< of the film, solved part [W]
  double contact_heat = 0.0;       ///< asperity heat, whole bearing [W]
  std::vector<double> T_mix;       ///< of each supply patch [K]
  thermal::WallResponse response;  ///< of the film to its walls, refreshed in early turns
  long backflow_nodes = 0;
  long blended_columns = 0;
  double residual = 0.0;  ///< last change per turn [-]
  /// True once the film's heat has been balanced to the end.
  [[nodiscard]] bool known() const { return !T_mix.empty(); }
};

/// |ln| of the viscosity at the film's hottest place over that of the supplied oil: what heat has
/// done to the film.
[[nodiscard]] double viscosity_change(const BearingModel& model, const FilmEquilibrium& film);
/// From here on heat may be the reason why a film ends [-]: a fifth of the viscosity is gone.
inline constexpr double kHeatMatters = 0.2;

/// Starts from all temperatures at `T`.
[[nodiscard]] HeatState cold_heat(const BearingModel& model, double T);

/// Solves from `film` and `heat`, which hold the last turn whatever the verdict.
[[nodiscard]] Verdict solve_thermal(const BearingModel& model, const LoadTarget& target,
                                    const ThermalOptions& options, const SolveControl& control,
                                    FilmEquilibrium& film, HeatState& heat, EquilibriumCost& cost,
                                    std::vector<HistoryEntry>& history);

}  // namespace shellback::coupling
